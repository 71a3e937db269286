// A run of Rocky 7 as it is built from its scenario.
#pragma once

#include <array>

#include "controller/rocky7/nominal/nominal.h"
#include "render/lens_ripple.h"
#include "sim/plant/light.h"
#include "sim/rocky7/load_models.h"
#include "sim/rocky7/world.h"

namespace dockyard::rocky7 {

struct BuiltRun {
  WorldSetup world;  // G is D: the target's middle on the ground
  Rocky7Keys keys;
  StereoRig front, back, mast_pair;                                           // as built
  std::array<LensRipple, 2> front_ripples{}, back_ripples{}, mast_ripples{};  // of their lenses
  std::vector<ConvexBody> gravel{};  // in G; for cameras alone
  Lighting lighting;
  Nominal nominal;  // what the controller is told; the click is put in by the plant
};

/// Throws ConfigError.
BuiltRun BuildRun(const Scenario& scenario, const Rocky7Models& models);

}  // namespace dockyard::rocky7
