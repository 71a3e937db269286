#include "sim/axel/build_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "controller/base/number_text.h"
#include "controller/geometry/axle_attitude.h"
#include "models/axel/make_nominal.h"
#include "models/axel/mating_fit.h"
#include "models/read/config_error.h"
#include "sim/axel/axel_view.h"
#include "sim/axel/build_rocks.h"
#include "sim/axel/rock_survey.h"
#include "sim/axel/rover_start.h"
#include "sim/base/random.h"
#include "sim/plant/built_cameras.h"
#include "sim/plant/scenery.h"
#include "sim/plant/yard.h"

namespace dockyard::axel {
namespace {

// Yard in the dock's surroundings: level enough for the feet, then as undulating as the file says.
constexpr double kFlatRadius_m = 0.6;

Slope SlopeOf(const Scenario& scenario) {
  return {scenario.yard.slope_rad, scenario.yard.downhill_rad};
}

/// Of a rover that starts seated: its axle on the cone's axis, facing the station.
Pose2 SeatedStart(const RoverModel& rover, const StationModel& station) {
  const double along_m = rover.arm_length_m - SeatDepth(station.cone);
  return {along_m * std::cos(station.tip_angle_rad), 0.0, kPi};
}

/// Arm against a level body, tip-down positive, of an arm whose tip lies on the socket's axis while
/// the wheels stand on their paddles' tips, as they are put down [rad].
double SeatedArm(const RoverModel& rover, const StationModel& station) {
  const double axle_m = RollingRadius(rover.left_wheel_soil);
  return -(station.tip_angle_rad + SeatedElevation(rover, axle_m, station));
}

/// Body and arm about the axle, the arm's tip on level ground [rad].
struct Lying {
  double arm = 0.0, body = 0.0;  // arm against body, tip-down positive; body, nose-down positive
};

Lying LyingAt(const RoverModel& rover, const StartKeys& start) {
  const double axle_height =
      rover.left_wheel_soil.rim_radius_m + 0.5 * PaddleReach(rover.left_wheel_soil);
  const double below_m = axle_height - rover.tip.radius_m;
  if (below_m >= rover.arm_length_m) {
    throw ConfigError(rover.name + ": arm.length_m: expected more than " + NumberText(below_m) +
                      ", with which its tip reaches the ground, found '" +
                      NumberText(rover.arm_length_m) + "'");
  }
  const double down = std::asin(below_m / rover.arm_length_m);
  const double arm_in_space = start.arm == ArmPlace::kLeading ? down : kPi - down;
  if (!std::isnan(start.arm_rad)) return {start.arm_rad, WrapPi(arm_in_space - start.arm_rad)};
  const double body = std::isnan(start.body_pitch_rad) ? 0.0 : start.body_pitch_rad;
  return {WrapPi(arm_in_space - body), body};
}

// An arm laid on the funnel slides down a few centimetres at most.
constexpr double kMostSettling_m = 0.05;
// Further from the mouth than the arm's length and this the rover does not meet the station, and
// may roll off a paddle's tip by half a pitch, 8 cm. Assumed, range 0.1-0.5 m.
constexpr double kClear_m = 0.3;
// Put down on a slope a station may slip by 1 cm before its feet hold; one that tips over moves by
// more than this.
constexpr double kStands_m = 0.05;

void CheckStation(const BuiltRun& run, const Truth& start) {
  if (run.world.slope.angle_rad == 0.0) return;
  const double moved_m = (Inverse(run.X_WD) * start.X_WS).p.norm();
  if (moved_m < kStands_m) return;
  char text[120];
  std::snprintf(text, sizeof text,
                ": expected a slope on which the station stands, on this one of %.1f deg it moved "
                "by %.2f m",
                Degrees(run.world.slope.angle_rad), moved_m);
  throw ConfigError(run.yard_place + text);
}

/// The yard ends close behind the station.
void CheckBearing(const Scenario& scenario) {
  if (std::abs(scenario.start.on_plane().alpha) <= Radians(90.0)) return;
  throw ConfigError(scenario.start_place +
                    ": expected alpha_deg from -90 to 90, a start before the station, found '" +
                    NumberText(Degrees(scenario.start.on_plane().alpha)) + "'");
}

}  // namespace

HeightGrid MakeGround(const YardModel& yard, const Seed& seed) {
  return YardGround(yard, kFlatRadius_m, seed);
}

Pose3 SiteOf(const Scenario& scenario) { return SiteInWorld(scenario.X_WG, SlopeOf(scenario)); }

void CheckStationHolds(const Scenario& scenario, const StationModel& station) {
  const double slope = std::tan(scenario.yard.slope_rad);
  if (slope < station.foot_friction) return;
  char text[160];
  std::snprintf(text, sizeof text,
                ": expected a slope that the station's feet hold, below %.1f deg at their friction "
                "of %.3g, found %.1f deg",
                Degrees(std::atan(station.foot_friction)), station.foot_friction,
                Degrees(scenario.yard.slope_rad));
  throw ConfigError(scenario.yard_place + text);
}

void CheckStart(const BuiltRun& run, const Truth& start) {
  // Body or arm asked for otherwise than level and ahead. On a slope any rover may roll over.
  const bool leads = std::cos(run.world.arm_start_rad + run.world.pitch_start_rad) > 0.0;
  const bool asked = !leads || run.world.pitch_start_rad != 0.0;
  const bool led = start.X_WA.R(2, 2) > 0.0;
  if (asked && leads != led) {
    throw ConfigError(run.start_place +
                      ": expected a start at which the rover stays as it is put down, this one's "
                      "arm went over the top");
  }
  const Pose2 &wanted = run.world.X_DR_start, is = AxleOnGround(start.X_DR);
  const double moved_m = std::hypot(is.x - wanted.x, is.y - wanted.y);
  const double clear_m = run.world.rover.arm_length_m + kClear_m;
  if (moved_m < kMostSettling_m || std::hypot(wanted.x, wanted.y) > clear_m) {
    CheckStation(run, start);
    return;
  }
  char text[120];
  std::snprintf(text, sizeof text,
                ": expected a rover clear of the station, this one was pushed %.2f m aside by it",
                moved_m);
  throw ConfigError(run.start_place + text);
}

// Which marks are dirty follows from the seed.
std::vector<DustySpot> DustyMarks(const DirtyMarks& dirty, const FiducialBoard& board,
                                  const Seed& seed) {
  std::vector<Fiducial> clean(board.fiducials.begin(), board.fiducials.end());
  RandomStream pick(StreamKey(seed, "dirty_marks"));
  std::vector<DustySpot> spots;
  for (int i = 0; i < dirty.count && !clean.empty(); ++i) {
    const auto at = std::min(
        static_cast<std::size_t>(pick.Uniform(0.0, 1.0) * static_cast<double>(clean.size())),
        clean.size() - 1);
    spots.push_back(
        {.p_B = clean[at].p_BF, .radius_m = 0.75 * board.disc_diameter_m, .cover = dirty.dust});
    clean.erase(clean.begin() + static_cast<std::ptrdiff_t>(at));
  }
  return spots;
}

// Arm and tether as the dock left them: seated and taut. The encoder tells the arm's angle.
void StartSeated(const AxelModels& models, BuiltRun* run) {
  WorldSetup& world = run->world;
  world.X_DR_start = SeatedStart(world.rover, world.station);
  world.arm_start_rad = SeatedArm(world.rover, world.station);
  world.pitch_start_rad = 0.0;
  world.slack_start_m = 0.0;
  run->nominal.arm_at_zero_rad = SeatedArm(models.nominal.rover, models.nominal.station);
}

BuiltRun BuildRun(const Scenario& scenario, const AxelModels& models) {
  CheckBearing(scenario);
  BuiltRun run;
  WorldSetup& world = run.world;
  world.rover = models.built.rover;
  world.station = models.built.station;
  world.soil = models.built.soil;
  const Lying built = LyingAt(world.rover, models.keys.start);
  world.arm_start_rad = built.arm;
  world.pitch_start_rad = built.body;
  run.start_place = scenario.start_place;
  run.yard_place = scenario.yard_place;

  // What the controller is told; the lines that follow disturb the world only.
  const ModelSet& told = models.nominal;
  // The arm's encoder is absolute (assumed): the angle at power-on is known.
  run.nominal = MakeNominal(told.rover, told.station, LyingAt(told.rover, models.keys.start).arm,
                            models.nominal.soil.gravity_m_s2);
  run.nominal.vision = models.keys.vision;
  if (!std::isnan(models.keys.bracket_stops)) {
    run.nominal.vision.bracket_stops = models.keys.bracket_stops;
  } else if (!WhyNoBracket(scenario, models).empty()) {
    run.nominal.vision.bracket_stops = 0.0;
  }
  run.nominal.tsai2013 = models.keys.tsai2013;
  run.nominal.excursion_m = models.keys.excursion_m;
  RandomStream start(StreamKey(scenario.seed, "start"));
  const double pitch_rad = 2.0 * kPi / std::max(1, world.rover.left_wheel_soil.paddle_count);
  world.rover.left_wheel_soil.phase_rad = start.Uniform(0.0, pitch_rad);
  world.rover.right_wheel_soil.phase_rad = start.Uniform(0.0, pitch_rad);
  world.slack_start_m = start.Uniform(0.02, 0.10);  // assumed: loosely picked up, range 0-0.2
  world.ground = MakeGround(scenario.yard, scenario.seed);
  world.patch_soils =
      PatchSoils(scenario.yard, world.soil.gravity_m_s2, world.rover.left_wheel_soil.width_m);
  world.X_WG = scenario.X_WG;
  world.slope = SlopeOf(scenario);
  world.X_DR_start = FromDockingCoords(scenario.start.on_plane());
  if (models.keys.excursion_m > 0.0) StartSeated(models, &run);
  world.rocks = BuildRocks(scenario, models, world.ground);
  run.nominal.rock_map =
      RockMapOf(models.keys.rock_map, world.rocks, world.ground, world.X_GD, scenario.seed);
  world.station_move = models.keys.station_move;
  world.paddles_print = models.keys.soil_marks != SoilMarks::kRuts;
  world.body_marks_soil = models.keys.soil_marks == SoilMarks::kAll;
  world.step_s = scenario.physics_step_s;
  if (const std::string part = StartsInRock(world); !part.empty()) {
    throw ConfigError(scenario.rocks_place + ": expected no rock in the rover's " + part +
                      " at the start");
  }

  if (const std::string wrong = StartsWrong(world); !wrong.empty()) {
    throw ConfigError(scenario.start_place + ": expected further links of the rover that start " +
                      "within their joints' limits and above the ground: " + wrong);
  }
  if (const std::string links = StartsInItself(world.rover, world.arm_start_rad); !links.empty()) {
    throw ConfigError(scenario.start_place +
                      ": expected links of the rover that are clear of each "
                      "other at the start, " +
                      links + " are not");
  }
  CheckImagesCanBeDrawn(world.rover.stereo.nominal, scenario.camera_place);
  CheckStationHolds(scenario, world.station);
  run.built_rig = BuiltRig(world.rover.stereo, scenario.seed);
  run.ripples = BuiltRipples(world.rover.stereo, scenario.seed);
  run.X_WD = SiteOf(scenario) * FromGround(world.X_GD, 0.0);
  run.lighting = MakeLighting(scenario.light, run.X_WD, BoardInDock(world.station).p, scenario.seed,
                              scenario.sun);
  AddScenery(scenario, world.ground, SiteOf(scenario), world.X_GD, run.lighting);
  run.lighting.board_dust = models.keys.board_dust;
  run.lighting.dusty_spots =
      DustyMarks(models.keys.dirty_marks, world.station.board, scenario.seed);
  return run;
}

}  // namespace dockyard::axel
