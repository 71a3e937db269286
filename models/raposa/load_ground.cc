#include "models/raposa/load_ground.h"

#include <cmath>

#include "models/read/load_model_yaml.h"
#include "models/read/load_soil.h"
#include "models/read/load_spreads.h"
#include "models/read/other_kind.h"
#include "models/read/yaml_reader.h"

namespace dockyard::raposa {
namespace {

void VisitFirm(Keys& keys, GroundModel& ground) {
  keys.Text("name", ground.name);
  keys.Text("source", ground.source);
  double angle_rad = 0.0;
  keys.Degrees("friction_angle_deg", angle_rad, Between(1.0, 60.0));
  ground.belt.friction = std::tan(angle_rad);
  keys.Number("lateral_ratio", ground.belt.lateral_ratio, Between(0.2, 3.0));
  keys.Number("cohesion_pa", ground.belt.cohesion_pa, NonNegative(1e5));
  keys.Number("shear_displacement_m", ground.belt.shear_displacement_m, NonNegative(0.2));
  NameSpreads(keys);
}

/// soft: it has a soil's keys, too.
void VisitGround(Keys& keys, GroundModel& ground, bool soft) {
  if (soft) {
    if (!ground.soil) ground.soil.emplace();
    VisitSoil(keys, *ground.soil);
    ground.name = ground.soil->name;
    ground.source = ground.soil->source;
  } else {
    VisitFirm(keys, ground);
  }
  keys.Number("rolling_loss", ground.belt.rolling_loss, NonNegative(1.0));
  keys.Number("patch_scatter", ground.belt.patch_scatter, Between(0.0, 0.9));
  keys.Number("patch_m", ground.belt.patch_m, Between(0.01, 10.0));
  keys.Choice("material", ground.material, {"floor", "soil", "grass", "brick", "grey"});
  keys.Number("grain", ground.grain, Between(0.0, 1.0));
}

GroundModel ReadGround(const YamlNode& root) {
  GroundModel ground;
  const bool soft = root.Find("k_phi") != nullptr;
  ReadKeys(root, "", [&](Keys& keys) { VisitGround(keys, ground, soft); });
  CheckSpreads(root);
  return ground;
}

}  // namespace

GroundModel LoadGround(const std::string& file, const ModelChanges& changes) {
  YamlNode root = LoadModelYaml(file);
  if (changes.nominal != nullptr) MergeYaml(root, *changes.nominal);
  if (changes.built != nullptr) PutBuilt(root, *changes.built);
  return AdvisingOtherKinds("ground", [&] { return ReadGround(root); });
}

}  // namespace dockyard::raposa
