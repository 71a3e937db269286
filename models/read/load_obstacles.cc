#include "models/read/load_obstacles.h"

#include <cmath>

namespace dockyard {
namespace {

constexpr double kFarthest_m = 1e3;
constexpr std::size_t kMostObstacles = 1000, kMostCorners = 100;

// By the shoelace formula, without sign.
double AreaOf(const Polygon& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0, last = polygon.size() - 1; i < polygon.size(); last = i++) {
    twice += polygon[last].x() * polygon[i].y() - polygon[last].y() * polygon[i].x();
  }
  return 0.5 * std::abs(twice);
}

}  // namespace

Eigen::Vector2d ReadPlace(const YamlReader& in) {
  const Range range = Between(-kFarthest_m, kFarthest_m);
  return {in.Number("x_m", range), in.Number("y_m", range)};
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
  const YamlNode root = LoadYaml(file);
  const YamlReader in(root, "", {"obstacles"});
  const YamlNode& list = in.List("obstacles", 0, kMostObstacles);
  Obstacles obstacles;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const std::string path = YamlReader::PathOf("obstacles", i);
    if (list.items[i].Find("corners") != nullptr) {
      obstacles.polygons.push_back(
          ReadPolygon(YamlReader(list.items[i], path, {"corners"}), "corners"));
      continue;
    }
    const YamlReader disc(list.items[i], path, {"x_m", "y_m", "radius_m"});
    obstacles.discs.push_back({ReadPlace(disc), disc.Number("radius_m", Positive(kFarthest_m))});
  }
  return obstacles;
}

}  // namespace dockyard
