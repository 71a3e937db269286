// From a scenario to all parts of one run: the world as built, and the nominal parameters that the
// controller gets. All dispersion between the two is drawn here.
#pragma once

#include <array>

#include "controller/axel/nominal/nominal.h"
#include "render/lens_ripple.h"
#include "sim/axel/load_models.h"
#include "sim/axel/world.h"
#include "sim/plant/light.h"
#include "sim/scenario/scenario.h"

namespace dockyard::axel {

struct BuiltRun {
  WorldSetup world;
  StereoRig built_rig;                  // the cameras that see
  std::array<LensRipple, 2> ripples{};  // of their lenses, beyond their model: left, right
  Nominal nominal;                      // what the controller gets
  Lighting lighting;
  Pose3 X_WD;                           // dock where it was put
  std::string start_place, yard_place;  // in the scenario's file, for messages
};

/// The yard's ground before anything has stood on it.
HeightGrid MakeGround(const YardModel& yard, const Seed& seed);

/// Where a scenario's site lies in the world.
Pose3 SiteOf(const Scenario& scenario);

/// Draws the run's dispersions. Throws ConfigError for images that cannot be drawn.
BuiltRun BuildRun(const Scenario& scenario, const AxelModels& models);

/// Throws ConfigError for a slope on which the station slides down by itself.
void CheckStationHolds(const Scenario& scenario, const StationModel& station);

/// Throws ConfigError when the station does not stand where it was put, but slid or fell. So too
/// when rover and station overlapped at the start: the contacts have then pushed them apart while
/// the world came to rest.
void CheckStart(const BuiltRun& run, const Truth& start);

}  // namespace dockyard::axel
