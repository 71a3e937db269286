#include "axel/controller/kinematic_rover.h"

#include <algorithm>
#include <cmath>

#include "controller/axel/machine.h"
#include "controller/axel/odometry.h"
#include "controller/axel/tether_length.h"

namespace dockyard::axel {
namespace {

constexpr double kPlay = Radians(1.5);  // of the seated arm, to either side
constexpr double kStep = kTickSeconds * kControlPeriod;
constexpr double kTetherStiffness = 5000.0;  // [N/m]
constexpr double kSpoolFriction = 0.5;       // [Nm]

const MotorCommand& Of(const Commands& commands, Motor motor) {
  return commands.motors[static_cast<std::size_t>(motor)];
}

double Approach(double value, double target, double step) {
  return value + std::clamp(target - value, -step, step);
}

}  // namespace

Nominal TestNominal() {
  Nominal nominal;
  nominal.rig.left = nominal.rig.right = EquidistantCamera(1024, 768, Radians(90.0));
  Eigen::Matrix3d R_RC;
  R_RC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  nominal.rig.X_RL = {R_RC, {0.05, 0.175, 0.22}};
  nominal.rig.X_RQ = {R_RC, {0.05, -0.175, 0.22}};
  nominal.board.width_m = 0.9;
  nominal.board.height_m = 0.5;
  const double tip_angle = Radians(5.0);
  Pose3 X_MB;
  X_MB.R << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  X_MB.p = {0.0, 0.0, 0.18};
  nominal.mouth_height_m = 0.37;
  nominal.X_DB = Pose3{RotY(tip_angle), {0.0, 0.0, nominal.mouth_height_m}} * X_MB;
  const NominalMotor wheel{1e-3, 15.0, 0.2, 4.0, 1.0, 3.0};
  nominal.motors = {wheel, wheel, NominalMotor{1e-4, 20.0, 0.2, 5.0, 0.5, 2.0},
                    NominalMotor{1e-4, 10.0, 0.2, 2.2, 2.0, 5.0}};
  nominal.wheel_radius_m = 0.30;
  nominal.paddle_pitch_m = 0.15;
  nominal.track_m = 0.85;
  nominal.arm_length_m = 1.0;
  nominal.drum_radius_m = 0.06;
  nominal.anchor_depth_m = 0.35;
  nominal.spool_friction_n = 8.0;
  nominal.station_weight_n = 343.0;
  nominal.station_friction = 0.4;
  nominal.station_back_m = 0.40;
  nominal.station_spread_m = 0.354;
  nominal.throat_depth_m = 0.12;
  nominal.seat_depth_m = 0.23;
  return nominal;
}

KinematicRover::KinematicRover(const Nominal& nominal, const KinematicWorld& world,
                               const Pose2& X_DR)
    : nominal_(nominal), world_(world), noise_(StreamKey(world.seed, "vision")), X_DR_(X_DR) {
  free_m_ = Path() + world.slack_m;
}

double KinematicRover::depth_m() const {
  return -(X_DR_.x + nominal_.arm_length_m * std::cos(X_DR_.heading));
}
double KinematicRover::tip_offset_m() const {
  return X_DR_.y + nominal_.arm_length_m * std::sin(X_DR_.heading);
}
double KinematicRover::Path() const {
  return ExposedTether(TetherGeometryOf(nominal_), X_DR_, elevation_);
}

SensorFrame KinematicRover::Sense() {
  SensorFrame frame = StillFrame();
  frame.tick = tick_;
  frame.imu.yaw_rad = yaw_;
  frame.imu.pitch_rad = pitch_;
  const auto count = [&](Motor motor, double angle) {
    const auto i = static_cast<std::size_t>(motor);
    frame.motors[i].encoder_counts = std::llround(angle / nominal_.motors[i].rad_per_count);
  };
  // Wheels count against the body.
  count(Motor::kLeftWheel, left_ - pitch_);
  count(Motor::kRightWheel, right_ - pitch_);
  count(Motor::kArm, arm_ - nominal_.arm_at_zero_rad);
  // The drum winds past the arm's root.
  count(Motor::kSpool, reeled_m_ / nominal_.drum_radius_m + arm_ - nominal_.arm_at_zero_rad);
  const double currents_a[] = {0.5, 0.5, 0.3, spool_current_};
  for (std::size_t i = 0; i < frame.motors.size(); ++i) frame.motors[i].current_a = currents_a[i];
  const bool moves = left_speed_ != 0.0 || right_speed_ != 0.0;
  if (images_due_) on_the_way_ = Exposed{tick_, X_DR_, pitch_};
  if (images_due_ && moves && world_.images_lost) on_the_way_.reset();
  images_due_ = false;
  if (on_the_way_ && tick_ - on_the_way_->tick >= world_.images_late) {
    seen_ = *on_the_way_;
    on_the_way_.reset();
    frame.images = {{kLeftCamera, GrayImage{}, seen_.tick},
                    {kRightCamera, GrayImage{}, seen_.tick}};
  }
  return frame;
}

// Elevation that puts the tip on the cone's axis, blended in from the mouth to the throat.
double KinematicRover::Guided() const {
  const double axis = nominal_.mouth_height_m + depth_m() * std::sin(Radians(5.0));
  const double seated = std::asin((axis - nominal_.wheel_radius_m) / nominal_.arm_length_m);
  return seated * std::clamp(depth_m() / nominal_.throat_depth_m, 0.0, 1.0);
}

void KinematicRover::MoveWheels(const Commands& commands) {
  const MotorCommand& left = Of(commands, Motor::kLeftWheel);
  const MotorCommand& right = Of(commands, Motor::kRightWheel);
  wheels_free_ = left.mode == MotorMode::kFree;
  const auto run = [](const MotorCommand& wheel, double* speed) {
    const double target = wheel.mode == MotorMode::kVelocity ? wheel.target : 0.0;
    const double slope = wheel.mode == MotorMode::kVelocity ? wheel.accel_rad_s2 : 5.0;
    *speed = Approach(*speed, target, slope * kStep);
  };
  run(left, &left_speed_);
  run(right, &right_speed_);
  left_ += left_speed_ * kStep;
  right_ += right_speed_ * kStep;
  const double forward = 0.5 * nominal_.wheel_radius_m * (left_speed_ + right_speed_);
  const double turn = nominal_.wheel_radius_m * (right_speed_ - left_speed_) / nominal_.track_m;
  // A slack tether gives the wheels nothing to push against: the arm lifts instead.
  const bool slack = tension_n_ < 10.0 && forward > 0.01;
  elevation_ = slack ? std::min(elevation_ + Radians(10.0) * kStep, 1.2)
                     : Approach(elevation_, Guided(), Radians(10.0) * kStep);
  const bool held = forward > 0.0 && world_.held_at_m && X_DR_.x <= *world_.held_at_m;
  const bool digs = forward < 0.0 && world_.held_back_at_m && X_DR_.x >= *world_.held_back_at_m;
  dug_ = dug_ || digs;
  const double progress =
      slack || held || digs || elevation_ > Radians(15.0) ? 0.0 : 1.0 - world_.slip;
  const double turned = turn * (1.0 - world_.heading_short) * kStep;
  X_DR_ = Advance(X_DR_, Arc{forward * progress * kStep, turned});
  yaw_ += turned + world_.yaw_drift_rad_s * kStep;
}

void KinematicRover::MoveArm(const Commands& commands) {
  const MotorCommand& arm = Of(commands, Motor::kArm);
  if (arm.mode == MotorMode::kPosition) {
    const double target = arm.target + nominal_.arm_at_zero_rad;
    arm_ = Approach(arm_, target, arm.speed_limit_rad_s * kStep);
  }
  // The arm lies in space where the tether puts it; the body follows by the joint. Braked wheels
  // hold the body.
  const bool braked = Of(commands, Motor::kLeftWheel).mode == MotorMode::kBrake;
  if (!braked) pitch_ = -elevation_ - arm_;
}

void KinematicRover::MoveSpool(const MotorCommand& command) {
  const NominalMotor& spool = nominal_.motors[static_cast<std::size_t>(Motor::kSpool)];
  const auto tension = [&] { return std::max(0.0, kTetherStiffness * (Path() - free_m_)); };
  if (command.mode == MotorMode::kVelocity) {
    const double torque =
        std::max(0.0, command.current_limit_a - spool.no_load_current_a) * spool.torque_per_amp_nm;
    const double friction = kSpoolFriction / nominal_.drum_radius_m;
    const double pull = std::max(0.0, torque / nominal_.drum_radius_m - friction);
    const double dragged = torque / nominal_.drum_radius_m + friction;
    reel_speed_ = Approach(reel_speed_, command.target * nominal_.drum_radius_m,
                           command.accel_rad_s2 * nominal_.drum_radius_m * kStep);
    double change = reel_speed_ * kStep;
    const double room = Path() - pull / kTetherStiffness;  // free length at which it stalls
    if (change > 0.0) change = std::clamp(free_m_ - room, 0.0, change);
    if (tension() > dragged) change = free_m_ - (Path() - dragged / kTetherStiffness);
    free_m_ -= change;
    reeled_m_ += change;
    if (change < reel_speed_ * kStep - 1e-9) reel_speed_ = 0.0;
    const double carried = std::min(tension() * nominal_.drum_radius_m + kSpoolFriction, torque);
    spool_current_ = spool.no_load_current_a + carried / spool.torque_per_amp_nm;
  } else {
    reel_speed_ = 0.0;
    spool_current_ = 0.0;
  }
  tension_n_ = tension();
}

// Free wheels under a pull: the tip goes where the tether pulls it, axle and arm behind it.
void KinematicRover::PullAlong() {
  if (!wheels_free_ || tension_n_ <= world_.roll_tension_n) return;
  const double step =
      std::min((tension_n_ - world_.roll_tension_n) / kTetherStiffness, 0.05 * kStep);
  const double aside = WrapPi(std::atan2(-tip_offset_m(), depth_m()) - X_DR_.heading);
  const bool outside = depth_m() < 0.0;
  const double turn = outside ? std::sin(aside) * step / nominal_.arm_length_m : 0.0;
  const double way = outside ? std::cos(aside) * step : step;
  X_DR_ = Advance(X_DR_, Arc{way, turn});
  yaw_ += turn;
  left_ += way / nominal_.wheel_radius_m;
  right_ += way / nominal_.wheel_radius_m;
}

// Inside the mouth the cone leads the tip to the axis; the arm turns about the axle.
void KinematicRover::Guide(const Pose2& before) {
  if (depth_m() > world_.jam_depth_m.value_or(nominal_.seat_depth_m)) {
    yaw_ -= WrapPi(X_DR_.heading - before.heading);
    X_DR_ = before;
    return;
  }
  if (depth_m() <= 0.0) {
    entry_.reset();
    return;
  }
  if (!entry_) entry_ = Entry{tip_offset_m(), WrapPi(X_DR_.heading - kPi)};
  const double off = tip_offset_m() * std::max(0.0, 1.0 - depth_m() / 0.12);
  const double sine = std::clamp((X_DR_.y - off) / nominal_.arm_length_m, -1.0, 1.0);
  // Behind the throat the collar lays the arm straight within its play, and the axle slides aside.
  const double most = depth_m() > nominal_.throat_depth_m ? kPlay : 0.5 * kPi;
  const double lean = std::clamp(std::asin(sine), -most, most);
  X_DR_.y = off + nominal_.arm_length_m * std::sin(lean);
  const double heading = kPi + lean;
  yaw_ += WrapPi(heading - X_DR_.heading);
  X_DR_.heading = WrapPi(heading);
}

void KinematicRover::Step(const Commands& commands) {
  const Pose2 before = X_DR_;
  MoveWheels(commands);
  MoveArm(commands);
  PullAlong();
  Guide(before);
  MoveSpool(Of(commands, Motor::kSpool));
  images_due_ = !commands.take_images.empty();
  tick_ += kControlPeriod;
}

LocateOutput KinematicRover::Locate() {
  ++sightings_;
  const Eigen::Vector2d p_DB = nominal_.X_DB.p.head<2>();
  Pose2 X_DR = seen_.X_DR;
  const Eigen::Vector2d to = p_DB - Eigen::Vector2d(X_DR.x, X_DR.y);
  const double range = to.norm();
  const double bearing = WrapPi(std::atan2(to.y(), to.x()) - X_DR.heading);
  const double half = std::atan2(0.5 * nominal_.board.width_m, range);
  const bool seen = !world_.blind && range < world_.marks_range_m && range > 0.6 &&
                    std::abs(bearing) + 0.5 * half < Radians(45.0);
  LocateOutput out{PoseFailure::kTooFewFiducials, {}};
  out.report.reason = Name(PoseFailure::kTooFewFiducials);
  if (!seen) return out;
  const double k = world_.vision_noise;
  // Noise as cameras make it: the board is seen too far or near, aside, and turned.
  const double new_range = range + k * 0.008 * range * range * noise_.Normal();
  const double new_bearing = bearing + k * Radians(0.3) * noise_.Normal();
  X_DR.heading = WrapPi(X_DR.heading + k * Radians(1.0) * range * noise_.Normal());
  const double towards = X_DR.heading + new_bearing;
  X_DR.x = p_DB.x() - new_range * std::cos(towards);
  X_DR.y = p_DB.y() - new_range * std::sin(towards);
  const Pose3 X_HR{RotY(seen_.pitch), Eigen::Vector3d::Zero()};
  const Pose3 X_RB = Inverse(FromGround(X_DR, nominal_.wheel_radius_m) * X_HR) * nominal_.X_DB;
  out.sighting = DockSighting{X_RB, 1.0, 14, true};
  out.report.accepted = true;
  out.report.reason.clear();
  out.report.X_RB = X_RB;
  return out;
}

KinematicRun RunKinematic(const KinematicWorld& world, const DockingCoords& start,
                          const AxelOptions& options, double limit_s) {
  Nominal nominal = TestNominal();
  nominal.vision.while_driving = world.while_driving;
  nominal.shutter_s = 0.005;
  KinematicRover rover(nominal, world, FromDockingCoords(start));
  const auto controller = MakeAxelMachine(
      nominal, options, [&](const StereoImages&, const LocateHints&) { return rover.Locate(); });
  KinematicRun run;
  const int steps = static_cast<int>(limit_s / kStep);
  for (int i = 0; i < steps && run.verdict == Verdict::kUnderWay; ++i) {
    const Commands commands = controller->Step(rover.Sense());
    const std::string& phase = controller->belief().phase;
    if (run.phases.empty() || run.phases.back() != phase) run.phases.push_back(phase);
    // The tip comes free once it has been backed out.
    if (phase == "recover") rover.Unjam();
    if (phase == "tighten" || phase == "out") rover.ComeOff();
    rover.Step(commands);
    run.commands.push_back(commands);
    run.verdict = commands.verdict;
    run.max_elevation_rad = std::max(run.max_elevation_rad, rover.elevation_rad());
    const bool mating = phase == "reel" || phase == "confirm" || phase == "docked";
    if (!mating) run.max_way_tension_n = std::max(run.max_way_tension_n, rover.tension_n());
    run.time_s = (i + 1) * kStep;
    if (i % 50 == 0) run.path.push_back(rover.X_DR());
  }
  run.depth_m = rover.depth_m();
  run.entry = rover.entry();
  run.belief = controller->belief();
  run.sightings = rover.sightings();
  return run;
}

}  // namespace dockyard::axel
