#include "sim/rocky7/world.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"
#include "sim/vehicles/rover_parts.h"

namespace dockyard::rocky7 {
namespace {

// The rover is put down with its axles at the height that they have above hard ground, and comes to
// rest within this time.
constexpr double kSettle_s = 2.0;
// The housing of a mast's camera; assumed, 15-40 mm.
constexpr double kCamera_m = 0.02;

Pose3 StartPose(const WorldSetup& setup) {
  const Pose2& at = setup.X_GR_start;
  double highest_m = -1e9;
  for (const WheelPlan& wheel : setup.robot.rover.plan.wheels) {
    const Eigen::Vector2d p_G = at * wheel.p_RW;
    highest_m = std::max(highest_m, setup.ground.Height(p_G.x(), p_G.y()));
  }
  return FromGround(at, highest_m + RollingRadius(setup.robot.rover.tyre));
}

// By the ground's numbers.
std::vector<SoilModel> SoilsOf(const WorldSetup& setup) {
  std::vector<SoilModel> soils{setup.soil};
  soils.insert(soils.end(), setup.patch_soils.begin(), setup.patch_soils.end());
  return soils;
}

// Of stones on each other: as metal on them (rover_model.h).
ContactMaterial StoneOnStone(const WorldSetup& setup) {
  return {2e4, 40.0, setup.stone_friction, 0.0};
}

void AddMastCameras(const WorldSetup& setup, const WheeledBody& rover, PartContacts& parts) {
  ContactMaterial material = setup.robot.rover.contacts.body;
  material.friction = setup.stone_friction;
  const StereoRig& pair_K = setup.robot.mast_pair.nominal;
  for (const Eigen::Vector3d& p_K : {pair_K.X_RL.p, pair_K.X_RQ.p}) {
    parts.Add({.at = {rover.number(), rover.mast_link(kMastElbow)},
               .body_L = BoxAt(p_K, Eigen::Vector3d::Constant(kCamera_m)),
               .is_bar = true,
               .material = material,
               .groups = {part_group::kMast, part_group::kStones | part_group::kChassis}});
  }
}

}  // namespace

World::World(const WorldSetup& setup)
    : setup_(setup),
      X_WG_(SiteInWorld(setup.X_WG, setup.slope)),
      world_(GravityInSite(setup.slope)),
      rover_(world_, setup.robot.rover, SoilsOf(setup), StartPose(setup)),
      imu_(setup.robot.imu, GravityInSite(setup.slope)),
      parts_(world_),
      stones_(setup.stones, SoilsOf(setup), setup.ground),
      loose_(world_, SoilsOf(setup), setup.stone_friction),
      face_(setup.robot.rover.mast->instrument, {rover_.number(), rover_.mast_link(kMastCan)},
            setup.robot.rover.mast->link2_m) {
  DOCKYARD_CHECK(setup.step_s > 0.0 && setup.step_s <= kLongestStep_s);
  AddRoverParts(setup.robot.rover, rover_, setup.stone_friction, parts_);
  AddMastCameras(setup, rover_, parts_);
  rover_parts_ = parts_.count();
  const PartGroups fixed{part_group::kBeddedStones, part_group::kRover | part_group::kLooseStones};
  if (setup.boulder) parts_.Add(BoulderPart(*setup.boulder, fixed));
  stones_.AddTo(parts_, StoneOnStone(setup), fixed);
  if (setup.loose_target) AddLooseTarget();
  loose_targets_ = loose_.count();
  for (const ConvexBody& stone_G : setup.loose_stones) {
    AddLoose(MakeLooseStone(stone_G, kStoneDensity_kg_m3));
  }
  if (setup.boulder) {
    rover_.PutMast(setup.robot.rover.mast->watch_rad);
    rover_.tree().SetAngle(rover_.arm().link(kArmRoll), setup.robot.rover.arm->roll_stop_rad);
  }
  const std::vector<MotorCommand> braked(static_cast<std::size_t>(rover_.motor_count()));
  const long settle = std::lround(kSettle_s / setup.step_s);
  for (long i = 0; i < settle; ++i) Step(braked);
  steps_ = 0;
  if (loose_targets_ > 0) target_start_m_ = loose_.motion(0).X_GL.p.z();
  imu_.Start(rover_.body());
}

void World::AddLooseTarget() {
  const ConvexBody& shape = *setup_.loose_target;
  AddLoose(MakeLooseStone(shape, kStoneDensity_kg_m3,
                          StandingAt(shape, setup_.R_GT_start, {0.0, 0.0},
                                     setup_.ground.Height(0.0, 0.0), setup_.target_buried)));
}

void World::AddLoose(const LooseStone& stone) {
  const int number = loose_.Add(stone);
  loose_.Bed(number, setup_.ground);
  parts_.Add({.at = {loose_.body(number), 0},
              .body_L = stone.shape_S,
              .material = StoneOnStone(setup_),
              .groups = {part_group::kLooseStones, part_group::kRover | part_group::kStones}});
}

void World::Step(const std::vector<MotorCommand>& commands) {
  rover_.AddLoads(commands, setup_.step_s, setup_.ground);
  parts_.AddContacts();
  if (setup_.boulder) face_.AddContacts(*setup_.boulder, world_);
  loose_.AddSoilContacts(setup_.ground, setup_.step_s);
  world_.Step(setup_.step_s);
  face_.TakeForces(world_, setup_.step_s);
  most_face_n_ = std::max(most_face_n_, face_.force_n());
  stones_.Sink(world_, setup_.step_s, parts_);
  loose_.Rest(setup_.ground, setup_.step_s);
  imu_.Add(rover_.body(), setup_.step_s);
  on_stone_ = on_stone_ || MeetsStone();
  ++steps_;
}

bool World::MeetsStone() const {
  // Stones and the boulder come after the rover's parts.
  const auto& met = parts_.met();
  return std::any_of(met.begin(), met.end(), [&](const PartContacts::Met& at) {
    const int group = parts_.part(at.a).groups.group;
    return at.b >= rover_parts_ && (group & (part_group::kChassis | part_group::kMast)) != 0;
  });
}

Truth World::truth() const {
  Truth truth;
  truth.time_s = time_s();
  const LinkMotion& body = rover_.body();
  truth.X_WR = X_WG_ * body.X_GL;
  for (int i = 0; i < rover_.tree().link_count(); ++i) {
    truth.X_WL.push_back(X_WG_ * rover_.tree().motion(i).X_GL);
  }
  truth.v_WR_W = X_WG_.R * body.v_GL_G;
  truth.w_WR_W = X_WG_.R * body.w_GL_G;
  truth.X_GR = ToGround(body.X_GL);
  const Eigen::Vector2d& p_RP = setup_.robot.rover.plan.p_RP;
  truth.p_GP =
      body.X_GL * Eigen::Vector3d(p_RP.x(), p_RP.y(), -RollingRadius(setup_.robot.rover.tyre));
  const LinkMotion& outer = rover_.tree().motion(rover_.mast_link(kMastElbow));
  truth.X_WK = X_WG_ * outer.X_GL;
  truth.v_WK_W = X_WG_.R * outer.v_GL_G;
  truth.w_WK_W = X_WG_.R * outer.w_GL_G;
  truth.axis_G = outer.X_GL.R.col(0);
  truth.p_GF = rover_.tree().motion(rover_.mast_link(kMastCan)).X_GL.p +
               setup_.robot.rover.mast->link2_m * truth.axis_G;
  truth.closed = face_.closed();
  truth.face_n = face_.force_n();
  truth.most_face_n = most_face_n_;
  if (setup_.boulder) truth.p_GP = truth.p_GF;
  truth.X_GT = setup_.boulder       ? Pose3{Eigen::Matrix3d::Identity(), setup_.target_G}
               : loose_targets_ > 0 ? loose_.motion(0).X_GL
               : setup_.stones.empty()
                   ? Pose3{}
                   : Pose3::Translation(0.0, 0.0, setup_.stones.front().centre.z());
  if (loose_targets_ > 0) truth.target_rise_m = truth.X_GT.p.z() - target_start_m_;
  for (int i = loose_targets_; i < loose_.count(); ++i) truth.X_GS.push_back(loose_.motion(i).X_GL);
  for (int i = 0; i < rover_.motor_count(); ++i) {
    truth.motors.push_back({rover_.angle_rad(i), rover_.rate_rad_s(i), rover_.output(i).torque_nm(),
                            rover_.output(i).current_a, rover_.output(i).lead_rad});
  }
  const int wheels = static_cast<int>(setup_.robot.rover.plan.wheels.size());
  for (int i = 0; i < wheels; ++i) truth.sinkage_m += rover_.load(i).sinkage_m / wheels;
  for (std::size_t i = 0; i < setup_.stones.size(); ++i) truth.sunk_m.push_back(stones_.sunk_m(i));
  truth.stone_force_n = stones_.force_n();
  truth.on_stone = on_stone_;
  return truth;
}

TrueImu World::TakeTrueImu() { return imu_.Take(rover_.body(), X_WG_); }

std::uint64_t World::StateHash(std::uint64_t seed) const {
  const std::uint64_t bodies = world_.StateHash(HashBits(seed, static_cast<std::uint64_t>(steps_)));
  return loose_.StateHash(stones_.StateHash(rover_.StateHash(bodies)));
}

}  // namespace dockyard::rocky7
