// Phases before the drive into the dock.
#include <algorithm>
#include <cmath>

#include "controller/custom/pilot.h"

namespace dockyard::custom {
namespace {

// Sightings at rest that a drive begins with. Assumed, 2-10.
constexpr int kFixes = 3;
// Where turns and drives to the staging pose end. Assumed, 1-5 cm, 1-5 deg.
constexpr double kArrived_m = 0.02, kTurned_rad = Radians(3.0), kFaced_rad = Radians(1.0);
constexpr double kSteered_m = 0.1;             // nearer, the bearing of a point is not steered to
constexpr double kAstray_rad = Radians(45.0);  // the robot turns to the point again
constexpr double kSteer_per_s = 1.5;           // turning rate by the bearing; assumed, 1-3
constexpr double kMostSearch_rad = 4.0 * kPi;  // two turns
constexpr int kMostStagings = 6;               // drives to the staging pose in a try; assumed, 3-10
constexpr int kMostSearches = 8;               // in a try; assumed, 4-12
// Returns to where the dock was detected, and from how far. Assumed, 1-3, 0.1-0.4 m.
constexpr int kMostReturns = 2;
constexpr double kReturn_m = 0.2;
constexpr double kSettled_s = 1.0;  // of a contact that is closed at the start

}  // namespace

Twist Pilot::PerceiveDock() {
  if (parts_.contact.closed_s(now_) > kSettled_s) return Enter(Phase::kWait, "contact is closed");
  if (requests_.unanswered(now_)) return Enter(Phase::kGivenUp, "no camera gives an image");
  if (here_.fixes >= kFixes) {
    tries_.X_OA_detected = odometry_.X_OA();
    if (parts_.plan.IsAtStaging(X_DA())) {
      return parts_.plan.drives_blind ? Enter(Phase::kTurnRound, "dock measured")
                                      : Enter(Phase::kControl, "dock measured");
    }
    if (++tries_.stagings > kMostStagings) {
      tries_.stagings = 0;
      return TryAgain("the staging pose is not reached");
    }
    tries_.returns = false;
    tries_.sense = RoutePoint().x() < 0.0 ? -1.0 : 1.0;
    return Enter(Phase::kTurnTo, "dock detected");
  }
  if (here_.For(now_) > parts_.nominal.docking.perception_s) {
    if (++tries_.searches > kMostSearches)
      return Enter(Phase::kGivenUp, "too few sightings of the dock");
    return Enter(Phase::kSearch, "no dock detected");
  }
  return {};
}

Twist Pilot::Search() {
  if (requests_.unanswered(now_)) return Enter(Phase::kGivenUp, "no camera gives an image");
  if (here_.fixes > 0) {
    tries_.searched_rad += std::abs(here_.turned_rad);
    return Enter(Phase::kPerceive, "dock in view");
  }
  if (tries_.searched_rad + std::abs(here_.turned_rad) > kMostSearch_rad) return Return();
  const DockingOptions& options = parts_.nominal.docking;
  return {0.0, std::min(options.search_rad_s, options.most_rad_s)};
}

/// A false estimate has led the robot to where no camera sees the dock: back to where one did.
Twist Pilot::Return() {
  const Pose2 X_AT = Inverse(odometry_.X_OA()) * tries_.X_OA_detected;
  if (!filter_.located() || tries_.returned >= kMostReturns ||
      std::hypot(X_AT.x, X_AT.y) < kReturn_m)
    return Enter(Phase::kGivenUp, "no dock detected in two turns");
  ++tries_.returned;
  tries_.returns = true;
  tries_.searched_rad = 0.0;
  tries_.sense = X_AT.x < 0.0 ? -1.0 : 1.0;
  return Enter(Phase::kTurnTo, "back to where the dock was detected");
}

/// The point to drive to, in A.
Eigen::Vector2d Pilot::RoutePoint() const {
  if (tries_.returns) {
    const Pose2 X_AT = Inverse(odometry_.X_OA()) * tries_.X_OA_detected;
    return {X_AT.x, X_AT.y};
  }
  const Pose2& staging = parts_.plan.X_DA_staging;
  return Inverse(X_DA()) * Eigen::Vector2d(staging.x, staging.y);
}

Twist Pilot::TurnTo() {
  const Eigen::Vector2d p_AS = RoutePoint();
  if (p_AS.norm() < kArrived_m) return Enter(Phase::kFace, "at the staging pose");
  const double bearing = std::atan2(tries_.sense * p_AS.y(), tries_.sense * p_AS.x());
  if (std::abs(bearing) < kTurned_rad) return Enter(Phase::kStaging, "turned to the staging pose");
  return TurnBy(bearing, parts_.nominal.docking);
}

Twist Pilot::Stage() {
  const DockingOptions& options = parts_.nominal.docking;
  const Eigen::Vector2d p_AS = tries_.sense * RoutePoint();
  const double bearing = std::atan2(p_AS.y(), p_AS.x());
  const bool is_near = p_AS.norm() < kSteered_m;
  if (!is_near && std::abs(bearing) > kAstray_rad)
    return Enter(Phase::kTurnTo, "off the line to the staging pose");
  if (p_AS.x() < kArrived_m) return Enter(Phase::kFace, "at the staging pose");
  const double speed =
      std::min(options.most_m_s, BrakingSpeed(p_AS.x(), options.press_m_s, options.accel_m_s2));
  const double turn = is_near ? 0.0 : kSteer_per_s * bearing;
  return {tries_.sense * speed, std::clamp(turn, -options.most_rad_s, options.most_rad_s)};
}

Twist Pilot::TurnToward(double heading_D_rad, double within_rad, Phase next,
                        const std::string& note) {
  const double left = WrapPi(heading_D_rad - X_DA().heading);
  if (std::abs(left) < within_rad) return Enter(next, note);
  return TurnBy(left, parts_.nominal.docking);
}

Twist Pilot::Face() {
  if (tries_.returns) {
    const double left = WrapPi(tries_.X_OA_detected.heading - odometry_.X_OA().heading);
    if (std::abs(left) >= kTurned_rad) return TurnBy(left, parts_.nominal.docking);
    tries_.returns = false;
    return Enter(Phase::kPerceive, "where the dock was detected");
  }
  return TurnToward(parts_.plan.measuring_rad, kFaced_rad, Phase::kPerceive, "faces the dock");
}

Twist Pilot::TurnRound() {
  return TurnToward(parts_.plan.X_DA_docked.heading, kFaced_rad, Phase::kControl, "turned round");
}

}  // namespace dockyard::custom
