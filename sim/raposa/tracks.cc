#include "sim/raposa/tracks.h"

#include <cmath>

#include "sim/base/hash.h"

namespace dockyard::raposa {
namespace {

// Assumed, 15-42 mm: 32 pads round the main belt, nine of them in contact; eight are enough.
constexpr double kPadPitch_m = 0.042;

BeltModel BeltOf(const BeltsModel& belts, double rear_m, double front_m, double y_m) {
  BeltModel belt;
  belt.front = {.x_m = front_m, .radius_m = belts.roller_radius_m};
  belt.rear = {.x_m = rear_m, .radius_m = belts.roller_radius_m};
  belt.y_m = y_m;
  belt.width_m = belts.width_m;
  const double round_m = 2.0 * (front_m - rear_m) + 2.0 * kPi * belts.roller_radius_m;
  belt.pads = static_cast<int>(std::lround(round_m / kPadPitch_m));
  belt.sprocket_radius_m = belts.roller_radius_m;
  belt.stiffness_pa_per_m = belts.stiffness_pa_per_m;
  belt.damping_pa_s_per_m = belts.damping_pa_s_per_m;
  belt.shear_stiffness_pa_per_m = belts.shear_stiffness_pa_per_m;
  belt.shear_damping_pa_s_per_m = belts.shear_damping_pa_s_per_m;
  return belt;
}

std::array<Belt, 2> BothSides(const RobotModel& robot, const std::vector<GroundModel>& grounds,
                              double rear_m, double front_m) {
  const double y_m = 0.5 * robot.belts.gauge_m;
  return {BeltOn(grounds, BeltOf(robot.belts, rear_m, front_m, y_m)),
          BeltOn(grounds, BeltOf(robot.belts, rear_m, front_m, -y_m))};
}

MotorDrive DriveOf(const RobotModel& robot, Motor motor) {
  const MotorModel& model = robot.motors[static_cast<std::size_t>(motor)];
  return {model, model.reflected_inertia_kg_m2};
}

}  // namespace

BeltModel BodyBeltOf(const RobotModel& robot, double y_m) {
  return BeltOf(robot.belts, robot.belts.body_rear_m, robot.belts.body_front_m, y_m);
}

Belt BeltOn(const std::vector<GroundModel>& grounds, const BeltModel& model) {
  const auto on = [&](const GroundModel& ground) {
    return ground.soil ? Belt(model, *ground.soil, ground.belt.rolling_loss)
                       : Belt(model, ground.belt);
  };
  Belt belt = on(grounds.front());
  for (std::size_t i = 1; i < grounds.size(); ++i) belt.AddGround(on(grounds[i]));
  return belt;
}

Tracks::Tracks(const RobotModel& robot, const std::vector<GroundModel>& grounds, const Seed& seed)
    : radius_m_(robot.belts.roller_radius_m),
      inertia_kg_m2_(
          robot.motors[static_cast<std::size_t>(Motor::kLeftBelt)].reflected_inertia_kg_m2),
      offset_rad_s_(robot.belts.speed_offset *
                    robot.motors[static_cast<std::size_t>(Motor::kLeftBelt)].max_speed_rad_s),
      drift_time_s_(robot.belts.drift_time_s),
      dead_band_rad_s_(robot.belts.dead_band_m_s / radius_m_),
      drift_(StreamKey(seed, "belt_speed")),
      drives_{DriveOf(robot, Motor::kLeftBelt), DriveOf(robot, Motor::kRightBelt)},
      body_belts_(BothSides(robot, grounds, robot.belts.body_rear_m, robot.belts.body_front_m)),
      arm_belts_(BothSides(robot, grounds, 0.0, robot.belts.arm_length_m)) {
  for (double& error : error_rad_s_) error = offset_rad_s_ * drift_.Normal();
  const BeltGround& ground = grounds.front().belt;
  const FrictionPatches patches{ground.patch_scatter, ground.patch_m, StreamKey(seed, "friction")};
  for (auto* const belts : {&body_belts_, &arm_belts_}) {
    for (Belt& belt : *belts) belt.SetPatches(patches);
  }
}

// A first-order Gauss-Markov process.
void Tracks::Wander(double dt_s) {
  const double kept = std::exp(-dt_s / drift_time_s_);
  const double fresh = offset_rad_s_ * std::sqrt(1.0 - kept * kept);
  for (double& error : error_rad_s_) error = kept * error + fresh * drift_.Normal();
}

MotorCommand Tracks::Obeyed(const MotorCommand& command, std::size_t side) const {
  if (command.mode != MotorMode::kVelocity) return command;
  MotorCommand obeyed = command;
  if (std::abs(command.target) <= dead_band_rad_s_) {
    obeyed.target = 0.0;
  } else {
    obeyed.target -= error_rad_s_[side];
  }
  return obeyed;
}

void Tracks::Step(const HeightGrid& ground, const std::array<MotorCommand, 2>& commands,
                  double dt_s, TreeBody& robot) {
  Wander(dt_s);
  const LinkMotion &body = robot.motion(kBody), &arm = robot.motion(kArm);
  const Eigen::Vector3d y_G = body.X_GL.R.col(1);
  for (std::size_t side = 0; side < 2; ++side) {
    const double surface_m_s = radius_m_ * speed_rad_s_[side];
    const BeltLoad on_body = body_belts_[side].Step(ground, body, surface_m_s, dt_s);
    const BeltLoad on_arm = arm_belts_[side].Step(ground, arm, surface_m_s, dt_s);
    const double arm_nm = on_arm.drive_torque_nm;
    robot.AddForce(kBody, on_body.force_G, body.X_GL.p);
    robot.AddTorque(kBody, on_body.torque_G - arm_nm * y_G);
    robot.AddForce(kArm, on_arm.force_G, arm.X_GL.p);
    robot.AddTorque(kArm, on_arm.torque_G + arm_nm * y_G);

    output_[side] = drives_[side].Step(Obeyed(commands[side], side), angle_rad_[side],
                                       speed_rad_s_[side], dt_s);
    const double load_nm = on_body.drive_torque_nm + arm_nm;
    speed_rad_s_[side] += dt_s * (output_[side].torque_nm() - load_nm) / inertia_kg_m2_;
    angle_rad_[side] += dt_s * speed_rad_s_[side];
    const bool driven = commands[side].mode == MotorMode::kVelocity &&
                        std::abs(commands[side].target) > dead_band_rad_s_;
    read_rad_[side] += dt_s * (speed_rad_s_[side] + (driven ? error_rad_s_[side] : 0.0));
  }
}

std::uint64_t Tracks::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (std::size_t side = 0; side < 2; ++side) {
    for (const double value :
         {read_rad_[side], angle_rad_[side], speed_rad_s_[side], error_rad_s_[side]}) {
      hash = HashDouble(hash, value);
    }
    hash = drives_[side].StateHash(hash);
    hash = arm_belts_[side].StateHash(body_belts_[side].StateHash(hash));
  }
  return hash;
}

}  // namespace dockyard::raposa
