#include "sim/axel/world.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "controller/base/check.h"
#include "controller/geometry/axle_attitude.h"
#include "models/parts/gravity.h"
#include "sim/axel/rover_start.h"
#include "sim/axel/world_impl.h"
#include "sim/base/hash.h"

namespace dockyard::axel {
namespace {

// Rover and station come to rest before the run begins: within this time [s] (assumed, range 1-3).
constexpr double kSettleSeconds = 1.5;
// They have, once no body was faster than this for a third of the time in which the rover swings
// about its axle, 0.3 s: what is left then is a swing of 0.1 mm. Assumed, ranges 0.3-3 mm/s and
// mrad/s, 0.05-0.3 s.
constexpr double kRest_m_s = 1e-3, kRest_rad_s = 3e-3, kRestSeconds = 0.1;

void CheckSetup(const WorldSetup& setup) {
  DOCKYARD_CHECK(setup.step_s > 0.0 && setup.step_s <= 5e-3);
  DOCKYARD_CHECK(setup.slack_start_m >= 0.0);
  DOCKYARD_CHECK(setup.ground.nx > 1 && setup.ground.ny > 1);
  DOCKYARD_CHECK(!setup.station.feet.empty());
  DOCKYARD_CHECK(setup.rover.arm_length_m > 0.0);
}

// The soils in which the rover's tip and body leave marks, by the ground's numbers.
std::vector<SoilModel> MarkedSoils(const WorldSetup& setup) {
  if (!setup.body_marks_soil) return {};
  std::vector<SoilModel> soils{setup.soil};
  soils.insert(soils.end(), setup.patch_soils.begin(), setup.patch_soils.end());
  return soils;
}

// A foot's force over its depth [N/m]: of one with a sole, at an equal share of the weight.
double FootStiffness(const WorldSetup& setup, std::size_t soil) {
  const StationModel& station = setup.station;
  const SinkingPlate sole =
      SoleOf(station, soil == 0 ? setup.soil : setup.patch_soils.at(soil - 1));
  if (sole.force_n_per_m_n == 0.0) return station.foot_stiffness_n_per_m;
  const double share_n =
      station.module.mass_kg * -GravityOf(setup).z() / static_cast<double>(station.feet.size());
  return share_n / DepthUnder(sole, share_n);
}

// On its feet, each pressed in by its share of the weight: the height and the two small tilts at
// which the feet's forces and gravity balance. Feet and ground are springs, so this is linear.
Pose3 StationStart(const WorldSetup& setup, const HeightGrid& ground) {
  const StationModel& station = setup.station;
  const Eigen::Vector3d com_D =
      MouthInStation(station) *
      Eigen::Vector3d(station.module.p_LoCom_L - station.mouth_height_m * Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d weight_D =
      station.module.mass_kg * (RotZ(-setup.X_GD.heading) * GravityOf(setup));
  Eigen::Matrix3d stiffness = Eigen::Matrix3d::Zero();
  Eigen::Vector3d load = Eigen::Vector3d::Zero();
  double sole_m = 0.0;
  std::vector<Eigen::Vector4d> feet;  // how its sole goes up with height and tilts; ground above it
  for (const FootModel& foot : station.feet) {
    const Eigen::Vector3d& p = foot.p_SF;
    const Eigen::Vector2d at = setup.X_GD * Eigen::Vector2d(p.x(), p.y());
    feet.emplace_back(1.0, p.y(), -p.x(), ground.Height(at.x(), at.y()) - p.z());
    const Eigen::Vector3d rise = feet.back().head<3>();
    const double foot_stiffness_n_per_m = FootStiffness(setup, ground.SoilAt(at.x(), at.y()));
    stiffness += foot_stiffness_n_per_m * rise * rise.transpose();
    load += foot_stiffness_n_per_m * feet.back()[3] * rise;
    sole_m += p.z() / static_cast<double>(station.feet.size());
  }
  // Weight, and its moments about the soles below the dock's origin: it leans on a slope.
  const double above_m = com_D.z() - sole_m;
  load += Eigen::Vector3d(weight_D.z(), com_D.y() * weight_D.z() - above_m * weight_D.y(),
                          above_m * weight_D.x() - com_D.x() * weight_D.z());
  const Eigen::Vector3d up = stiffness.ldlt().solve(load);
  for (const Eigen::Vector4d& foot : feet) {
    // A foot that would pull: it tips, and the steps show how.
    if (foot[3] < foot.head<3>().dot(up)) return FromGround(setup.X_GD, up[0]);
  }
  Pose3 X_GS = FromGround(setup.X_GD, up[0]);
  X_GS.R = X_GS.R * RotY(up[2]) * RotX(up[1]);
  return X_GS;
}

}  // namespace

Eigen::Vector3d GravityOf(const WorldSetup& setup) {
  return setup.soil.gravity_m_s2 / kEarthGravity_m_s2 * GravityInSite(setup.slope);
}

World::Impl::Impl(WorldSetup setup)
    : setup_((CheckSetup(setup), std::move(setup))),
      X_WG_(SiteInWorld(setup_.X_WG, setup_.slope)),
      gravity_G_(GravityOf(setup_)),
      ground_(std::move(setup_.ground)),
      rigid_(gravity_G_),
      rover_(rigid_, setup_.rover, RoverStart(setup_, ground_), setup_.arm_start_rad,
             setup_.add_right_side_first),
      station_(rigid_, setup_.station, StationStart(setup_, ground_),
               SoleOf(setup_.station, setup_.soil)),
      hand_(setup_.station_move),
      contacts_(rigid_, setup_.rover, setup_.station, rover_, station_),
      drives_(setup_.rover, setup_.arm_start_rad),
      tether_(setup_.rover.tether, setup_.station, setup_.rover.arm_length_m),
      rover_ground_(setup_.rover, MarkedSoils(setup_)),
      left_soil_(setup_.rover.left_wheel_soil, setup_.soil),
      right_soil_(setup_.rover.right_wheel_soil, setup_.soil),
      imu_(setup_.rover.imu, gravity_G_) {
  for (const SoilModel& soil : setup_.patch_soils) {
    station_.AddSole(SoleOf(setup_.station, soil));
    left_soil_.AddSoil(soil);
    right_soil_.AddSoil(soil);
  }
  if (setup_.paddles_print) {
    left_soil_.PrintPaddles();
    right_soil_.PrintPaddles();
  }
  contacts_.PutRocks(setup_.rover, setup_.rocks);
  Settle();
}

void World::Impl::TieTether() {
  tether_tied_ = true;
  if (setup_.rover.tether.law == TetherLaw::kCable) {
    cable_.emplace(setup_.rover, setup_.station, setup_.rocks.rocks);
    tether_at_start_m_ = cable_->TieUp(rover_, station_, ground_, gravity_G_, setup_.slack_start_m);
    return;
  }
  const Eigen::Vector3d p_MT = TipInMouth();
  tether_.LayOut(p_MT, 1.0);
  tether_at_start_m_ = tether_.path_m() + setup_.slack_start_m;
  tether_.LayOut(p_MT, tether_at_start_m_);
}

void World::Impl::Settle() {
  const std::array<MotorCommand, kMotorCount> braked{};
  // A rover below the station hangs on its tether. Without it, braked wheels and body roll downhill
  // as one and turn the arm over the top.
  if (setup_.slope.angle_rad != 0.0) TieTether();
  const auto StepsIn = [&](double seconds) {
    return static_cast<int>(std::lround(seconds / setup_.step_s));
  };
  const int most = StepsIn(kSettleSeconds), enough = StepsIn(kRestSeconds);
  for (int i = 0, slow = 0; i < most && slow < enough; ++i) {
    Step(braked);
    slow = NoneFaster(kRest_m_s, kRest_rad_s) ? slow + 1 : 0;
  }
  steps_ = 0;
  drives_.PowerOn(rover_);
  imu_.Start(rover_.motion(RoverLink::kBody));
  contacts_.ForgetPeaks();
  settled_ = true;
  p_GM_start_ = station_.X_GM().p;
  if (!tether_tied_) TieTether();
  still_steps_ = 0;
}

bool World::Impl::NoneFaster(double m_s, double rad_s) const {
  const auto Slow = [&](const LinkMotion& link) {
    return link.v_GL_G.squaredNorm() < m_s * m_s && link.w_GL_G.squaredNorm() < rad_s * rad_s;
  };
  for (int i = 0; i < rover_.link_count(); ++i) {
    if (!Slow(rover_.motion(static_cast<RoverLink>(i)))) return false;
  }
  return Slow(station_.motion());
}

bool World::Impl::IsStill() const {
  if (rover_.further_drives().runs()) return false;
  if (cable_ && cable_->fastest_m_s() > kStillCable_m_s) return false;
  const double slower = cable_ ? kSlowerWithCable : 1.0;
  return NoneFaster(slower * kStill_m_s, slower * kStill_rad_s) &&
         drives_.IsStill(kStill_rad_s, setup_.step_s);
}

void World::Impl::Step(const std::array<MotorCommand, kMotorCount>& commands) {
  if (commands != last_commands_) still_steps_ = 0;
  last_commands_ = commands;
  if (settled_ && hand_.Holds(time_s())) still_steps_ = 0;
  if (!at_rest()) Move(commands);
  imu_.Add(rover_.motion(RoverLink::kBody), setup_.step_s);
  ++steps_;
}

void World::Impl::Move(const std::array<MotorCommand, kMotorCount>& commands) {
  const double tension = tether_tied_ ? PullTether() : 0.0;
  drives_.Step(commands, tension, setup_.step_s, rover_);
  rover_.further_drives().Step(settled_, setup_.step_s, rover_.tree());
  RollOnSoil();
  rover_ground_.AddForces(ground_, setup_.step_s, rover_);
  station_.AddFeetForces(ground_, setup_.step_s);
  if (settled_ && hand_.Holds(time_s())) hand_.Hold(time_s(), station_);
  contacts_.Step(setup_.step_s);
  still_steps_ = setup_.may_rest && IsStill() ? still_steps_ + 1 : 0;
}

double World::Impl::PullCable() {
  const double free = tether_at_start_m_ + drives_.tether_given_m(rover_);
  pull_.tension_n = cable_->Step(ground_, gravity_G_, free, drives_.tether_rate_m_s(rover_),
                                 setup_.step_s, rover_, station_);
  return pull_.tension_n;
}

double World::Impl::PullTether() {
  if (cable_) return PullCable();
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
  if (setup_.add_right_side_first) RollWheel(RoverLink::kRightWheel, right_soil_, loads_[1]);
  RollWheel(RoverLink::kLeftWheel, left_soil_, loads_[0]);
  if (!setup_.add_right_side_first) RollWheel(RoverLink::kRightWheel, right_soil_, loads_[1]);
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
  hash = rigid_.StateHash(hash);
  hash = station_.StateHash(hash);
  hash = drives_.StateHash(hash);
  hash = rover_.further_drives().StateHash(hash);
  hash = tether_.StateHash(hash);
  if (cable_) hash = cable_->StateHash(hash);
  hash = rover_ground_.StateHash(hash);
  hash = left_soil_.StateHash(hash);
  hash = right_soil_.StateHash(hash);
  return HashBits(hash, ground_.revision);
}

World::World(const WorldSetup& setup) {
  // A wheel that stands on one paddle rolls off it as it settles, by up to half a paddle's pitch.
  // So the rover is put down twice, the second time as far aside as it rolled the first time.
  const Pose2 rolled = AxleOnGround(Impl(setup).MakeTruth().X_DR);
  WorldSetup placed = setup;
  placed.X_DR_start = setup.X_DR_start * Inverse(rolled) * setup.X_DR_start;
  impl_ = std::make_unique<Impl>(std::move(placed));
}
World::~World() = default;
void World::Step(const std::array<MotorCommand, kMotorCount>& commands) { impl_->Step(commands); }
Tick World::tick() const { return impl_->tick(); }
bool World::at_rest() const { return impl_->at_rest(); }
Truth World::truth() const { return impl_->MakeTruth(); }
const HeightGrid& World::ground() const { return impl_->ground(); }
TrueImu World::TakeTrueImu() { return impl_->TakeTrueImu(); }
std::uint64_t World::StateHash(std::uint64_t seed) const { return impl_->StateHash(seed); }

}  // namespace dockyard::axel
