#include "controller/rocky7/grasp.h"

#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

// Heights of the scoops' axis over level ground: the lips clear a stone of 5 cm with the scoops
// open; the lips are below a stone's middle (assumed, 20-40 mm).
constexpr double kAbove_m = 0.11, kDown_m = 0.03;
// Of the arm on its way down, and of the scoops as they close. Assumed, 0.05-0.2 and 0.1-0.5.
constexpr double kLower_rad_s = 0.1, kClose_rad_s = 0.25;
// Swinging out, and lifting. Assumed, 0.2-0.5 and 0.1-0.4.
constexpr double kSwing_rad_s = 0.4, kLift_rad_s = 0.2;
// A rise of the pitch motor's current over its usual one: 1.5 N m, 5 N at the arm's end. Assumed,
// 0.3-0.8 A; the usual one is learnt over half a second (assumed, 0.2-1 s).
constexpr double kTouch_a = 0.5, kLearn = 0.1;
// A scoop that resists: its motor's 0.27 N m, less 0.1 A of its own friction. Assumed, 0.3-0.8 A.
constexpr double kFeels_a = 0.45;
// One small raise: 2 mm at the arm's end; all together 4 cm. Assumed, 1-4 mm and 2-6 cm.
constexpr double kRaise_rad = 0.006, kRaiseMost_rad = 0.12;
// Scoops that are nearer together are shut: 2 mm between the lips. Assumed, 0.02-0.06 rad.
constexpr double kClosed_rad = 0.04;
// Scoops that have moved by less than 5 mrad for a second have a stable grasp. Assumed, 0.5-2 s.
constexpr double kStill_rad = 0.005;
constexpr Tick kStill = 1000;
// Ends of the phases, by time. Assumed, 5-15 s, 10-40 s and 0.5-2 s.
constexpr Tick kSwingTime = 8000, kTimeOut = 20000, kHold = 1000;
// The arm as it carries: above the cameras, out of their view. Assumed, -0.6 to -0.2.
constexpr double kCarry_rad = -0.35;
// Beyond the angles at which the arm is weighed, where it brakes: the way that it takes from its
// speed to rest, and the arrival's tolerance. Assumed, 0.03-0.1.
constexpr double kOvershoot_rad = 0.05;
// A joint has arrived within this. Assumed, 0.01-0.05.
constexpr double kThere_rad = 0.02;
// An arm that stays this far below what it should rise to is held down. Assumed, 0.05-0.2.
constexpr double kHeldDown_rad = 0.1;
// Of the shoulder in a grasp: 4 cm to a side. Assumed, 0.1-0.3.
constexpr double kMostRoll_rad = 0.2;

}  // namespace

Grasp::Grasp(const Nominal& nominal, bool ground_as_body)
    : nominal_(nominal),
      ground_as_body_(ground_as_body),
      first_(FirstArmMotor(nominal)),
      commands_(kArmMotorCount) {}

void Grasp::Start(const SensorFrame& sensed, bool weighs, double aside_m) {
  weighs_ = weighs;
  releases_ = false;
  // The lips, straight below the shoulder's axis on the ground, go aside by the roll's tangent.
  aside_rad_ = std::clamp(std::atan2(aside_m, ShoulderHeight()), -kMostRoll_rad, kMostRoll_rad);
  roll_rad_ = 0.0;  // while it is weighed
  note_.clear();
  empty_ = loaded_ = {};
  pitch_rad_ = PitchFor(kAbove_m, sensed);
  since_ = sensed.tick;
}

double Grasp::Angle(const SensorFrame& sensed, ArmMotor motor) const {
  return AngleOf(nominal_, sensed, first_ + static_cast<std::size_t>(motor));
}

double Grasp::Current(const SensorFrame& sensed, ArmMotor motor) const {
  return sensed.motors[first_ + static_cast<std::size_t>(motor)].current_a;
}

double Grasp::Open(const SensorFrame& sensed) const {
  return Angle(sensed, ArmMotor::kBackScoop) - Angle(sensed, ArmMotor::kFrontScoop);
}

double Grasp::PitchFor(double height_m, const SensorFrame& sensed) const {
  const double ground_rad = ground_as_body_ ? sensed.imu.pitch_rad : 0.0;
  return ground_rad +
         std::asin(std::clamp((ShoulderHeight() - height_m) / nominal_.arm.length_m, -1.0, 1.0));
}

void Grasp::Turn(const SensorFrame& sensed, double pitch_rad, double pitch_rad_s, double open_rad,
                 double scoop_rad_s) {
  const auto set = [&](ArmMotor motor, double target_rad, double speed_rad_s) {
    const auto i = static_cast<std::size_t>(motor);
    const NominalMotor& model = nominal_.motors[first_ + i];
    commands_[i] = MoveTo(model, target_rad, std::min(speed_rad_s, model.max_speed_rad_s));
  };
  set(ArmMotor::kRoll, roll_rad_, kSwing_rad_s);
  const double joint_rad = pitch_rad - sensed.imu.pitch_rad;
  const double upright_rad = ground_as_body_ ? -joint_rad : -pitch_rad;
  set(ArmMotor::kPitch, joint_rad, pitch_rad_s);
  set(ArmMotor::kFrontScoop, upright_rad - 0.5 * open_rad, scoop_rad_s);
  set(ArmMotor::kBackScoop, upright_rad + 0.5 * open_rad, scoop_rad_s);
}

