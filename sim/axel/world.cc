#include "sim/axel/world.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/axel/world_impl.h"
#include "sim/base/hash.h"

namespace dockyard::axel {
namespace {

// Rover and station come to rest before the run begins [s] (assumed, range 1-3).
constexpr double kSettleSeconds = 1.5;

void Require(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

void CheckSetup(const WorldSetup& setup) {
  Require(setup.step_s > 0.0 && setup.step_s <= 5e-3, "physics step must be in (0, 5] ms");
  Require(setup.slack_start_m >= 0.0, "the tether cannot start shorter than its way");
  Require(setup.ground.nx > 1 && setup.ground.ny > 1, "the ground has no cells");
  Require(!setup.station.feet.empty(), "the station has no feet");
  Require(setup.rover.arm_length_m > 0.0, "the arm has no length");
}

// Above the ground by the radius of the wheels, its body along the ground.
Pose3 RoverStart(const WorldSetup& setup) {
  const Pose2 X_GR = setup.X_GD * setup.X_DR_start;
  double z = -1e9;
  for (bool left : {true, false}) {
    const Eigen::Vector3d& p = left ? setup.rover.p_R_left_wheel : setup.rover.p_R_right_wheel;
    const WheelModel& wheel = left ? setup.rover.left_wheel_soil : setup.rover.right_wheel_soil;
    const Eigen::Vector2d at = X_GR * Eigen::Vector2d(p.x(), p.y());
    z = std::max(z, setup.ground.Height(at.x(), at.y()) + RollingRadius(wheel) - p.z());
  }
  return FromGround(X_GR, z);
}

// On its feet, each pressed in by its share of the weight.
double PressedIn(const WorldSetup& setup, double load_n) {
  const SinkingPlate sole = SoleOf(setup.station, setup.soil);
  return sole.force_n_per_m_n > 0.0 ? DepthUnder(sole, load_n)
                                    : load_n / setup.station.foot_stiffness_n_per_m;
}

Pose3 StationStart(const WorldSetup& setup) {
  double z = 0.0;
  for (const FootModel& foot : setup.station.feet) {
    const Eigen::Vector2d at = setup.X_GD * Eigen::Vector2d(foot.p_SF.x(), foot.p_SF.y());
    z += setup.ground.Height(at.x(), at.y()) - foot.p_SF.z();
  }
  const double count = static_cast<double>(setup.station.feet.size());
  const double weight_n = setup.station.module.mass_kg * -GravityInSite(setup.slope).z();
  return FromGround(setup.X_GD, z / count - PressedIn(setup, weight_n / count));
}

}  // namespace

World::Impl::Impl(const WorldSetup& setup)
    : setup_((CheckSetup(setup), setup)),
      X_WG_(SiteInWorld(setup.X_WG, setup.slope)),
      gravity_G_(GravityInSite(setup.slope)),
      ground_(setup.ground),
      rover_(setup.rover, RoverStart(setup), setup.arm_start_rad, setup.add_right_side_first),
      station_(setup.station, StationStart(setup), SoleOf(setup.station, setup.soil)),
      contacts_(setup.station.cone, gravity_G_, rover_, station_),
      drives_(setup.rover, setup.arm_start_rad),
      tether_(setup.rover.tether, setup.station, setup.rover.arm_length_m),
      rover_ground_(setup.rover),
      left_soil_(setup.rover.left_wheel_soil, setup.soil),
      right_soil_(setup.rover.right_wheel_soil, setup.soil),
      imu_(setup.rover.imu.p_RI, gravity_G_) {
  setup_.ground = HeightGrid{};  // the live one is ground_
  Settle();
}

void World::Impl::TieTether() {
  const Eigen::Vector3d p_MT = TipInMouth();
  tether_.LayOut(p_MT, 1.0);
  tether_at_start_m_ = tether_.path_m() + setup_.slack_start_m;
  tether_.LayOut(p_MT, tether_at_start_m_);
  tether_tied_ = true;
}

void World::Impl::Settle() {
  const std::array<MotorCommand, kMotorCount> braked{};
  // A rover below the station hangs on its tether. Without it, braked wheels and body roll downhill
  // as one and turn the arm over the top.
  if (setup_.slope.angle_rad != 0.0) TieTether();
  const int steps = static_cast<int>(std::lround(kSettleSeconds / setup_.step_s));
  for (int i = 0; i < steps; ++i) Step(braked);
  steps_ = 0;
  drives_.PowerOn(rover_);
  imu_.Start(rover_.motion(RoverLink::kBody));
  p_GM_start_ = station_.X_GM().p;
  if (!tether_tied_) TieTether();
  still_steps_ = 0;
}

bool World::Impl::IsStill() const {
  const auto Still = [](const LinkMotion& link) {
    return link.v_GL_G.squaredNorm() < kStillMPerS * kStillMPerS &&
           link.w_GL_G.squaredNorm() < kStillRadPerS * kStillRadPerS;
  };
  for (int i = 0; i < kRoverLinkCount; ++i) {
    if (!Still(rover_.motion(static_cast<RoverLink>(i)))) return false;
  }
  return Still(station_.motion()) && drives_.IsStill(kStillRadPerS, setup_.step_s);
}

void World::Impl::Step(const std::array<MotorCommand, kMotorCount>& commands) {
  if (commands != last_commands_) still_steps_ = 0;
  last_commands_ = commands;
  if (!at_rest()) Move(commands);
  imu_.Add(rover_.motion(RoverLink::kBody), setup_.step_s);
  ++steps_;
}

void World::Impl::Move(const std::array<MotorCommand, kMotorCount>& commands) {
  const double tension = tether_tied_ ? PullTether() : 0.0;
  drives_.Step(commands, tension, setup_.step_s, rover_);
  RollOnSoil();
  rover_ground_.AddForces(ground_, setup_.step_s, rover_);
  station_.AddFeetForces(ground_, setup_.step_s);
  contacts_.Step(setup_.step_s);
  still_steps_ = setup_.may_rest && IsStill() ? still_steps_ + 1 : 0;
}

double World::Impl::PullTether() {
  const double free = tether_at_start_m_ + drives_.tether_given_m(rover_);
  pull_ = tether_.Step(TipInMouth(), TipVelocityInMouth(), free, drives_.tether_rate_m_s(rover_));
  if (pull_.tension_n == 0.0) return 0.0;
  const Pose3 X_GM = station_.X_GM();
  rover_.AddForce(RoverLink::kArm, X_GM.R * pull_.force_on_tip_M, TipInG());
  for (int i = 0; i < pull_.nodes; ++i) {
    station_.AddForce(X_GM.R * pull_.force_on_station_M[i], X_GM * pull_.p_M[i]);
  }
  return pull_.tension_n;
}

void World::Impl::RollOnSoil() {
  if (setup_.add_right_side_first) RollWheel(RoverLink::kRightWheel, right_soil_, right_load_);
  RollWheel(RoverLink::kLeftWheel, left_soil_, left_load_);
  if (!setup_.add_right_side_first) RollWheel(RoverLink::kRightWheel, right_soil_, right_load_);
}

void World::Impl::RollWheel(RoverLink link, WheelSoil& soil, WheelLoad& load) {
  const LinkMotion& wheel = rover_.motion(link);
  load = soil.Step(ground_, {wheel.X_GL, wheel.v_GL_G, wheel.w_GL_G}, setup_.step_s);
  rover_.AddForce(link, load.force_G, wheel.X_GL.p);
  rover_.AddTorque(link, load.torque_G);
}

Eigen::Vector3d World::Impl::TipInG() const {
  return rover_.motion(RoverLink::kArm).X_GL * Eigen::Vector3d(setup_.rover.arm_length_m, 0.0, 0.0);
}

Eigen::Vector3d World::Impl::TipInMouth() const {
  const Pose3 X_GM = station_.X_GM();
  return X_GM.R.transpose() * (TipInG() - X_GM.p);
}

Eigen::Vector3d World::Impl::TipVelocityInMouth() const {
  const Eigen::Vector3d p_G = TipInG();
  return station_.X_GM().R.transpose() *
         (rover_.motion(RoverLink::kArm).VelocityAt(p_G) - station_.motion().VelocityAt(p_G));
}

Tick World::Impl::tick() const {
  return std::llround(static_cast<double>(steps_) * setup_.step_s / kTickSeconds);
}

std::uint64_t World::Impl::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashBits(seed, static_cast<std::uint64_t>(steps_));
  hash = rover_.StateHash(hash);
  hash = station_.StateHash(hash);
  hash = drives_.StateHash(hash);
  hash = tether_.StateHash(hash);
  hash = rover_ground_.StateHash(hash);
  hash = left_soil_.StateHash(hash);
  hash = right_soil_.StateHash(hash);
  return HashBits(hash, ground_.revision);
}

World::World(const WorldSetup& setup) {
  // A wheel that stands on one paddle rolls off it as it settles, by up to half a paddle's pitch.
  // So the rover is put down twice, the second time as far aside as it rolled the first time.
  const Pose2 settled = ToGround(Impl(setup).MakeTruth().X_DR);
  WorldSetup placed = setup;
  placed.X_DR_start = setup.X_DR_start * Inverse(settled) * setup.X_DR_start;
  impl_ = std::make_unique<Impl>(placed);
}
World::~World() = default;
void World::Step(const std::array<MotorCommand, kMotorCount>& commands) { impl_->Step(commands); }
Tick World::tick() const { return impl_->tick(); }
bool World::at_rest() const { return impl_->at_rest(); }
Truth World::truth() const { return impl_->MakeTruth(); }
const HeightGrid& World::ground() const { return impl_->ground(); }
ImuSample World::TakeTrueImu() { return impl_->TakeTrueImu(); }
std::uint64_t World::StateHash(std::uint64_t seed) const { return impl_->StateHash(seed); }

}  // namespace dockyard::axel
