#include "models/axel/rover_changes.h"

#include <string>
#include <utility>

#include "models/read/as_built.h"
#include "models/read/load_mounting.h"
#include "models/read/yaml_path.h"

namespace dockyard::axel {
namespace {

/// The whole motor of one side: the wheels' motor with the side's own keys on top.
void WriteSideMotor(const YamlNode::Key& side, YamlNode& motors) {
  YamlNode motor = *motors.Find("wheel");
  if (YamlNode* own = FindPath(motors, side.name)) {
    MergeYaml(motor, *own);
    *own = std::move(motor);
    return;
  }
  motors.keys.push_back(side);
  motors.items.push_back(std::move(motor));
}

}  // namespace

void WriteLeftOut(const RoverModel& told, YamlNode& tree) {
  PutIfLeftOut(tree, "mass_scale", 1.0);
  PutIfLeftOut(tree, "body_com_x_m", told.body.p_LoCom_L.x());
  PutIfLeftOut(tree, "wheels.track_m", told.track_m());
  PutIfLeftOut(tree, "arm.offset_m", 0.0);
  PutIfLeftOut(tree, "tether.drum_growth_m_per_turn", 0.0);
  PutIfLeftOut(tree, "tether.friction_on_ground", told.tether.friction_on_ground);
  PutIfLeftOut(tree, "tether.friction_on_rock", told.tether.friction_on_rock);
  PutIfLeftOut(tree, "tether.friction_on_rover", told.tether.friction_on_rover);
  for (const char* scale : {"left_radius_scale", "right_radius_scale"}) {
    PutIfLeftOut(tree, std::string("wheels.") + scale, 1.0);
  }
  for (const char* motor : {"wheel", "arm", "spool"}) {
    PutIfLeftOut(tree, std::string("motors.") + motor + ".gear_efficiency", 1.0);
  }
  PutMountingIfLeftOut(tree, "cameras.mounting");
  PutMountingIfLeftOut(tree, "cameras.right_mounting");
}

YamlNode WithSideMotors(YamlNode tree) {
  YamlNode& motors = *FindPath(tree, "motors");
  for (const char* side : {"left_wheel", "right_wheel"}) WriteSideMotor({side, {}}, motors);
  return tree;
}

void PutBuiltRover(YamlNode& tree, const YamlNode& built) {
  YamlNode both = built, sides;
  sides.kind = YamlNode::Kind::kMapping;
  YamlNode* keys = FindPath(both, "motors");
  for (std::size_t i = keys == nullptr ? 0 : keys->keys.size(); i-- > 0;) {
    const std::string& name = keys->keys[i].name;
    if (name != "left_wheel" && name != "right_wheel") continue;
    const auto at = static_cast<std::ptrdiff_t>(i);
    sides.keys.push_back(keys->keys[i]);
    sides.items.push_back(keys->items[i]);
    keys->keys.erase(keys->keys.begin() + at);
    keys->items.erase(keys->items.begin() + at);
  }
  PutBuilt(tree, both);
  if (sides.keys.empty()) return;
  YamlNode& motors = *FindPath(tree, "motors");
  for (const YamlNode::Key& side : sides.keys) WriteSideMotor(side, motors);
  PutBuilt(motors, sides, "motors");
}

}  // namespace dockyard::axel
