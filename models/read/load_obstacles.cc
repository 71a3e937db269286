#include "models/read/load_obstacles.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

#include "models/read/config_error.h"
#include "models/read/csv_table.h"
#include "models/read/near_names.h"

namespace dockyard {
namespace {

const std::vector<std::string> kDiscKeys{"x_m", "y_m", "radius_m"};
constexpr double kFarthest_m = 1e3;
constexpr std::size_t kMostAreas = 1000, kMostCorners = 100;
// A map of rocks from orbit; in plan some 20 MB.
constexpr std::size_t kMostObstacleDiscs = 100'000;
constexpr std::size_t kMostCsvBytes = std::size_t{16} << 20;  // 160 bytes a disc

// By the shoelace formula, without sign.
double AreaOf(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0, last = polygon.size() - 1; i < polygon.size(); last = i++) {
    twice += polygon[last].x() * polygon[i].y() - polygon[last].y() * polygon[i].x();
  }
  return 0.5 * std::abs(twice);
}

Disc ReadObstacleDisc(const YamlNode& node, const std::string& path) {
  const YamlReader disc(node, path, kDiscKeys);
  return {ReadPlace(disc), disc.Number("radius_m", Positive(kFarthest_m))};
}

bool IsCsvFile(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".csv";
}

// A disc a row.
Obstacles LoadDiscs(const std::string& file) {
  const YamlNode table = LoadCsv(file, kMostCsvBytes);
  if (table.items.size() > kMostObstacleDiscs) {
    throw ConfigError(table.items[kMostObstacleDiscs].place.Text() + ": expected at most " +
                      std::to_string(kMostObstacleDiscs) + " discs, found " +
                      std::to_string(table.items.size()) +
                      "; leave out those that the rover cannot reach");
  }
  Obstacles obstacles;
  obstacles.discs.reserve(table.items.size());
  for (std::size_t i = 0; i < table.items.size(); ++i) {
    obstacles.discs.push_back(ReadObstacleDisc(table.items[i], "row " + std::to_string(i + 1)));
  }
  return obstacles;
}

}  // namespace

Eigen::Vector2d ReadPlace(const YamlReader& in) {
  const Range range = Between(-kFarthest_m, kFarthest_m);
  return {in.Number("x_m", range), in.Number("y_m", range)};
}

void VisitPlace(Keys& keys, Eigen::Vector2d& p) {
  keys.Number("x_m", p.x(), Between(-kFarthest_m, kFarthest_m));
  keys.Number("y_m", p.y(), Between(-kFarthest_m, kFarthest_m));
}

Polygon ReadPolygon(const YamlReader& in, std::string_view key) {
  const YamlNode& list = in.List(key, 3, kMostCorners);
  Polygon polygon;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    polygon.push_back(ReadPlace(
        YamlReader(list.items[i], YamlReader::PathOf(in.PathOf(key), i), {"x_m", "y_m"})));
  }
  if (AreaOf(polygon) < 1e-9) in.Refuse(key, "corners round an area");
  return polygon;
}

Obstacles LoadObstacles(const std::string& file) {
  if (IsCsvFile(file)) return LoadDiscs(file);
  const YamlNode root = LoadYaml(file);
  const YamlReader in(root, "", {"obstacles"});
  const YamlNode& list = in.List("obstacles", 0, kMostObstacleDiscs);
  Obstacles obstacles;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const std::string path = YamlReader::PathOf("obstacles", i);
    if (list.items[i].Find("corners") == nullptr) {
      obstacles.discs.push_back(ReadObstacleDisc(list.items[i], path));
      continue;
    }
    if (obstacles.polygons.size() == kMostAreas) {
      throw ConfigError(list.items[i].place.Text() + ": obstacles: expected at most " +
                        std::to_string(kMostAreas) + " areas; discs may be more");
    }
    obstacles.polygons.push_back(
        ReadPolygon(YamlReader(list.items[i], path, {"corners"}), "corners"));
  }
  return obstacles;
}

bool IsDiscTable(const std::string& file) {
  const YamlNode table = LoadCsv(file, kMostCsvBytes);
  if (table.items.empty()) return false;
  const std::vector<YamlNode::Key>& columns = table.items.front().keys;
  return std::all_of(kDiscKeys.begin(), kDiscKeys.end(), [&](const std::string& name) {
    return std::any_of(columns.begin(), columns.end(), [&](const YamlNode::Key& column) {
      return column.name == name || DiffersInCaseAlone(column.name, name);
    });
  });
}

}  // namespace dockyard
