// A scenario of Rocky 7 for tests.
#pragma once

#include <string>

#include "models/read/yaml_tree.h"
#include "sim/scenario/scenario.h"
#include "support/bad_files.h"

namespace dockyard::rocky7 {

/// On compact gravel in a square yard of this side, from this distance straight at the target.
/// keys: those under `rocky7`, as YAML.
inline Scenario OnGravel(const std::string& keys, double from_m, double yard_m) {
  Scenario scenario;
  scenario.name = "test";
  scenario.system = "rocky7";
  scenario.robot_file = SourceFile("models/rocky7/rocky7.yaml");
  scenario.soil_file = SourceFile("models/soils/compact_gravel.yaml");
  scenario.of_system = ParseYaml(keys, "test");
  scenario.start = {from_m, 0.0, 0.0};
  scenario.yard.length_m = scenario.yard.width_m = yard_m;
  scenario.yard.cell_m = 0.01;
  return scenario;
}

}  // namespace dockyard::rocky7
