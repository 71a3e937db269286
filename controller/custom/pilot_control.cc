// Phases from the staging pose into the dock and out of it.
#include <algorithm>
#include <array>
#include <cmath>

#include "controller/custom/graceful_law.h"
#include "controller/custom/pilot.h"

namespace dockyard::custom {
namespace {

// The law aims beyond the docked pose, as its curvature grows without bounds on its target. An
// offset falls as the fourth power of the distance to the target, so it has died out before.
// Assumed, 5-20 cm.
constexpr double kBeyond_m = 0.1;
// Near the docked pose a robot so far off its path cannot come onto it. Assumed, 3-10 cm, 10-20
// deg.
constexpr double kNear_m = 0.05, kMostAside_m = 0.05, kMostOff_rad = Radians(15.0);
// An approach that is not aligned is driven anew, until it is this near. Assumed, 1-3; 5-20 mm.
constexpr int kMostRealigned = 2;
constexpr double kTouch_m = 0.01;
// An estimate that is less sure across the path ends the try there, and at once where no camera
// sees the dock on the path. Assumed, 10-30 cm; 2-5 cm, 3-8 deg.
constexpr double kSure_m = 0.2;
constexpr double kMostSigma_m = 0.03, kMostSigma_rad = Radians(5.0);
// Marks that should be in view are awaited; assumed, 1-5 s.
constexpr Tick kLost = 3000;
// A robot that came no nearer by this for this long is blocked by the dock. Assumed, 1-5 mm, 1-3 s.
constexpr double kNearer_m = 0.002;
constexpr Tick kBlocked = 1500;
constexpr double kHeld_s = 1.0;           // of the closed contact, or at rest without one
constexpr double kPressing_s = 0.5;       // to start; assumed, 0.2-1
constexpr double kWiggle_rad_s = 0.2;     // assumed, 0.1-0.5
constexpr double kWigglePress_m = 0.003;  // assumed, 2-5 mm
constexpr double kMostWiggle_s = 2.0;     // of a turn that a dock may block; assumed, 1-5
constexpr double kBackOff_share = 0.8;    // of the largest speed; assumed, 0.5-1

std::string Centimetres(double length_m) {
  return std::to_string(std::lround(100.0 * std::abs(length_m))) + " cm";
}

/// @param off  of the robot's docked frame from where it is to be
bool IsAligned(const Pose2& off, const DockingOptions& options) {
  return std::abs(off.y) <= options.aligned_m && std::abs(off.heading) <= options.aligned_rad;
}

}  // namespace

bool Pilot::MarksAreLost() const {
  if (now_ - tries_.marks_at < kLost) return false;
  const Pose2 X_DR = X_DA() * Inverse(parts_.drive.X_RA);
  const auto& cameras = parts_.plan.cameras;
  return std::any_of(cameras.begin(), cameras.end(),
                     [&](int camera) { return Shows(parts_.nominal, camera, X_DR); });
}

bool Pilot::IsBlocked(double left_m) {
  if (left_m < tries_.least_left_m - kNearer_m) {
    tries_.least_left_m = left_m;
    tries_.nearer_at = now_;
  }
  return left_m < kNear_m && now_ - tries_.nearer_at > kBlocked;
}

Twist Pilot::Control() {
  const DockingOptions& options = parts_.nominal.docking;
  const DockPlan& plan = parts_.plan;
  if (parts_.contact.closed()) return Enter(Phase::kWait, "contact closed");
  if (here_.For(now_) > options.approach_s) return TryAgain("the approach takes too long");
  const Pose2 at = X_DA();
  const double left_m = plan.Left(at), aside_m = plan.Aside(at);
  const double off_rad = std::abs(WrapPi(at.heading - plan.X_DA_docked.heading));
  if (left_m < kNear_m && std::abs(aside_m) > kMostAside_m)
    return TryAgain("off the path by " + Centimetres(aside_m));
  if (left_m < kNear_m && off_rad > kMostOff_rad) return TryAgain("turned off the path");
  if (left_m < kNear_m && left_m > kTouch_m && tries_.realigned < kMostRealigned &&
      !IsAligned(plan.OffDocked(at), options)) {
    ++tries_.realigned;
    return LeaveDock("off the docked pose before it touches");
  }
  const Eigen::Vector3d sigma = DockedSigma();
  const bool must_be_sure = plan.drives_blind || left_m < kSure_m;
  if (must_be_sure && (sigma.y() > kMostSigma_m || sigma.z() > kMostSigma_rad))
    return TryAgain("the dock's pose is uncertain by " + Centimetres(sigma.y()));
  if (MarksAreLost()) return TryAgain("marks lost");
  if (left_m <= 0.0 || IsBlocked(left_m)) {
    return parts_.contact.exists() ? Enter(Phase::kPress, "at the docked pose")
                                   : Enter(Phase::kWait, "at the docked pose");
  }
  const Pose2 target = plan.X_DA_docked * Pose2{plan.travel * kBeyond_m, 0.0, 0.0};
  const Twist law = GracefulTwist(Inverse(at) * target, plan.travel, options);
  const double slow = std::max(options.least_m_s, options.most_m_s * left_m / options.slowdown_m);
  const double most = std::min(slow, BrakingSpeed(left_m, options.press_m_s, options.accel_m_s2));
  const double share = std::min(1.0, most / std::max(std::abs(law.speed_m_s), 1e-9));
  return {share * law.speed_m_s, share * law.turn_rad_s};
}

Twist Pilot::Press() {
  const DockingOptions& options = parts_.nominal.docking;
  if (parts_.contact.closed()) return Enter(Phase::kWait, "contact closed");
  // Motors that the dock stops drive no further.
  const bool blocked = here_.For(now_) > kPressing_s + 2.0 * options.press_m / options.press_m_s;
  if (std::abs(here_.driven_m) >= options.press_m || blocked) return Enter(Phase::kWait, "pressed");
  return {parts_.plan.travel * options.press_m_s, 0.0};
}

bool Pilot::IsWithinDockedBounds() const {
  const DockingOptions& options = parts_.nominal.docking;
  const Pose2 at = X_DA();
  const Eigen::Vector3d sigma = DockedSigma();
  const double off_rad = WrapPi(at.heading - parts_.plan.X_DA_docked.heading);
  return std::abs(parts_.plan.Left(at)) < options.docked_along_m &&
         std::abs(parts_.plan.Aside(at)) < options.docked_aside_m &&
         std::abs(off_rad) < options.docked_rad && sigma.x() < options.docked_along_m &&
         sigma.y() < options.docked_aside_m && sigma.z() < options.docked_rad;
}

Twist Pilot::Wait() {
  const DockingOptions& options = parts_.nominal.docking;
  if (parts_.contact.exists()) {
    if (parts_.contact.closed_s(now_) >= kHeld_s) return Enter(Phase::kDocked, "contact closed");
    if (parts_.contact.closed() || here_.For(now_) < options.wait_charge_s) return {};
    if (options.wiggle_rad > 0.0 && !tries_.wiggled) {
      tries_.wiggled = true;
      return Enter(Phase::kWiggle, "the contact is open");
    }
    return TryAgain("the contact stays open");
  }
  if (here_.For(now_) >= kHeld_s && IsWithinDockedBounds())
    return Enter(Phase::kDocked, "at the docked pose");
  if (here_.For(now_) < options.wait_charge_s) return {};
  return TryAgain("the pose is out of the bounds of docked");
}

Twist Pilot::Wiggle() {
  const DockingOptions& options = parts_.nominal.docking;
  if (parts_.contact.closed()) return Enter(Phase::kWait, "contact closed in the wiggle");
  const std::array<double, 3> ends{options.wiggle_rad, -options.wiggle_rad, 0.0};
  const double end = ends[static_cast<std::size_t>(here_.leg)];
  const double side = here_.leg == 1 ? -1.0 : 1.0;
  if (side * (here_.turned_rad - end) >= 0.0 || here_.For(now_) > kMostWiggle_s * (here_.leg + 1)) {
    if (++here_.leg == static_cast<int>(ends.size())) return Enter(Phase::kWait, "wiggled");
    return {};
  }
  // It presses on by little: a dock that yields would be pushed away.
  const bool presses = std::abs(here_.driven_m) < kWigglePress_m;
  return {presses ? parts_.plan.travel * options.press_m_s : 0.0, side * kWiggle_rad_s};
}

Twist Pilot::BackOff() {
  const DockingOptions& options = parts_.nominal.docking;
  const double left_m = tries_.back_m - std::abs(here_.driven_m);
  if (left_m <= 0.0) {
    tries_.returns = false;
    return Enter(Phase::kFace, "backed off");
  }
  const double speed = std::min(kBackOff_share * options.most_m_s,
                                BrakingSpeed(left_m, options.press_m_s, options.accel_m_s2));
  return {-parts_.plan.travel * speed, 0.0};
}

}  // namespace dockyard::custom
