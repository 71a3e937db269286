// A glTF 2.0 document: its lists, and the numbers of its accessors, each within its buffer.
#pragma once

#include <cstring>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace dockyard {

/// The number of any type at a byte.
template <class T>
T NumberAt(std::string_view bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// The elements of one accessor.
struct GltfElements {
  std::string_view bytes;  // from the first on
  std::size_t count = 0, stride = 0;
  long component = 0;
};

class GltfDocument {
 public:
  /// As ReadGltf.
  GltfDocument(std::filesystem::path file, std::string_view bytes, bool binary);

  [[noreturn]] void Refuse(const std::string& why) const;
  const nlohmann::json& root() const { return root_; }
  /// A whole number from 0 on; `fallback` stands for a missing one, -1: it must be there.
  long Whole(const nlohmann::json& of, const char* key, long fallback = -1) const;
  /// The list under a key, empty when there is none.
  const nlohmann::json& List(const nlohmann::json& of, const char* key) const;
  /// An object of a list of the document.
  const nlohmann::json& Item(const std::string& list, long at) const;
  void RefuseExtensions(const nlohmann::json& of) const;
  /// @param sizes  bytes of the component types that may be
  /// @param parts  numbers of an element
  GltfElements Accessor(long at, const char* type, const std::map<long, std::size_t>& sizes,
                        std::size_t parts);

 private:
  std::string_view TakeChunks(std::string_view bytes);
  void Parse(std::string_view text);
  std::string_view Buffer(long at);
  std::string Content(const std::string& uri) const;

  std::filesystem::path file_;
  std::string own_;  // the buffer in a .glb file
  nlohmann::json root_;
  std::map<long, std::string> buffers_;
};

}  // namespace dockyard
