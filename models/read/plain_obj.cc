#include "models/read/plain_obj.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "controller/base/number_text.h"
#include "models/read/mesh_limits.h"

namespace dockyard {
namespace {

using Place = std::array<float, 3>;

/// The line's words after the first, if there are three; none otherwise.
std::optional<std::array<std::string_view, 3>> ThreeWords(std::string_view line) {
  std::array<std::string_view, 3> words;
  std::size_t at = 1;
  for (std::string_view& word : words) {
    const std::size_t begin = line.find_first_not_of(" \t", at);
    if (begin == at || begin == std::string_view::npos) return std::nullopt;
    at = std::min(line.find_first_of(" \t", begin), line.size());
    word = line.substr(begin, at - begin);
  }
  if (line.find_first_not_of(" \t", at) != std::string_view::npos) return std::nullopt;
  return words;
}

std::optional<Place> PlaceIn(std::string_view line) {
  const auto words = ThreeWords(line);
  if (!words) return std::nullopt;
  Place place;
  for (std::size_t i = 0; i < 3; ++i) {
    double value = 0.0;
    if (!ParseNumber((*words)[i], value) || std::abs(value) > kMaxMeshCoordinate_m) {
      return std::nullopt;
    }
    place[i] = static_cast<float>(value);
  }
  return place;
}

/// Counted from 0; each is below `count`.
std::optional<std::array<std::size_t, 3>> CornersIn(std::string_view line, std::size_t count) {
  const auto words = ThreeWords(line);
  if (!words) return std::nullopt;
  std::array<std::size_t, 3> corners;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::string_view word = (*words)[i];
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    if (number < 1 || number > count) return std::nullopt;
    corners[i] = number - 1;
  }
  return corners;
}

class Builder {
 public:
  /// False where the line is none of a plain file.
  bool Take(std::string_view line) {
    if (line.empty() || line[0] == '#') return true;
    if (line.size() < 2 || (line[1] != ' ' && line[1] != '\t')) return false;
    if (line[0] == 'o') return ++objects_ == 1;  // the importer makes a mesh of each
    if (line[0] == 'v') return TakePlace(line);
    return line[0] == 'f' && TakeTriangle(line);
  }
  TriangleMesh mesh;

 private:
  bool TakePlace(std::string_view line) {
    const std::optional<Place> place = PlaceIn(line);
    if (!place || places_.size() >= 3 * kMaxMeshTriangles) return false;
    places_.push_back(*place);
    return true;
  }
  bool TakeTriangle(std::string_view line) {
    const auto corners = CornersIn(line, places_.size());
    if (!corners || mesh.triangles.size() >= kMaxMeshTriangles) return false;
    std::array<std::uint32_t, 3> triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const Place& place = places_[(*corners)[i]];
      const auto [at, is_new] = vertices_.emplace(place, mesh.vertices.size());
      if (is_new) mesh.vertices.emplace_back(place[0], place[1], place[2]);
      triangle[i] = at->second;
    }
    mesh.triangles.push_back(triangle);
    return true;
  }

  int objects_ = 0;
  std::vector<Place> places_;
  std::map<Place, std::uint32_t> vertices_;
};

}  // namespace

std::optional<TriangleMesh> PlainObj(std::string_view text) {
  Builder builder;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, length);
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.ends_with('\\') || !builder.Take(line)) return std::nullopt;
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  if (builder.mesh.triangles.empty()) return std::nullopt;
  return std::move(builder.mesh);
}

}  // namespace dockyard
