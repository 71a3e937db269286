#include "sim/rocky7/world.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <variant>

#include "controller/base/check.h"
#include "sim/base/hash.h"
#include "sim/rocky7/boulder_meeting.h"

namespace dockyard::rocky7 {
namespace {

// The rover is put down with its axles at the height that they have above hard ground, and comes to
// rest within this time.
constexpr double kSettle_s = 2.0;
// Beyond this from R no part of the body is. Half a bogie's bar is that thick; assumed, 5-20 mm.
constexpr double kNearby_m = 0.6, kBogie_m = 0.01;
// The body is looked after every so many steps: at 0.1 m/s it moves by 2 mm.
constexpr long kLookEvery = 20;

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

}  // namespace

World::World(const WorldSetup& setup)
    : setup_(setup),
      X_WG_(SiteInWorld(setup.X_WG, setup.slope)),
      gravity_G_(GravityInSite(setup.slope)),
      rover_(setup.robot.rover, SoilsOf(setup), StartPose(setup)),
      imu_(setup.robot.imu, gravity_G_),
      stones_(setup.stones, SoilsOf(setup), setup.ground, setup.robot.rover.tyre,
              setup.stone_friction),
      loose_(ArmParts(*setup.robot.rover.arm, rover_.arm().link(0)), SoilsOf(setup),
             {.friction = setup.stone_friction}),
      face_(setup.robot.rover.mast->instrument, rover_.mast_link(kMastElbow),
            setup.robot.rover.mast->link2_m) {
  DOCKYARD_CHECK(setup.step_s > 0.0 && setup.step_s <= kLongestStep_s);
  if (setup.loose_target) {
    loose_.Add(LooseStone(*setup.loose_target, kStoneDensity_kg_m3,
                          StandingAt(*setup.loose_target, {0.0, 0.0}, setup.target_turn_rad,
                                     setup.ground.Height(0.0, 0.0))));
  }
  if (setup.boulder) {
    rover_.PutMast(setup.robot.rover.mast->watch_rad);
    rover_.tree().SetAngle(rover_.arm().link(kArmRoll), setup.robot.rover.arm->roll_stop_rad);
  }
  const std::vector<MotorCommand> braked(static_cast<std::size_t>(rover_.motor_count()));
  const long settle = std::lround(kSettle_s / setup.step_s);
  for (long i = 0; i < settle; ++i) Step(braked);
  steps_ = 0;
  if (loose_.count() > 0) target_start_m_ = loose_.stone(0).motion().X_GL.p.z();
  imu_.Start(rover_.body());
}

void World::Step(const std::vector<MotorCommand>& commands) {
  stones_.AddLoads(setup_.step_s, rover_);
  if (setup_.boulder) {
    face_.Step(*setup_.boulder, setup_.step_s, rover_.tree());
    most_face_n_ = std::max(most_face_n_, face_.force_n());
  }
  rover_.TakeLoads(commands, gravity_G_, setup_.step_s, setup_.ground);
  loose_.Step(rover_.tree(), gravity_G_, setup_.step_s, setup_.ground);
  rover_.Move(setup_.step_s);
  imu_.Add(rover_.body(), setup_.step_s);
  if (steps_ % kLookEvery == 0) on_stone_ = on_stone_ || MeetsStone();
  ++steps_;
}

// Below the body, and about the bogies' hinges, which hang between the wheels.
bool World::MeetsStone() const {
  if (setup_.boulder && MeetsBoulder(rover_, setup_.robot, *setup_.boulder)) return true;
  const LinkModel& body = setup_.robot.rover.body;
  const auto* box = std::get_if<BoxShape>(&body.collisions.front().shape);
  const Eigen::AlignedBox3d under(Eigen::Vector3d(body.p_LoCom_L - 0.5 * box->size_m),
                                  Eigen::Vector3d(body.p_LoCom_L + 0.5 * box->size_m));
  const Pose3 X_BG = Inverse(rover_.body().X_GL);
  for (std::size_t s = 0; s < setup_.stones.size(); ++s) {
    const ConvexBody& stone = setup_.stones[s];
    const Eigen::Vector3d sunk_G(0.0, 0.0, -stones_.sunk_m(s));
    if ((stone.centre - rover_.body().X_GL.p).norm() > kNearby_m + stone.radius_m) continue;
    for (const Eigen::Vector3d& vertex : stone.vertices) {
      if (under.contains(X_BG * (vertex + sunk_G))) return true;
    }
    for (const bool left : {false, true}) {
      const Eigen::Vector3d p_G = rover_.bogie_place_G(left) - sunk_G;
      if (DistanceTo(stone, p_G).distance_m < kBogie_m) return true;
    }
  }
  return false;
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
  truth.p_GF = outer.X_GL.p + setup_.robot.rover.mast->link2_m * truth.axis_G;
  truth.closed = face_.closed();
  truth.face_n = face_.force_n();
  truth.most_face_n = most_face_n_;
  if (setup_.boulder) truth.p_GP = truth.p_GF;
  truth.X_GT = setup_.boulder       ? Pose3{Eigen::Matrix3d::Identity(), setup_.target_G}
               : loose_.count() > 0 ? loose_.stone(0).motion().X_GL
               : setup_.stones.empty()
                   ? Pose3{}
                   : Pose3::Translation(0.0, 0.0, setup_.stones.front().centre.z());
  if (loose_.count() > 0) truth.target_rise_m = truth.X_GT.p.z() - target_start_m_;
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
  return face_.StateHash(loose_.StateHash(
      stones_.StateHash(rover_.StateHash(HashBits(seed, static_cast<std::uint64_t>(steps_))))));
}

}  // namespace dockyard::rocky7
