#include "models/read/gltf_check.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <vector>

#include "models/read/gltf_layout.h"
#include "models/read/gltf_uri.h"
#include "models/read/mesh_loader.h"

namespace dockyard {
namespace {

constexpr std::size_t kMaxNesting = 64;
constexpr long kMaxBytes = static_cast<long>(kMaxMeshBytes);
constexpr long kMaxCount = 3 * static_cast<long>(kMaxMeshTriangles);
constexpr long kMaxMode = 6;          // triangle fans
constexpr long kMaxValues = 2000000;  // of the JSON text; geometry is in buffers
constexpr long kMaxElements =
    16000000;  // three vertices a triangle, with eight attributes, and more

/// Walks over a JSON text. A value is known by its path: the keys that lead to it, arrays passed
/// over: "nodes/children".
class GltfWalk {
 public:
  explicit GltfWalk(std::string_view json) : json_(json) {}

  GltfFindings Run(std::size_t own_bytes) {
    for (std::size_t at = 0; at < json_.size() && objection_.empty();) at = Step(at);
    if (objection_.empty() && !has_version_) objection_ = "no glTF document of version 2";
    if (objection_.empty()) CheckElements();
    if (objection_.empty()) CheckNodes();
    if (objection_.empty()) objection_ = LayoutObjection(layout_, own_bytes);
    return {objection_, objection_.empty() ? TrianglesOf(layout_) : 0};
  }

 private:
  struct Level {
    bool object = false, expects_key = false;
    long item = 0;                            // of an array
    std::string path, inner;                  // of the value itself; of what stands in it
    std::set<std::string, std::less<>> keys;  // of an object
  };

  std::size_t Step(std::size_t at) {
    const char c = json_[at];
    if (c == '{' || c == '[') {
      Open(c == '{');
    } else if (c == '}' || c == ']') {
      if (levels_.empty()) return Fail("brackets that close nothing");
      levels_.pop_back();
    } else if (c == ',') {
      if (++values_ > kMaxValues) return Fail("more than 2 million values of JSON");
      if (!levels_.empty()) {
        levels_.back().expects_key = levels_.back().object;
        ++levels_.back().item;
      }
    } else if (c == '"') {
      return String(at);
    } else if (c == '-' || (c >= '0' && c <= '9')) {
      return Number(at);
    }
    return at + 1;
  }

  std::size_t Fail(std::string what) {
    objection_ = std::move(what);
    return json_.size();
  }

  const std::string& Path() const {
    static const std::string none;
    return levels_.empty() ? none : levels_.back().inner;
  }
  /// The place in the array that a key of the document holds, such as "nodes".
  long Item() const { return levels_.size() > 1 ? levels_[1].item : 0; }

  /// The primitive that the walk is in: document, list of meshes, mesh, list of primitives.
  GltfLayout::Primitive& Primitive() {
    return layout_.primitives[{Item(), levels_.size() > 3 ? levels_[3].item : 0}];
  }

  void Open(bool object) {
    if (levels_.size() >= kMaxNesting) {
      Fail("nested deeper than 64 levels");
      return;
    }
    const std::string path = Path();
    levels_.push_back({object, object, 0, path, path, {}});
    if (path == "scenes" && object) of_scene_.clear();
  }

  std::size_t String(std::size_t at) {
    std::size_t end = at + 1;
    bool escaped = false;
    while (end < json_.size() && json_[end] != '"') {
      escaped = escaped || json_[end] == '\\';
      end += json_[end] == '\\' ? 2 : 1;
    }
    if (end >= json_.size()) return Fail("a string without its end");
    const std::string_view text = json_.substr(at + 1, end - at - 1);
    if (!levels_.empty() && levels_.back().expects_key) {
      if (escaped) return Fail("a key with a backslash");
      Key(text);
    } else {
      Word(text);
    }
    return objection_.empty() ? end + 1 : json_.size();
  }

  /// A value that is a string.
  void Word(std::string_view text) {
    const std::string& path = Path();
    if (path == "asset/version") {
      has_version_ = text.substr(0, 2) == "2.";
      if (!has_version_) Fail("no glTF document of version 2");
    } else if (path == "accessors/type") {
      layout_.accessors[Item()].type = std::string(text.substr(0, 100));
    } else if (path == "buffers/uri") {
      layout_.buffers[Item()].elsewhere = true;
      if (!IsBeside(text)) {
        Fail("buffers/uri: expected the name of a .bin file in the mesh's own folder, found '" +
             std::string(text.substr(0, 40)) + "'");
      }
    }
  }

  /// Whether an address is data, or a name in the mesh's own folder: given a path, assimp takes the
  /// file of that name next to the mesh, which is another one.
  static bool IsBeside(std::string_view uri) {
    return uri.substr(0, 5) == "data:" || BufferNameOf(uri).has_value();
  }

  void Key(std::string_view key) {
    static const std::set<std::string, std::less<>> not_read{
        "sparse", "targets", "skins", "KHR_draco_mesh_compression", "EXT_meshopt_compression"};
    Level& level = levels_.back();
    level.expects_key = false;
    level.inner = level.path + (level.path.empty() ? "" : "/") + std::string(key.substr(0, 100));
    if (not_read.count(key) > 0) Fail("\"" + std::string(key) + "\", which is not read");
    // Of two the importer takes the first, and this walk the last.
    if (!level.keys.insert(std::string(key)).second)
      Fail("\"" + std::string(key.substr(0, 40)) + "\" given twice");
  }

