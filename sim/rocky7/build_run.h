// A run of Rocky 7 as it is built from its scenario.
#pragma once

#include "controller/rocky7/nominal/nominal.h"
#include "sim/rocky7/load_models.h"
#include "sim/rocky7/world.h"
#include "sim/run/light.h"

namespace dockyard::rocky7 {

struct BuiltRun {
  WorldSetup world;  // G is D: the target's middle on the ground
  Rocky7Keys keys;
  StereoRig front, back, mast_pair;  // as built
  Lighting lighting;
  Nominal nominal;  // what the controller is told; the click is put in by the plant
};

/// Throws ConfigError.
BuiltRun BuildRun(const Scenario& scenario, const Rocky7Models& models);

/// The user's click: the pixel of the left camera that shows the target's middle, with the error of
/// the hand. truth: of the start. Throws ConfigError when the target is not in
/// that picture.
///
/// On a boulder the click itself is the target: it is what the mast's left camera shows there.
Eigen::Vector2d ClickOn(const Scenario& scenario, const BuiltRun& run, const Truth& truth);

/// The point of the boulder, in G, that the mast's left camera shows at a pixel. Throws ConfigError
/// when that is another thing.
Eigen::Vector3d ClickedPoint(const Scenario& scenario, const BuiltRun& run, const Truth& truth,
                             const Eigen::Vector2d& pixel);

}  // namespace dockyard::rocky7
