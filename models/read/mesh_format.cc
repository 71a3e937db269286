#include "models/read/mesh_format.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>
#include <utility>

#include "models/read/collada_check.h"
#include "models/read/config_error.h"
#include "models/read/mesh_limits.h"
#include "models/read/obj_text.h"
#include "models/read/text_file.h"
#include "models/read/text_mesh_check.h"

namespace dockyard {
namespace {

constexpr std::size_t kMaxObjParts = 10000;

std::string LowerCase(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::optional<MeshFormat> FormatByExtension(const std::filesystem::path& file) {
  const std::string extension = LowerCase(file.extension().string());
  if (extension == ".stl") return MeshFormat::kStl;
  if (extension == ".obj") return MeshFormat::kObj;
  if (extension == ".dae") return MeshFormat::kDae;
  if (extension == ".gltf") return MeshFormat::kGltf;
  if (extension == ".glb") return MeshFormat::kGlb;
  return std::nullopt;
}

std::uint32_t LittleEndian32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  }
  return value;
}

/// Binary STL: 80 bytes of header, a count, 50 bytes a triangle (3D Systems, 1989).
bool IsBinaryStl(std::string_view bytes) {
  if (bytes.size() < 84) return false;
  const std::uint64_t triangles = LittleEndian32(bytes, 80);
  return triangles > 0 && bytes.size() == 84 + 50 * triangles;
}

std::string_view SkipSpace(std::string_view text) {
  const std::size_t at = text.find_first_not_of(" \t\r\n");
  return at == std::string_view::npos ? std::string_view() : text.substr(at);
}

/// Whether a line of the text begins with the letter and a space.
bool HasLineOf(std::string_view text, char letter) {
  return text.find(std::string{letter, ' '}) != std::string_view::npos ||
         text.find(std::string{letter, '\t'}) != std::string_view::npos;
}

/// Lines of an OBJ text that open an object, group or material: assimp compares each with all.
std::size_t CountObjParts(std::string_view text) {
  std::size_t parts = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n\\", at), text.size());
    const std::string_view line = text.substr(begin, 7);
    const bool named = line.size() > 1 && (line[1] == ' ' || line[1] == '\t');
    if ((named && (line[0] == 'o' || line[0] == 'g')) || line.substr(0, 6) == "usemtl") ++parts;
    at = std::min(text.find_first_of("\r\n", begin), text.size());
  }
  return parts;
}

/// STL in text, in capitals or not: some facet follows the word "solid".
bool IsTextStl(std::string_view text) {
  if (LowerCase(text.substr(0, 5)) != "solid") return false;
  const std::string_view facet = "facet";
  return std::search(text.begin(), text.end(), facet.begin(), facet.end(), [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         }) != text.end();
}

/// Why no importer is asked; glTF has a reader of its own.
std::string Objection(MeshFormat format, std::string_view bytes) {
  const std::string_view text = SkipSpace(bytes);
  switch (format) {
    case MeshFormat::kStl:
      if (IsBinaryStl(bytes)) return {};
      if (IsTextStl(text)) return {};
      return "neither a binary STL file of the length that its header states nor one in text";
    case MeshFormat::kObj:
      if (!HasLineOf(text, 'v') || !HasLineOf(text, 'f')) {
        return "an OBJ file without vertices or faces";
      }
      if (CountObjParts(text) > kMaxObjParts) {
        return "more than 10000 objects, groups and changes of material";
      }
      return {};
    case MeshFormat::kDae:
      if (text.substr(0, 1) != "<" || text.find("<COLLADA") == std::string_view::npos) {
        return "no Collada document";
      }
      if (text.find("<!DOCTYPE") != std::string_view::npos) return "a document with a DOCTYPE";
      return {};
    case MeshFormat::kGltf:
    case MeshFormat::kGlb:
      return {};
  }
  return "of no known format";
}

}  // namespace

bool IsMeshFile(const std::filesystem::path& file) { return FormatByExtension(file).has_value(); }

MeshStatement CheckMeshFormat(const std::filesystem::path& file, std::string bytes) {
  const std::optional<MeshFormat> format = FormatByExtension(file);
  const std::string name = file.string();
  if (!format) {
    throw ConfigError(
        name + ": expected a mesh file (.stl, .obj, .dae, .gltf or .glb), found extension '" +
        file.extension().string() + "'");
  }
  const bool text = *format == MeshFormat::kObj || *format == MeshFormat::kDae ||
                    *format == MeshFormat::kGltf ||
                    (*format == MeshFormat::kStl && !IsBinaryStl(bytes));
  if (text) {
    RefuseWideText(bytes, name);
    bytes.erase(0, bytes.size() - WithoutByteOrderMark(bytes).size());
  }
  const std::string objection = Objection(*format, bytes);
  if (!objection.empty()) throw ConfigError(name + ": not a usable mesh: " + objection);
  if (text) CheckIsText(bytes, name);
  if (*format == MeshFormat::kObj) bytes = SimplifiedObj(bytes, name);
  if (*format == MeshFormat::kStl && text) bytes = CheckedStl(bytes, name);
  if (*format == MeshFormat::kDae) bytes = CheckedCollada(bytes, name);
  return {*format, std::move(bytes)};
}

}  // namespace dockyard
