#include "sim/scenario/patch_keys.h"

#include <cmath>

#include "models/read/config_error.h"
#include "models/read/number_grid.h"
#include "models/read/yaml_reader.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/keys.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostPatches = 100;
constexpr Range kPatchPlace_m{-200.0, 200.0}, kPatchSide_m{0.05, 400.0};

void ReadPolygon(const YamlReader& in, const std::string& path, YardPatch& patch) {
  const NumberGrid corners = ReadGrid(in.List("polygon", 3, 200), path + ".polygon");
  corners.RequireShape(corners.rows, 2);
  for (int i = 0; i < corners.rows; ++i) {
    patch.corners_D.emplace_back(corners.values[static_cast<std::size_t>(2 * i)],
                                 corners.values[static_cast<std::size_t>(2 * i + 1)]);
  }
}

YardPatch ReadPatch(YamlNode& node, const std::string& path) {
  const YamlReader in(node, path, {"soil", "rectangle", "disc", "polygon"});
  YardPatch patch;
  patch.place = node.place.Text() + ": " + path;
  patch.soil_file = AbsolutePath(in.File("soil"));
  YamlNode& file = *FindPath(node, "soil");
  file.scalar = patch.soil_file;
  file.quoted = true;
  if (in.Has("rectangle") + in.Has("disc") + in.Has("polygon") != 1) {
    throw ConfigError(patch.place + ": expected one of rectangle, disc and polygon");
  }
  if (in.Has("polygon")) {
    ReadPolygon(in, path, patch);
    return patch;
  }
  const bool disc = in.Has("disc");
  const char* key = disc ? "disc" : "rectangle";
  ReadKeys(in.Child(key), in.PathOf(key), [&](Keys& keys) {
    using enum Presence;
    keys.Number({"x_m", "m", "of its middle in D", kRequired}, patch.X_DP.x, kPatchPlace_m);
    keys.Number({"y_m", "m", "the same", kRequired}, patch.X_DP.y, kPatchPlace_m);
    if (disc) {
      keys.Number({"radius_m", "m", "", kRequired}, patch.radius_m, kPatchSide_m);
      return;
    }
    keys.Number({"length_m", "m", "along its x", kRequired}, patch.length_m, kPatchSide_m);
    keys.Number({"width_m", "m", "along its y", kRequired}, patch.width_m, kPatchSide_m);
    keys.Degrees({"turn_deg", "deg", "of its x from D's"}, patch.X_DP.heading,
                 Between(-180.0, 180.0));
  });
  return patch;
}

}  // namespace

void ReadPatches(YardModel& yard) {
  yard.patches.clear();
  std::vector<YamlNode>& given = yard.given_patches.items;
  if (given.size() > kMostPatches) {
    throw ConfigError(yard.given_patches.place.Text() + ": yard.patches: expected at most " +
                      std::to_string(kMostPatches) + " patches, found " +
                      std::to_string(given.size()));
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    yard.patches.push_back(ReadPatch(given[i], YamlReader::PathOf("yard.patches", i)));
  }
}

bool Holds(const YardPatch& patch, const Eigen::Vector2d& p_D) {
  if (patch.corners_D.empty()) {
    const Eigen::Vector2d p_P = Inverse(patch.X_DP) * p_D;
    if (patch.radius_m > 0.0) return p_P.norm() <= patch.radius_m;
    return std::abs(p_P.x()) <= 0.5 * patch.length_m && std::abs(p_P.y()) <= 0.5 * patch.width_m;
  }
  // An odd number of edges to one side.
  bool inside = false;
  for (std::size_t i = 0, j = patch.corners_D.size() - 1; i < patch.corners_D.size(); j = i++) {
    const Eigen::Vector2d &a = patch.corners_D[i], &b = patch.corners_D[j];
    if ((a.y() > p_D.y()) == (b.y() > p_D.y())) continue;
    const double x = a.x() + (p_D.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (p_D.x() < x) inside = !inside;
  }
  return inside;
}

}  // namespace dockyard
