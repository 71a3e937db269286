#include "sim/rocky7/placeable_rock.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/base/random.h"

namespace dockyard::rocky7 {
namespace {

using Eigen::Vector3d;

// Assumed, 50-500: where the mast reaches the normal, a rock in five to ten is placeable.
constexpr int kMostDraws = 100;
constexpr int kOnCircle = 12;
// A click's error of 1.5 px at 6 m, 1 sigma; assumed, 6-15 mm. Places to each side of the target.
constexpr double kClick_m = 0.012;
constexpr int kAbout = 6;
// The tool's tilt jumps with the distance where the mast is stretched: by 3.4 deg for each
// centimetre where its links are 20 deg apart. Assumed, 10-30 deg.
constexpr double kLeastBend_rad = Radians(20.0);
// The rover's pitch against the ground's plane, as wheels sink in and climb stones, and how far the
// target is ahead of its middle. Assumed, 1-4 deg and 0.6-0.9 m.
constexpr double kPitch_rad = Radians(2.5), kAway_m = 0.8;
// Wheels keep off the rock's foot by this. Assumed, 4-8 cm.
constexpr double kOffFoot_m = 0.05;
// Half of what a user's click may be off the point that is meant (user_click.cc). Assumed, 1-3 cm.
constexpr double kShown_m = 0.02;

Vector3d TargetOf(const RoundedRockShape& shape) { return {0.0, 0.0, shape.target_up_m}; }

// Front edge and half the width of the wheels, in R.
struct Front {
  double x_m = 0.0, half_width_m = 0.0;
};

Front FrontOf(const RoverPlan& plan) {
  Front front;
  for (const WheelPlan& wheel : plan.wheels) {
    front.x_m = std::max(front.x_m, wheel.p_RW.x() + plan.wheel_radius_m);
    front.half_width_m =
        std::max(front.half_width_m, std::abs(wheel.p_RW.y()) + 0.5 * plan.wheel_width_m);
  }
  return front;
}

// How far the rock reaches before the target, against the direction of approach.
double FootBefore(const StarBody& rock, const Vector3d& target, const Eigen::Vector2d& ahead,
                  double half_width_m) {
  double foot_m = 0.0;
  for (const Vector3d& vertex : rock.vertices) {
    const Eigen::Vector2d from = (vertex - target).head<2>();
    const double aside_m = std::abs(ahead.x() * from.y() - ahead.y() * from.x());
    if (vertex.z() < 0.0 || aside_m > half_width_m + kOffFoot_m) continue;
    foot_m = std::max(foot_m, -from.dot(ahead));
  }
  return foot_m;
}

// From the mast's axis to a point so high over the shoulder, where the tool meets it along its
// inward normal; none where no angles of the joints do.
std::optional<double> AwayFromAxis(const MastModel& mast, double up_m, double normal_up_rad) {
  const double sine = (up_m + mast.link2_m * std::sin(normal_up_rad)) / mast.link1_m;
  if (std::abs(sine) > 1.0) return std::nullopt;
  const double first_up_rad = std::asin(sine), bend_rad = first_up_rad + normal_up_rad;
  const bool turns = bend_rad >= kLeastBend_rad && bend_rad <= mast.high_rad[kMastElbow] &&
                     -first_up_rad <= mast.high_rad[kMastShoulder] &&
                     -first_up_rad >= mast.low_rad[kMastShoulder];
  if (!turns) return std::nullopt;
  return mast.link1_m * std::cos(first_up_rad) + mast.link2_m * std::cos(normal_up_rad);
}

bool RestsAbout(const StarBody& rock, const InstrumentModel& instrument, const Vector3d& target,
                const Vector3d& normal) {
  const Vector3d side = normal.unitOrthogonal(), up = normal.cross(side);
  for (int i = 0; i <= kAbout; ++i) {
    const double angle_rad = 2.0 * kPi * i / kAbout;
    const Vector3d aside = std::cos(angle_rad) * side + std::sin(angle_rad) * up;
    const auto fall_m =
        FallUnderSwitches(rock, instrument, target + (i < kAbout ? kClick_m : 0.0) * aside, normal);
    if (!fall_m || std::abs(*fall_m) > instrument.switch_out_m) return false;
  }
  return true;
}

}  // namespace

std::optional<double> FallUnderSwitches(const StarBody& rock, const InstrumentModel& instrument,
                                        const Vector3d& p, const Vector3d& normal) {
  const auto there = NormalUnderDisc(rock, p, normal, instrument.radius_m);
  if (!there) return std::nullopt;
  const auto middle = FirstOnRay(rock, p + rock.radius_m * normal, -normal);
  if (!middle) return std::nullopt;
  const Vector3d side = there->unitOrthogonal(), up = there->cross(side);
  double sum_m = 0.0;
  for (int i = 0; i < kOnCircle; ++i) {
    const double angle_rad = 2.0 * kPi * i / kOnCircle;
    const Vector3d from =
        *middle + rock.radius_m * *there +
        instrument.switch_radius_m * (std::cos(angle_rad) * side + std::sin(angle_rad) * up);
    const auto hit = FirstOnRay(rock, from, -*there);
    if (!hit) return std::nullopt;
    sum_m += there->dot(*middle - *hit);
  }
  return sum_m / kOnCircle;
}

bool MastMeets(const StarBody& rock, const RoverModel& rover, const Vector3d& target,
               const Vector3d& normal) {
  const Vector3d level(-normal.x(), -normal.y(), 0.0);
  if (level.norm() < 1e-6) return false;
  const MastModel& mast = *rover.mast;
  const Front front = FrontOf(rover.plan);
  const double foot_m = FootBefore(rock, target, level.head<2>().normalized(), front.half_width_m);
  const double least_m = front.x_m - mast.p_RM.x() + kOffFoot_m + foot_m;
  const double up_m = target.z() - mast.p_RM.z() - RollingRadius(rover.tyre);
  const double normal_up_rad = std::asin(std::clamp(normal.z(), -1.0, 1.0));
  for (const double pitch_rad : {-kPitch_rad, 0.0, kPitch_rad}) {
    const auto away_m =
        AwayFromAxis(mast, up_m + kAway_m * std::sin(pitch_rad), normal_up_rad + pitch_rad);
    if (!away_m || *away_m < least_m) return false;
  }
  return true;
}

Vector3d MastCameraAtStart(const RobotModel& robot, const Pose2& X_GR) {
  const MastModel& mast = *robot.rover.mast;
  const auto& [roll_rad, shoulder_rad, elbow_rad] = mast.watch_rad;
  const Eigen::Matrix3d R_first = RotZ(roll_rad) * RotY(shoulder_rad);
  const Pose3 X_RK{R_first * RotY(elbow_rad), mast.p_RM + mast.link1_m * R_first.col(0)};
  return FromGround(X_GR, RollingRadius(robot.rover.tyre)) *
         (X_RK * robot.mast_pair.nominal.X_RL.p);
}

bool IsPlaceable(const StarBody& rock, const RoundedRockShape& shape, const RoverModel& rover) {
  const InstrumentModel& instrument = rover.mast->instrument;
  const Vector3d target = TargetOf(shape);
  const Vector3d along(std::cos(shape.face_up_rad) * std::cos(shape.face_turn_rad),
                       std::cos(shape.face_up_rad) * std::sin(shape.face_turn_rad),
                       std::sin(shape.face_up_rad));
  const auto normal = NormalUnderDisc(rock, target, along, instrument.radius_m);
  return normal && MastMeets(rock, rover, target, *normal) &&
         RestsAbout(rock, instrument, target, *normal);
}

bool ShowsTarget(const StarBody& rock, const RoundedRockShape& shape, const Vector3d& from) {
  const Vector3d target = TargetOf(shape);
  const auto shown = FirstOnRay(rock, from, target - from);
  return shown && (*shown - target).norm() < kShown_m;
}

std::optional<StarBody> FirstRock(const RoundedRockShape& shape, std::uint64_t key,
                                  const std::function<bool(const StarBody&)>& takes) {
  for (int draw = 0; draw < kMostDraws; ++draw) {
    const std::uint64_t drawn =
        draw == 0 ? key : StreamKey(Seed(key), "draw " + std::to_string(draw));
    StarBody rock = MakeRoundedRock(shape, drawn);
    if (takes(rock)) return rock;
  }
  return std::nullopt;
}

}  // namespace dockyard::rocky7
