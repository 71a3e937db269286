// A run of RAPOSA as it is built from its scenario.
#pragma once

#include "controller/raposa/nominal/nominal.h"
#include "sim/raposa/clutter.h"
#include "sim/raposa/load_models.h"
#include "sim/raposa/world.h"

namespace dockyard::raposa {

struct BuiltRun {
  WorldSetup world;
  GroundModel ground;  // its look
  std::vector<SceneryItem> clutter;
  RaposaKeys keys;
  Nominal nominal;  // what the controller is told
};

Slope SlopeOf(const Scenario& scenario);
/// Throws ConfigError.
BuiltRun BuildRun(const Scenario& scenario, const RaposaModels& models);

}  // namespace dockyard::raposa
