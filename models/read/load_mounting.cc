#include "models/read/load_mounting.h"

#include "models/read/as_built.h"

namespace dockyard {
namespace {

const std::vector<std::string> kMountingKeys{"x_m",      "y_m",       "z_m",
                                             "roll_deg", "pitch_deg", "yaw_deg"};

}  // namespace

Pose3 ReadMounting(const YamlReader& in, const std::string& key) {
  Pose3 mounting;
  if (!in.Has(key)) return mounting;
  const YamlReader part(in.Child(key), in.PathOf(key), kMountingKeys);
  const Range shift_m = Between(-0.5, 0.5), turn_deg = Between(-30.0, 30.0);
  mounting.p =
      Eigen::Vector3d(part.NumberOr("x_m", 0.0, shift_m), part.NumberOr("y_m", 0.0, shift_m),
                      part.NumberOr("z_m", 0.0, shift_m));
  mounting.R = ToRotation({.roll = part.DegreesOr("roll_deg", 0.0, turn_deg),
                           .pitch = part.DegreesOr("pitch_deg", 0.0, turn_deg),
                           .yaw = part.DegreesOr("yaw_deg", 0.0, turn_deg)});
  return mounting;
}

void PutMountingIfLeftOut(YamlNode& tree, const std::string& path) {
  for (const std::string& key : kMountingKeys) PutIfLeftOut(tree, path + "." + key, 0.0);
}

}  // namespace dockyard
