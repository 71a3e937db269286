#include "raposa/controller/kinematic_robot.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "controller/motion/arcs.h"
#include "controller/raposa/ferreira2009.h"
#include "controller/raposa/odometry.h"

namespace dockyard::raposa {
namespace {

constexpr double kStep_s = kTickSeconds * kControlPeriod;
// The guide is on its seat this far before the camera (models/raposa/raposa.yaml). A robot that
// drives on would push the pyramid; here it stands.
constexpr double kSeat_m = 0.05;

class KinematicRobot {
 public:
  KinematicRobot(const Nominal& nominal, const KinematicWorld& world, const Pose2& X_PC)
      : nominal_(nominal), world_(world), X_PN_(X_PC * Pose2{-world.lever_m, 0.0, 0.0}) {}

  SensorFrame Sense() {
    SensorFrame frame;
    frame.tick = tick_;
    frame.motors.resize(kMotorCount);
    frame.motors[0].encoder_counts = std::llround(left_rad_ / nominal_.motors[0].rad_per_count);
    frame.motors[1].encoder_counts = std::llround(right_rad_ / nominal_.motors[1].rad_per_count);
    const bool answers = ++senses_ % world_.every == 0 && time_s() < world_.camera_until_s;
    if (asked_from_ && answers) {
      const Scene scene = world_.scene_at ? world_.scene_at(time_s()) : world_.scene;
      frame.images = {{kBackCamera, Draw(nominal_, *asked_from_, scene), tick_ - kControlPeriod}};
    }
    return frame;
  }

  void Step(const Commands& commands) {
    asked_from_.reset();
    if (!commands.take_images.empty()) asked_from_ = X_PC();
    const double left = Speed(commands.motors[0]) * kStep_s;
    const double right = Speed(commands.motors[1]) * kStep_s;
    left_rad_ += left;
    right_rad_ += right;
    const BeltMotion motion = MotionOfBelts(nominal_, left, right);
    const Pose2 next = Advance(X_PN_, Arc{motion.length_m, world_.turn_share * motion.turn_rad});
    const Eigen::Vector2d guide =
        Inverse(next * Pose2{world_.lever_m, 0.0, 0.0}) * Eigen::Vector2d::Zero();
    if (guide.norm() > kSeat_m) X_PN_ = next;
    tick_ += kControlPeriod;
  }

  Pose2 X_PC() const { return X_PN_ * Pose2{world_.lever_m, 0.0, 0.0}; }
  double time_s() const { return kTickSeconds * static_cast<double>(tick_); }

 private:
  static double Speed(const MotorCommand& belt) {
    return belt.mode == MotorMode::kVelocity ? belt.target : 0.0;
  }

  Nominal nominal_;
  KinematicWorld world_;
  Pose2 X_PN_;
  std::optional<Pose2> asked_from_;
  double left_rad_ = 0.0, right_rad_ = 0.0;
  Tick tick_ = 0;
  int senses_ = 0;
};

}  // namespace

double KinematicRun::ahead_m() const { return (Inverse(X_PC) * Eigen::Vector2d::Zero()).x(); }
double KinematicRun::aside_m() const { return (Inverse(X_PC) * Eigen::Vector2d::Zero()).y(); }
double KinematicRun::off_axis_rad() const { return WrapPi(X_PC.heading - kPi); }
bool KinematicRun::reached() const {
  return verdict == Verdict::kDone && std::abs(ahead_m() - 0.09) < 0.05 &&
         std::abs(aside_m()) < 0.015 && std::abs(off_axis_rad()) < Radians(18.0);
}

KinematicRun RunKinematic(const Nominal& nominal, const Pose2& X_PC, const KinematicWorld& world,
                          double limit_s) {
  KinematicRobot robot(nominal, world, X_PC);
  const auto controller = MakeFerreira2009Controller(nominal);
  KinematicRun run;
  while (run.verdict == Verdict::kUnderWay && robot.time_s() < limit_s) {
    const Commands commands = controller->Step(robot.Sense());
    const Belief& belief = controller->belief();
    const Pose2 at = robot.X_PC();
    if (run.phases.empty() || run.phases.back() != belief.phase) {
      const bool passed = !run.phases.empty() && run.phases.back() == "align";
      if (passed) run.after_passes.push_back(at);
      run.phases.push_back(belief.phase);
    }
    const int passes = static_cast<int>(ValueOf(belief, "passes", 0.0));
    if (passes > run.passes) run.estimates_deg.push_back(ValueOf(belief, "alpha_deg", 0.0));
    run.passes = passes;
    const double r_m = std::hypot(at.x, at.y);
    if (commands.switches[kLamps] && run.lamps_from_m == 0.0) run.lamps_from_m = r_m;
    const double arm_rad = commands.motors[static_cast<std::size_t>(Motor::kArm)].target;
    if (arm_rad > 0.0 && run.arm_from_m == 0.0) run.arm_from_m = r_m;
    run.most_arm_rad = std::max(run.most_arm_rad, arm_rad);
    robot.Step(commands);
    run.verdict = commands.verdict;
    run.last = commands;
  }
  run.time_s = robot.time_s();
  run.X_PC = robot.X_PC();
  run.belief = controller->belief();
  return run;
}

KinematicRun RunKinematicAt(double r_m, double alpha_deg, const KinematicWorld& world,
                            double limit_s) {
  return RunKinematic(TestNominal(world.lever_m), CameraAt(r_m, Radians(alpha_deg)), world,
                      limit_s);
}

}  // namespace dockyard::raposa
