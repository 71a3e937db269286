#include "sim/raposa/build_run.h"

#include <cmath>

#include "models/raposa/load_ground.h"
#include "models/raposa/make_nominal.h"
#include "models/read/config_error.h"
#include "models/read/load_soil.h"
#include "sim/base/random.h"
#include "sim/plant/yard.h"
#include "sim/raposa/ferreira_keys.h"

namespace dockyard::raposa {
namespace {

// Level about the pyramid's feet. Assumed, 0.1-0.5 m.
constexpr double kFlatRadius_m = 0.15;
// The cable's far end lies within this of straight behind the pyramid. Assumed, 0-60 deg.
constexpr double kCableWithin_rad = Radians(40.0);

HeightGrid GroundOf(const YardModel& yard, double behind_m, const Seed& seed) {
  if (yard.undulation_rms_m > 0.0 || !yard.heights.file.empty() || !yard.patches.empty()) {
    return YardGround(yard, kFlatRadius_m, seed, behind_m);
  }
  // A level floor needs no cells, and is drawn as a plane.
  const double length_m = yard.length_m - kYardBehind_m + behind_m;
  return LevelGrid(-behind_m, length_m, yard.width_m, 0.5 * length_m);
}

// A start stays this far from the yard's border, as the scenario's reader has it on other sides.
constexpr double kMargin_m = 1.0;

void CheckStart(const Scenario& scenario, const RaposaKeys& keys, const RobotModel& robot) {
  const double x_m = scenario.start.on_plane().r * std::cos(scenario.start.on_plane().alpha);
  if (x_m < kMargin_m - keys.behind_m) {
    throw ConfigError(scenario.start_place + ": expected a start within raposa.behind_m of " +
                      NumberText(keys.behind_m) + " m and 1 m from its end, found one " +
                      NumberText(-x_m) + " m behind the pyramid");
  }
  // The camera sits inside the robot: nearer than the socket's mouth is no place to be.
  const double least_m = robot.camera.X_RC.p.x() - robot.socket.p_RS.x() + 0.1;
  if (scenario.start.on_plane().r >= least_m) return;
  throw ConfigError(
      scenario.start_place + ": expected r_m, from the camera to the guide, of at least " +
      NumberText(least_m) + " m, found '" + NumberText(scenario.start.on_plane().r) + "'");
}

/// Its spectra come from the system's own keys.
void CheckLight(const Scenario& scenario) {
  if (scenario.sun.temperature_k == 0.0 && scenario.sun.sky_temperature_k == 0.0) return;
  throw ConfigError(scenario.sun_place +
                    ": expected no sun.temperature_k or sun.sky_temperature_k: RAPOSA's light has "
                    "raposa.light_k and raposa.fill_light_k");
}

void CheckHolds(const Scenario& scenario, const PyramidModel& pyramid) {
  if (std::tan(scenario.yard.slope_rad) < pyramid.foot_friction) return;
  throw ConfigError(scenario.yard_place +
                    ": expected a slope that the pyramid's feet hold at their "
                    "friction of " +
                    NumberText(pyramid.foot_friction));
}

void CheckCarriesAll(const GroundModel& ground, const std::string& file, const ModelSet& models) {
  if (!ground.soil) return;
  CheckCarries(*ground.soil, file, models.robot.belts.width_m);
  CheckCarries(*ground.soil, file, 0.5 * models.pyramid.foot_diameter_m);
}

}  // namespace

Slope SlopeOf(const Scenario& scenario) {
  return {scenario.yard.slope_rad, scenario.yard.downhill_rad};
}

BuiltRun BuildRun(const Scenario& scenario, const RaposaModels& models) {
  CheckStart(scenario, models.keys, models.built.robot);
  CheckHolds(scenario, models.built.pyramid);
  CheckLight(scenario);
  CheckCarriesAll(models.built.ground, scenario.soil_file, models.built);
  BuiltRun run;
  run.keys = models.keys;
  run.ground = models.built.ground;
  run.nominal = MakeNominal(models.nominal.robot, models.nominal.pyramid);
  PutBands(models.keys, run.nominal.ferreira_vision);
  PutVision(models.keys, run.nominal.ferreira_vision);
  PutMotion(models.keys, run.nominal.ferreira_motion);
  WorldSetup& world = run.world;
  world.robot = models.built.robot;
  world.pyramid = models.built.pyramid;
  world.grounds = {models.built.ground};
  for (const std::string& file : PatchSoilFiles(scenario.yard)) {
    world.grounds.push_back(LoadGround(file));
    CheckCarriesAll(world.grounds.back(), file, models.built);
  }
  world.ground = GroundOf(scenario.yard, run.keys.behind_m, scenario.seed);
  world.X_WG = scenario.X_WG;
  world.slope = SlopeOf(scenario);
  DockingCoords at = scenario.start.on_plane();
  if (!std::isnan(run.keys.off_guide_rad)) at.h = at.alpha + run.keys.off_guide_rad;
  world.X_DV_start = FromDockingCoords(at);
  run.clutter = DrawClutter(run.keys.clutter, world.X_DV_start, run.keys.behind_m, scenario.seed);
  RandomStream start(StreamKey(scenario.seed, "start"));
  const double drawn_rad = start.Uniform(-kCableWithin_rad, kCableWithin_rad);
  world.cable_rad = std::isnan(models.keys.cable_rad) ? drawn_rad : models.keys.cable_rad;
  world.seed = scenario.seed;
  world.step_s = scenario.physics_step_s;
  return run;
}

}  // namespace dockyard::raposa