  std::size_t Number(std::size_t at) {
    const std::size_t end = std::min(json_.find_first_not_of("+-.0123456789eE", at), json_.size());
    const std::string& path = Path();
    if (path.size() > 4) Take(path, json_.substr(at, end - at));
    return objection_.empty() ? end : json_.size();
  }

  void Take(const std::string& path, std::string_view text) {
    const auto starts = [&](std::string_view with) { return path.rfind(with, 0) == 0; };
    if (starts("accessors/")) {
      TakeAccessor(path, text);
    } else if (starts("bufferViews/")) {
      TakeView(path, text);
    } else if (path == "buffers/byteLength") {
      layout_.buffers[Item()].bytes = Bounded(path, text, kMaxBytes);
      buffer_bytes_ += layout_.buffers[Item()].bytes;
      if (buffer_bytes_ > 2 * kMaxBytes) Fail("more than 64 MiB of buffers");
    } else if (path == "meshes/primitives/mode") {
      Primitive().mode = Bounded(path, text, kMaxMode);
    } else if (path == "images/bufferView") {
      image_views_.push_back(Bounded(path, text, kMaxBytes));
    } else if (starts("meshes/primitives/attributes/") || path == "meshes/primitives/indices" ||
               starts("animations/samplers/")) {
      named_accessors_.push_back(Bounded(path, text, kMaxBytes));
      const long accessor = named_accessors_.back();
      if (path == "meshes/primitives/indices") Primitive().indices = accessor;
      if (path == "meshes/primitives/attributes/POSITION") Primitive().positions = accessor;
    } else if (path == "nodes/children") {
      const long child = Bounded(path, text, kMaxBytes);
      if (!parents_.emplace(child, Item()).second) Fail("a node with two parents");
    } else if (path == "scenes/nodes") {
      if (!of_scene_.insert(Bounded(path, text, kMaxBytes)).second) Fail("a node given twice");
    }
  }

  void TakeAccessor(const std::string& path, std::string_view text) {
    GltfLayout::Accessor& accessor = layout_.accessors[Item()];
    if (path == "accessors/count") accessor.count = Bounded(path, text, kMaxCount);
    if (path == "accessors/bufferView") accessor.view = Bounded(path, text, kMaxBytes);
    if (path == "accessors/byteOffset") accessor.offset = Bounded(path, text, kMaxBytes);
    if (path == "accessors/componentType") accessor.component = Bounded(path, text, kMaxBytes);
  }
  void TakeView(const std::string& path, std::string_view text) {
    GltfLayout::View& view = layout_.views[Item()];
    if (path == "bufferViews/buffer") view.buffer = Bounded(path, text, kMaxBytes);
    if (path == "bufferViews/byteLength") view.bytes = Bounded(path, text, kMaxBytes);
    if (path == "bufferViews/byteOffset") view.offset = Bounded(path, text, kMaxBytes);
    if (path == "bufferViews/byteStride") view.stride = Bounded(path, text, kMaxBytes);
  }

  /// The number, or 0 and an objection when it is not a whole one from 0 to `most`.
  long Bounded(const std::string& path, std::string_view text, long most) {
    long value = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (whole && value >= 0 && value <= most) return value;
    Fail(path + ": expected a whole number from 0 to " + std::to_string(most) + ", found '" +
         std::string(text.substr(0, 40)) + "'");
    return 0;
  }

  /// Each naming of an accessor or of an image's bytes makes a copy of them.
  void CheckElements() {
    long elements = 0, image_bytes = 0;
    for (const long accessor : named_accessors_) {
      const auto named = layout_.accessors.find(accessor);
      elements += named == layout_.accessors.end() ? 0 : named->second.count;
    }
    for (const long view : image_views_) {
      const auto named = layout_.views.find(view);
      image_bytes += named == layout_.views.end() ? 0 : named->second.bytes;
    }
    if (elements > kMaxElements) Fail("more than 16 million elements over all accessors named");
    if (image_bytes > kMaxBytes) Fail("more than 32 MiB of images");
  }

  void CheckNodes() {
    for (const auto& [child, parent] : parents_) {
      long node = child;
      std::size_t depth = 0;
      for (auto at = parents_.find(node); at != parents_.end(); at = parents_.find(node)) {
        node = at->second;
        if (++depth <= kMaxNesting) continue;
        Fail("nodes in a circle or nested deeper than 64 levels");
        return;
      }
    }
  }

  std::string_view json_;
  std::string objection_;
  std::vector<Level> levels_;
  bool has_version_ = false;
  GltfLayout layout_;
  std::map<long, long> parents_;
  std::vector<long> named_accessors_, image_views_;
  std::set<long> of_scene_;
  long buffer_bytes_ = 0, values_ = 0;
};

}  // namespace

GltfFindings CheckGltf(std::string_view json, std::size_t own_bytes) {
  return GltfWalk(json).Run(own_bytes);
}

}  // namespace dockyard
