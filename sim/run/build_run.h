// From a scenario to everything that one run is made of: the world as built, and the data sheet
// that the controller is given. All dispersion between the two is drawn here.
#pragma once

#include "controller/io/rover_sheet.h"
#include "models/scenario.h"
#include "sim/physics/world.h"
#include "sim/run/light.h"

namespace dockyard {

struct BuiltRun {
  WorldSetup world;
  StereoRig built_rig;  // the cameras that see
  RoverSheet sheet;     // what the controller is told: nominal
  Lighting lighting;
  Pose3 X_WD;  // dock where it was put
};

/// Reads the scenario's model files (throws ConfigError) and draws the run's dispersions.
BuiltRun BuildRun(const Scenario& scenario);

/// Throws ConfigError when pictures of these cameras reach beyond what the renderer draws, 60 deg
/// from a lens's axis (docs/images.md).
void CheckPicturesCanBeDrawn(const StereoRig& rig);

/// Throws ConfigError when rover and station were put into each other: the contacts have then
/// thrown them apart while the world came to rest.
void CheckStart(const BuiltRun& run, const Truth& start);

}  // namespace dockyard
