// From a scenario to everything that one run is made of: the world as built, and the nominal
// parameters that the controller is told. All dispersion between the two is drawn here.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "sim/axel/load_models.h"
#include "sim/axel/world.h"
#include "sim/run/light.h"
#include "sim/scenario/scenario.h"

namespace dockyard::axel {

struct BuiltRun {
  WorldSetup world;
  StereoRig built_rig;  // the cameras that see
  Nominal nominal;      // what the controller is told
  Lighting lighting;
  Pose3 X_WD;  // dock where it was put
};

/// Draws the run's dispersions. Throws ConfigError for images that cannot be drawn.
BuiltRun BuildRun(const Scenario& scenario, const AxelModels& models);

/// Throws ConfigError when pictures of these cameras reach beyond what the renderer draws, 60 deg
/// from a lens's axis (docs/reference/images.md).
void CheckPicturesCanBeDrawn(const StereoRig& rig);

/// Throws ConfigError when rover and station were put into each other: the contacts have then
/// thrown them apart while the world came to rest.
void CheckStart(const BuiltRun& run, const Truth& start);

}  // namespace dockyard::axel
