#include "models/read/gltf_document.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

#include "models/read/config_error.h"
#include "models/read/gltf_uri.h"
#include "models/read/mesh_limits.h"
#include "models/read/text_file.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

std::string Named(const std::string& list, long at) {
  return list + "[" + std::to_string(at) + "]";
}

}  // namespace

GltfDocument::GltfDocument(fs::path file, std::string_view bytes, bool binary)
    : file_(std::move(file)) {
  Parse(binary ? TakeChunks(bytes) : bytes);
  const json& version = root_.value("asset", json::object()).value("version", json());
  if (!version.is_string() || !version.get<std::string>().starts_with("2.")) {
    Refuse("no glTF document of version 2");
  }
}

void GltfDocument::Refuse(const std::string& why) const {
  throw ConfigError(file_.string() + ": not a usable mesh: " + why);
}

/// A header of 12 bytes, then chunks, each with its length and type before it: JSON first, then
/// the buffer. Gives the JSON.
std::string_view GltfDocument::TakeChunks(std::string_view bytes) {
  std::vector<std::pair<std::string_view, std::string_view>> chunks;  // type and content
  const bool header = bytes.size() >= 12 && bytes.starts_with("glTF") &&
                      NumberAt<std::uint32_t>(bytes, 4) == 2 &&
                      NumberAt<std::uint32_t>(bytes, 8) == bytes.size();
  std::size_t at = 12;
  while (header && bytes.size() - at >= 8) {
    const std::size_t length = NumberAt<std::uint32_t>(bytes, at);
    if (length % 4 != 0 || length > bytes.size() - at - 8) break;
    chunks.emplace_back(bytes.substr(at + 4, 4), bytes.substr(at + 8, length));
    at += 8 + length;
  }
  if (chunks.empty() || at != bytes.size() || chunks[0].first != "JSON") {
    Refuse("no binary glTF 2.0 file of the length that its header states");
  }
  if (chunks.size() > 1 && chunks[1].first.starts_with("BIN")) own_ = chunks[1].second;
  return chunks[0].second;
}

void GltfDocument::Parse(std::string_view text) {
  std::vector<std::set<std::string>> keys;
  const auto check = [&](int, json::parse_event_t event, json& value) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(value).second) {
      Refuse(value.dump() + " given twice");
    }
    return true;
  };
  try {
    root_ = json::parse(text, check);
  } catch (const json::exception& error) {
    Refuse(std::string("no glTF document: ") + error.what());
  }
  if (!root_.is_object() || !root_.contains("asset")) Refuse("no glTF document");
}

long GltfDocument::Whole(const json& of, const char* key, long fallback) const {
  const auto found = of.find(key);
  if (found == of.end() && fallback >= 0) return fallback;
  if (found != of.end() && found->is_number_unsigned() && *found <= 4 * kMaxMeshBytes) {
    return found->get<long>();
  }
  Refuse(std::string(key) + ": expected a whole number from 0 to " +
         std::to_string(4 * kMaxMeshBytes) + ", found " +
         (found == of.end() ? "none" : found->dump().substr(0, 40)));
}

const json& GltfDocument::List(const json& of, const char* key) const {
  static const json none = json::array();
  const auto found = of.find(key);
  if (found == of.end()) return none;
  if (!found->is_array()) Refuse(std::string(key) + ": expected a list");
  return *found;
}

const json& GltfDocument::Item(const std::string& list, long at) const {
  const json& items = List(root_, list.c_str());
  if (at < static_cast<long>(items.size()) && items[static_cast<std::size_t>(at)].is_object()) {
    return items[static_cast<std::size_t>(at)];
  }
  Refuse("expected " + Named(list, at) + " to be there");
}
void GltfDocument::RefuseExtensions(const json& of) const {
  for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression"}) {
    if (of.value("extensions", json::object()).contains(name)) {
      Refuse('"' + std::string(name) + "\", which is not read");
    }
  }
}

std::string_view GltfDocument::Buffer(long at) {
  const auto known = buffers_.find(at);
  if (known != buffers_.end()) return known->second;
  const json& buffer = Item("buffers", at);
  const auto length = static_cast<std::size_t>(Whole(buffer, "byteLength"));
  std::string& bytes = buffers_[at];
  if (buffer.contains("uri")) {
    bytes = Content(buffer["uri"].get<std::string>());
  } else if (at == 0) {
    bytes = own_;
  }
  if (bytes.size() < length) {
    Refuse(Named("buffers", at) + ".byteLength: expected at most the " +
           std::to_string(bytes.size()) + " bytes that it has");
  }
  bytes.resize(length);
  return bytes;
}

std::string GltfDocument::Content(const std::string& uri) const {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    if (comma != std::string::npos && uri.substr(0, comma).ends_with(";base64")) {
      if (auto bytes = FromBase64(std::string_view(uri).substr(comma + 1))) return *bytes;
    }
    Refuse("uri: expected data in base64");
  }
  const auto name = BufferNameOf(uri);
  if (!name) {
    Refuse("uri: expected the name of a .bin file in the mesh's own folder, found '" +
           uri.substr(0, 40) + "'");
  }
  const fs::path path = file_.parent_path() / *name;
  std::error_code error;
  if (fs::symlink_status(path, error).type() != fs::file_type::regular) {
    Refuse("uri: expected a file beside the mesh, found no '" + *name + "'");
  }
  return ReadBytes(path, kMaxMeshBytes);
}

GltfElements GltfDocument::Accessor(long at, const char* type,
                                    const std::map<long, std::size_t>& sizes, std::size_t parts) {
  const json& accessor = Item("accessors", at);
  if (accessor.contains("sparse")) Refuse("\"sparse\", which is not read");
  GltfElements of;
  of.count = static_cast<std::size_t>(Whole(accessor, "count"));
  of.component = Whole(accessor, "componentType");
  const auto size = sizes.find(of.component);
  if (accessor.value("type", json()) != type || size == sizes.end()) {
    Refuse(Named("accessors", at) + ": expected a " + type + " of " +
           (parts == 3 ? "floats" : "whole numbers without sign"));
  }
  const std::size_t element = parts * size->second;
  const long in = Whole(accessor, "bufferView");
  const json& view = Item("bufferViews", in);
  RefuseExtensions(view);
  const auto offset = static_cast<std::size_t>(Whole(view, "byteOffset", 0)),
             length = static_cast<std::size_t>(Whole(view, "byteLength")),
             from = static_cast<std::size_t>(Whole(accessor, "byteOffset", 0));
  const std::string_view buffer = Buffer(Whole(view, "buffer"));
  if (offset + length > buffer.size()) {
    Refuse(Named("bufferViews", in) + ": expected all within the buffer's " +
           std::to_string(buffer.size()) + " bytes");
  }
  const auto stride = static_cast<std::size_t>(Whole(view, "byteStride", 0));
  of.stride = stride == 0 ? element : stride;
  if (of.stride < element) {
    Refuse(Named("bufferViews", in) + ".byteStride: expected 0 or at least " +
           std::to_string(element));
  }
  if (of.count > 0 && from + (of.count - 1) * of.stride + element > length) {
    Refuse(Named("accessors", at) + ": expected all within the view's " + std::to_string(length) +
           " bytes");
  }
  of.bytes = buffer.substr(offset).substr(std::min(from, length));
  return of;
}

}  // namespace dockyard
