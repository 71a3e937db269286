#include "models/read/gltf_check.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <vector>

#include "models/read/mesh_loader.h"

namespace dockyard {
namespace {

constexpr std::size_t kMaxNesting = 64;
constexpr long kMaxBytes = static_cast<long>(kMaxMeshBytes);
constexpr long kMaxCount = 3 * static_cast<long>(kMaxMeshTriangles);
constexpr long kMaxValues = 2000000;  // of the JSON text; geometry is in buffers
constexpr long kMaxElements =
    16000000;  // three vertices a triangle, with eight attributes, and more

/// Walks over a JSON text. A value is known by its path: the keys that lead to it, arrays passed
/// over: "nodes/children".
class GltfWalk {
 public:
  explicit GltfWalk(std::string_view json) : json_(json) {}

  std::string Run() {
    for (std::size_t at = 0; at < json_.size() && objection_.empty();) at = Step(at);
    if (objection_.empty() && !has_version_) objection_ = "no glTF document of version 2";
    if (objection_.empty()) CheckElements();
    if (objection_.empty()) CheckNodes();
    return objection_;
  }

 private:
  struct Level {
    bool object = false, expects_key = false;
    long item = 0;            // of an array
    std::string path, inner;  // of the value itself; of what stands in it
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

  void Open(bool object) {
    if (levels_.size() >= kMaxNesting) {
      Fail("nested deeper than 64 levels");
      return;
    }
    const std::string path = Path();
    levels_.push_back({object, object, 0, path, path});
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
    } else if (Path() == "asset/version") {
      has_version_ = text.substr(0, 2) == "2.";
      if (!has_version_) return Fail("no glTF document of version 2");
    }
    return objection_.empty() ? end + 1 : json_.size();
  }

  void Key(std::string_view key) {
    static const std::set<std::string, std::less<>> not_read{
        "sparse", "targets", "skins", "KHR_draco_mesh_compression", "EXT_meshopt_compression"};
    Level& level = levels_.back();
    level.expects_key = false;
    level.inner = level.path + (level.path.empty() ? "" : "/") + std::string(key.substr(0, 100));
    if (not_read.count(key) > 0) Fail("\"" + std::string(key) + "\", which is not read");
    const bool first = levels_.size() > 1 || top_keys_.insert(std::string(key)).second;
    if (!first) Fail("\"" + std::string(key.substr(0, 40)) + "\" given twice");
  }

  std::size_t Number(std::size_t at) {
    const std::size_t end = std::min(json_.find_first_not_of("+-.0123456789eE", at), json_.size());
    const std::string& path = Path();
    if (path.size() > 4) Take(path, json_.substr(at, end - at));
    return objection_.empty() ? end : json_.size();
  }

  void Take(const std::string& path, std::string_view text) {
    const auto starts = [&](std::string_view with) { return path.rfind(with, 0) == 0; };
    if (path == "accessors/count") {
      accessor_counts_[Item()] = Bounded(path, text, kMaxCount);
    } else if (path == "buffers/byteLength") {
      buffer_bytes_ += Bounded(path, text, kMaxBytes);
      if (buffer_bytes_ > 2 * kMaxBytes) Fail("more than 64 MiB of buffers");
    } else if (path == "bufferViews/byteLength") {
      view_bytes_[Item()] = Bounded(path, text, kMaxBytes);
    } else if (path == "bufferViews/byteOffset" || path == "bufferViews/byteStride" ||
               path == "accessors/byteOffset") {
      Bounded(path, text, kMaxBytes);
    } else if (path == "images/bufferView") {
      image_views_.push_back(Bounded(path, text, kMaxBytes));
    } else if (starts("meshes/primitives/attributes/") || path == "meshes/primitives/indices" ||
               starts("animations/samplers/")) {
      named_accessors_.push_back(Bounded(path, text, kMaxBytes));
    } else if (path == "nodes/children") {
      const long child = Bounded(path, text, kMaxBytes);
      if (!parents_.emplace(child, Item()).second) Fail("a node with two parents");
    } else if (path == "scenes/nodes") {
      if (!of_scene_.insert(Bounded(path, text, kMaxBytes)).second) Fail("a node given twice");
    }
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
    for (const long accessor : named_accessors_) elements += accessor_counts_[accessor];
    for (const long view : image_views_) image_bytes += view_bytes_[view];
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
  std::set<std::string> top_keys_;
  bool has_version_ = false;
  std::map<long, long> accessor_counts_, view_bytes_, parents_;
  std::vector<long> named_accessors_, image_views_;
  std::set<long> of_scene_;
  long buffer_bytes_ = 0, values_ = 0;
};

}  // namespace

std::string GltfObjection(std::string_view json) { return GltfWalk(json).Run(); }

}  // namespace dockyard
