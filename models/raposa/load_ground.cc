#include "models/raposa/load_ground.h"

#include <cmath>

#include "models/read/load_model_yaml.h"
#include "models/read/load_soil.h"
#include "models/read/load_spreads.h"
#include "models/read/other_kind.h"
#include "models/read/yaml_reader.h"

namespace dockyard::raposa {
namespace {

std::vector<std::string> FirmKeys() {
  return {"name",        "source",  "friction_angle_deg",  "lateral_ratio",
          "cohesion_pa", "spreads", "shear_displacement_m"};
}

void ReadFirm(const YamlReader& in, BeltGround& belt) {
  belt.friction = std::tan(in.Degrees("friction_angle_deg", Between(1.0, 60.0)));
  belt.lateral_ratio = in.Number("lateral_ratio", Between(0.2, 3.0));
  belt.cohesion_pa = in.Number("cohesion_pa", NonNegative(1e5));
  belt.shear_displacement_m = in.Number("shear_displacement_m", NonNegative(0.2));
}

GroundModel ReadGround(const YamlNode& root) {
  const bool soft = root.Find("k_phi") != nullptr;
  std::vector<std::string> keys = soft ? SoilKeys() : FirmKeys();
  keys.insert(keys.end(), {"rolling_loss", "patch_scatter", "patch_m", "material", "grain"});
  const YamlReader in(root, "", keys);
  GroundModel ground;
  ground.name = in.Text("name");
  ground.source = in.Text("source");
  if (soft) {
    ground.soil = ReadSoil(in);
  } else {
    ReadFirm(in, ground.belt);
  }
  ground.belt.rolling_loss = in.Number("rolling_loss", NonNegative(1.0));
  ground.belt.patch_scatter = in.Number("patch_scatter", Between(0.0, 0.9));
  ground.belt.patch_m = in.Number("patch_m", Between(0.01, 10.0));
  const int material = in.Choice("material", {"floor", "soil", "grass", "brick", "grey"});
  ground.material = static_cast<GroundMaterialKind>(material);
  ground.grain = in.Number("grain", Between(0.0, 1.0));
  CheckSpreads(root);
  return ground;
}

}  // namespace

GroundModel LoadGround(const std::string& file, const ModelChanges& changes) {
  YamlNode root = LoadModelYaml(file);
  if (changes.told != nullptr) MergeYaml(root, *changes.told);
  if (changes.built != nullptr) PutBuilt(root, *changes.built);
  return AdvisingOtherKinds("ground", [&] { return ReadGround(root); });
}

}  // namespace dockyard::raposa
