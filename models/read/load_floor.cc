#include "models/read/load_floor.h"

#include "models/read/changed_yaml.h"
#include "models/read/load_spreads.h"
#include "models/read/other_kind.h"
#include "models/read/yaml_reader.h"

namespace dockyard {

FloorModel LoadFloor(const std::string& file, const ModelChanges& changes) {
  const YamlNode root = LoadChangedYaml(file, changes);
  return AdvisingOtherKinds("floor", [&] {
    FloorModel floor;
    ReadKeys(root, "", [&](Keys& keys) { VisitFloor(keys, floor); });
    CheckSpreads(root);
    return floor;
  });
}

void VisitFloor(Keys& keys, FloorModel& floor) {
  keys.Text("name", floor.name);
  keys.Text("source", floor.source);
  keys.Number("friction", floor.friction, Between(0.01, 3.0));
  keys.Number("stiffness_n_per_m", floor.stiffness_n_per_m, NonNegative(1e9));
  keys.Number("damping_ns_per_m", floor.damping_ns_per_m, NonNegative(1e7));
  keys.Number("rolling_resistance_m", floor.rolling_resistance_m, NonNegative(0.1));
  keys.Choice("material", floor.material, {"floor", "soil", "grass", "brick", "grey"});
  keys.Number("grain", floor.grain, Between(0.0, 1.0));
  NameSpreads(keys);
}

}  // namespace dockyard
