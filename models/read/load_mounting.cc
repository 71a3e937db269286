#include "models/read/load_mounting.h"

#include "models/read/as_built.h"

namespace dockyard {
namespace {

const std::vector<std::string> kMountingKeys{"x_m",      "y_m",       "z_m",
                                             "roll_deg", "pitch_deg", "yaw_deg"};

}  // namespace

void VisitMounting(Keys& keys, Pose3& mounting, std::string_view key) {
  keys.Mapping(Unset(key), [&](Keys& in) {
    mounting = Pose3{};
    RollPitchYaw turn;
    for (int i = 0; i < 3; ++i) {
      in.Number(Optional(kMountingKeys[i]), mounting.p[i], Between(-0.5, 0.5));
    }
    in.Degrees(Optional("roll_deg"), turn.roll, Between(-30.0, 30.0));
    in.Degrees(Optional("pitch_deg"), turn.pitch, Between(-30.0, 30.0));
    in.Degrees(Optional("yaw_deg"), turn.yaw, Between(-30.0, 30.0));
    mounting.R = ToRotation(turn);
  });
}

void PutMountingIfLeftOut(YamlNode& tree, const std::string& path) {
  for (const std::string& key : kMountingKeys) PutIfLeftOut(tree, path + "." + key, 0.0);
}

}  // namespace dockyard
