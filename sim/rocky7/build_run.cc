#include "sim/rocky7/build_run.h"

#include <cmath>
#include <stdexcept>

#include "controller/base/number_text.h"
#include "models/read/config_error.h"
#include "models/read/load_soil.h"
#include "models/rocky7/make_nominal.h"
#include "sim/base/random.h"
#include "sim/plant/built_cameras.h"
#include "sim/plant/scenery.h"
#include "sim/plant/yard.h"
#include "sim/rigid/rocks.h"
#include "sim/rocky7/gravel.h"
#include "sim/rocky7/placeable_rock.h"
#include "sim/scenario/rock_keys.h"
#include "sim/vehicles/boulder.h"
#include "sim/vehicles/rounded_rock.h"

namespace dockyard::rocky7 {
namespace {

// Wheels of 65 mm leave ruts that coarser cells do not hold. Assumed, 5-20 mm.
constexpr double kCoarsest_m = 0.01;
// Level about the target. Assumed, 0.05-0.3 m.
constexpr double kFlatRadius_m = 0.1;
// Of a loose stone, length 1 and width 0.8: the mean of both.
constexpr double kMeanOfLength = 0.9;
// Between the target and a stone of the field, at least [m].
constexpr double kApart_m = 0.005;
// The rover at its start: a disc about the middle of its wheels, in R.
constexpr double kRoverRadius_m = 0.45;
const Eigen::Vector2d kMiddle_R(0.17, 0.0);

void CheckStep(const Scenario& scenario) {
  if (scenario.physics_step_s <= kLongestStep_s) return;
  throw ConfigError(scenario.step_place + ": expected at most " + NumberText(kLongestStep_s) +
                    " s for Rocky 7, found " + NumberText(scenario.physics_step_s));
}

void CheckYard(const Scenario& scenario) {
  if (scenario.yard.cell_m <= kCoarsest_m) return;
  throw ConfigError(scenario.yard_place + ": expected yard.cell_m of at most " +
                    NumberText(kCoarsest_m) + " m, fine enough for Rocky 7's wheels, found " +
                    NumberText(scenario.yard.cell_m));
}

ConvexBody TargetStone(const Rocky7Keys& keys, const Seed& seed) {
  const ConvexBody body_D =
      RockShape({keys.diameter_m, keys.height_m}, keys.buried, 0.0, StreamKey(seed, "target"));
  return FromGround({0.0, 0.0, keys.turn_rad}, 0.0) * body_D;
}

StarBody RockOf(const Scenario& scenario, const Rocky7Keys& keys, const RobotModel& robot,
                const Pose2& X_GR_start, std::uint64_t key) {
  const RoundedRockShape shape{.width_m = keys.boulder_m,
                               .target_up_m = keys.target_up_m,
                               .face_up_rad = keys.face_up_rad,
                               .face_turn_rad = keys.face_turn_rad,
                               .roughness_m = keys.roughness_m};
  const Eigen::Vector3d camera_G = MastCameraAtStart(robot, X_GR_start);
  auto rock = FirstRock(shape, key, [&](const StarBody& drawn) {
    return ShowsTarget(drawn, shape, camera_G) &&
           (!keys.placeable || IsPlaceable(drawn, shape, robot.rover));
  });
  if (rock) return *std::move(rock);
  throw ConfigError(scenario.start_place +
                    ": expected a rounded rock whose target is in view from there" +
                    (keys.placeable ? ", and on which the mast can place its instrument," : "") +
                    " found none with rocky7.face_up_deg " + NumberText(Degrees(keys.face_up_rad)) +
                    " at rocky7.target_up_m " + NumberText(keys.target_up_m));
}

StarBody BoulderOf(const Scenario& scenario, const Rocky7Keys& keys, const RobotModel& robot,
                   const Pose2& X_GR_start, std::uint64_t key) {
  if (keys.boulder == BoulderKind::kRounded) return RockOf(scenario, keys, robot, X_GR_start, key);
  const BoulderShape shape{.width_m = keys.boulder_m,
                           .target_up_m = keys.target_up_m,
                           .face_up_rad = keys.face_up_rad,
                           .face_turn_rad = keys.face_turn_rad,
                           .rim_m = keys.rim_m,
                           .roughness_m = keys.roughness_m};
  return MakeBoulder(shape, key);
}

/// Whether a stone of the field would lie in the target, or under the rover at its start.
bool IsInTheWay(const Rock& rock, const Rocky7Keys& keys, const Pose2& X_DR) {
  if (rock.given) return false;
  const double half_m = 0.5 * rock.size.diameter_m;
  const double own_m = keys.task == Task::kPlace ? 2.0 * keys.boulder_m : keys.diameter_m;
  if (rock.p_D.norm() < 0.5 * own_m + half_m + kApart_m) return true;
  return (Inverse(X_DR) * rock.p_D - kMiddle_R).norm() < kRoverRadius_m + half_m;
}

/// Those that wheels and scoops move are loose, but the target of a drive is not.
void AddStones(const Scenario& scenario, const Rocky7Keys& keys, BuiltRun& run) {
  WorldSetup& world = run.world;
  const auto lift = [&](double x_m, double y_m) {
    return Pose3::Translation(0.0, 0.0, world.ground.Height(x_m, y_m));
  };
  if (keys.task == Task::kReach) {
    world.stones.push_back(lift(0.0, 0.0) * TargetStone(keys, scenario.seed));
  }
  if (!HasRocks(scenario.rocks)) return;
  const YardModel& yard = scenario.yard;
  const GroundArea area{-kYardBehind_m, yard.length_m - kYardBehind_m, -0.5 * yard.width_m,
                        0.5 * yard.width_m};
  try {
    for (const Rock& rock :
         PlaceRocks(scenario.rocks, area, {{0.0, 0.0}}, StreamKey(scenario.seed, "rocks"))) {
      if (IsInTheWay(rock, keys, world.X_GR_start)) continue;
      const bool loose = rock.size.diameter_m < keys.loose_below_m &&
                         rock.p_D.norm() < keys.loose_within_m + 0.5 * rock.size.diameter_m;
      (loose ? world.loose_stones : world.stones)
          .push_back(lift(rock.p_D.x(), rock.p_D.y()) * rock.body);
    }
    std::vector<ConvexBody> stones = world.stones;
    stones.insert(stones.end(), world.loose_stones.begin(), world.loose_stones.end());
    run.gravel = GravelAbout(keys, scenario.rocks, world.ground, stones, scenario.seed);
  } catch (const std::length_error&) {
    throw ConfigError(scenario.rocks_place + ": expected at most " + std::to_string(kMostRocks) +
                      " rocks in the yard; a lower cover, a larger least_m or a smaller yard has "
                      "fewer");
  }
}

// The attitude in which a stone to be grasped lies.
Eigen::Matrix3d AttitudeOfTarget(const Rocky7Keys& keys, const ConvexBody& shape,
                                 const Seed& seed) {
  const Eigen::Matrix3d turn = RotZ(keys.turn_rad);
  if (keys.lies == TargetLies::kFlat) return turn;
  return turn * RestingTurn(shape, StreamKey(seed, "attitude"));
}

}  // namespace

BuiltRun BuildRun(const Scenario& scenario, const Rocky7Models& models) {
  CheckStep(scenario);
  CheckYard(scenario);
  CheckCarries(models.built.soil, scenario.soil_file, models.built.robot.rover.tyre.width_m);
  const RobotModel& robot = models.built.robot;
  for (const StereoModel* pair : {&robot.front, &robot.back, &robot.mast_pair}) {
    CheckImagesCanBeDrawn(pair->nominal, scenario.camera_place);
  }
  BuiltRun run;
  run.keys = models.keys;
  WorldSetup& world = run.world;
  world.robot = models.built.robot;
  world.soil = models.built.soil;
  world.ground = YardGround(scenario.yard, kFlatRadius_m, scenario.seed);
  world.patch_soils =
      PatchSoils(scenario.yard, world.soil.gravity_m_s2, world.robot.rover.tyre.width_m);
  world.X_WG = scenario.X_WG;
  world.slope = {scenario.yard.slope_rad, scenario.yard.downhill_rad};
  DockingCoords at = scenario.start.on_plane();
  if (!std::isnan(models.keys.off_target_rad)) at.h = at.alpha + models.keys.off_target_rad;
  world.X_GR_start = FromDockingCoords(at);
  AddStones(scenario, models.keys, run);
  if (models.keys.task == Task::kGrasp) {
    world.loose_target =
        LooseStoneShape(models.keys.diameter_m / kMeanOfLength, StreamKey(scenario.seed, "target"));
    world.R_GT_start = AttitudeOfTarget(models.keys, *world.loose_target, scenario.seed);
    world.target_buried = models.keys.buried;
  }
  if (models.keys.task == Task::kPlace) {
    world.boulder = BoulderOf(scenario, models.keys, models.nominal.robot, world.X_GR_start,
                              StreamKey(scenario.seed, "target"));
    world.target_G = {0.0, 0.0, models.keys.target_up_m};
  }
  world.stone_friction = scenario.rocks.friction;
  world.step_s = scenario.physics_step_s;
  run.front = BuiltRig(robot.front, scenario.seed);
  run.back = BuiltRig(robot.back, scenario.seed, "back_calibration");
  run.mast_pair = BuiltRig(robot.mast_pair, scenario.seed, "mast_calibration");
  run.front_ripples = BuiltRipples(robot.front, scenario.seed);
  run.back_ripples = BuiltRipples(robot.back, scenario.seed, "back_calibration");
  run.mast_ripples = BuiltRipples(robot.mast_pair, scenario.seed, "mast_calibration");
  run.lighting = MakeLighting(scenario.light, SiteInWorld(world.X_WG, world.slope),
                              {0.0, 0.0, 0.5 * models.keys.height_m}, scenario.seed, scenario.sun);
  AddScenery(scenario, world.ground, SiteInWorld(world.X_WG, world.slope), Pose2{}, run.lighting);
  run.nominal = MakeNominal(models.nominal.robot);
  if (models.keys.task == Task::kGrasp) {
    // Not the point where the arm reaches the ground, but the one where its scoops close.
    run.nominal.plan.p_RP = GraspPoint(run.nominal.arm, run.nominal.rolling_radius_m);
    world.robot.rover.plan.p_RP = run.nominal.plan.p_RP;
  }
  run.nominal.task = models.keys.task;
  run.nominal.reach_m = models.keys.reach_m;
  run.nominal.nesnas = models.keys.nesnas;
  run.nominal.compute_s = models.keys.compute_s;
  return run;
}

}  // namespace dockyard::rocky7