bool Grasp::Arrived(const SensorFrame& sensed) const {
  const double off_rad =
      std::abs(Angle(sensed, ArmMotor::kPitch) + sensed.imu.pitch_rad - pitch_rad_) +
      std::abs(Open(sensed) - nominal_.arm.open_rad) +
      std::abs(Angle(sensed, ArmMotor::kRoll) - roll_rad_);
  return off_rad < kThere_rad || sensed.tick - since_ > kSwingTime;
}

void Grasp::Weigh(const SensorFrame& sensed, RisingCurrent& rise) const {
  rise.Add(Angle(sensed, ArmMotor::kPitch) + sensed.imu.pitch_rad,
           Current(sensed, ArmMotor::kPitch));
}

Load Grasp::load() const {
  return LoadOf(empty_, loaded_, nominal_.arm,
                nominal_.motors[first_ + static_cast<std::size_t>(ArmMotor::kPitch)]);
}

Event Grasp::Lower(const SensorFrame& sensed) {
  const double now_a = Current(sensed, ArmMotor::kPitch);
  if (sensed.tick - since_ < kStill / 2) usual_a_ = now_a;
  usual_a_ += kLearn * (now_a - usual_a_);
  const bool touches = std::abs(now_a - usual_a_) > kTouch_a;
  if (touches || pitch_rad_ >= PitchFor(kDown_m, sensed)) {
    note_ = touches ? "felt something below" : "reached the ground's height";
    raised_rad_ = 0.0;
    least_open_rad_ = 10.0;
    still_ = sensed.tick;
    return Event::kTouched;
  }
  pitch_rad_ += kLower_rad_s * kControlPeriod * kTickSeconds;
  Turn(sensed, pitch_rad_, kSwing_rad_s, nominal_.arm.open_rad, kSwing_rad_s);
  return Event::kNone;
}

Event Grasp::Close(const SensorFrame& sensed) {
  const double open_rad = Open(sensed);
  if (open_rad < kClosed_rad || sensed.tick - since_ > kTimeOut) {
    note_ = open_rad < kClosed_rad ? "the scoops are shut" : "the scoops did not come to rest";
    return Event::kArrived;
  }
  if (open_rad < least_open_rad_ - kStill_rad) {
    least_open_rad_ = open_rad;
    still_ = sensed.tick;
  }
  const double most_a =
      std::max(Current(sensed, ArmMotor::kFrontScoop), Current(sensed, ArmMotor::kBackScoop));
  const bool raises = most_a > kFeels_a && raised_rad_ < kRaiseMost_rad;
  if (raises) {
    pitch_rad_ -= kRaise_rad;
    raised_rad_ += kRaise_rad;
  } else if (sensed.tick - still_ > kStill) {
    note_ = "the scoops came to rest";
    return Event::kArrived;
  }
  Turn(sensed, pitch_rad_, kSwing_rad_s, 0.0, kClose_rad_s);
  return Event::kNone;
}

Event Grasp::Lift(const SensorFrame& sensed) {
  roll_rad_ = 0.0;
  const auto takes = static_cast<Tick>((pitch_rad_ - kCarry_rad) / kLift_rad_s / kTickSeconds);
  Turn(sensed, kCarry_rad, kLift_rad_s, releases_ ? nominal_.arm.open_rad : 0.0, kLift_rad_s);
  Weigh(sensed, loaded_);
  if (sensed.tick - since_ < takes + kHold) return Event::kNone;
  const double rises_to_rad = Angle(sensed, ArmMotor::kPitch) + sensed.imu.pitch_rad;
  const bool is_up = rises_to_rad < kCarry_rad + kHeldDown_rad;
  if (is_up && releases_) return Event::kMissed;
  if (is_up || !weighs_) return Event::kArrived;
  if (releases_) return Event::kFailed;
  note_ = "the scoops hold something that does not rise, and open";
  releases_ = true;
  since_ = sensed.tick;
  return Event::kNone;
}

Event Grasp::Step(Phase phase, const SensorFrame& sensed) {
  Event event = Event::kNone;
  switch (phase) {
    case Phase::kDeploy:
    case Phase::kReturn:
      if (phase == Phase::kReturn || !weighs_) roll_rad_ = aside_rad_;
      Turn(sensed, pitch_rad_, kSwing_rad_s, nominal_.arm.open_rad, kSwing_rad_s);
      if (!Arrived(sensed)) break;
      event = phase == Phase::kDeploy && weighs_ ? Event::kWeighs : Event::kArrived;
      break;
    case Phase::kWeigh:
      pitch_rad_ = kWeighTo_rad - kOvershoot_rad;
      Turn(sensed, pitch_rad_, kLift_rad_s, nominal_.arm.open_rad, kSwing_rad_s);
      Weigh(sensed, empty_);
      if (!Arrived(sensed)) break;
      pitch_rad_ = PitchFor(kAbove_m, sensed);
      event = Event::kArrived;
      break;
    case Phase::kLower:
      event = Lower(sensed);
      break;
    case Phase::kClose:
      event = Close(sensed);
      break;
    default:
      event = Lift(sensed);
  }
  if (event != Event::kNone) since_ = sensed.tick;
  return event;
}

}  // namespace dockyard::rocky7
