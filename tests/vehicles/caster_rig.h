// A caster whose pivot a heavy slide moves straight along x, loaded by a mass of its own.
#pragma once

#include <cmath>
#include <vector>

#include "vehicles/tyre_rig.h"

namespace dockyard {

struct CasterLosses {
  double friction_nm = 0.0;  // of the swivel
  double rolling_resistance_m = 0.0;
};

class CasterRig {
 public:
  static constexpr double kRadius_m = 0.025, kTrail_m = 0.03, kLoad_kg = 5.0, kHeavy_kg = 1e4;
  static constexpr double kWheel_kg = 5e-3, kFork_kg = 5e-3, kRub = 0.7;
  enum Link { kMount, kAlong, kAside, kLoad, kFork, kWheel };

  CasterRig(double step_s, double start_rad, double speed_m_s, const CasterLosses& losses)
      : step_s_(step_s),
        start_rad_(start_rad),
        cart_(Plan(losses), LevelFloor(kRub), step_s, Pose3::Translation(0.0, 0.0, kRadius_m),
              {TreeBase::kFixed, VelocityTerms::kAtStart}) {
    cart_.tree().SetAngle(kFork, start_rad);
    if (losses.friction_nm > 0.0) {
      cart_.world().Limit({0, kFork}, {.friction_nm = losses.friction_nm});
    }
    cart_.Run(0.3);
    start_m_ = cart_.tree().angle_rad(kAlong);
    // It rolls without slip from the start.
    SetSpeeds(cart_.tree(), {speed_m_s, 0.0, 0.0, -speed_m_s * std::sin(start_rad) / kTrail_m,
                             speed_m_s * std::cos(start_rad) / kRadius_m});
    side_ns_ = SideMomentum();
  }

  void Run(double seconds) { cart_.Run(seconds); }
  double gone_m() { return cart_.tree().angle_rad(kAlong) - start_m_; }
  double angle_rad() { return cart_.tree().angle_rad(kFork); }
  double WantedAngle() {
    return 2.0 * std::atan(std::tan(0.5 * start_rad_) * std::exp(-gone_m() / kTrail_m));
  }
  double load_n() const { return (kLoad_kg + kFork_kg + kWheel_kg) * kG_m_s2; }
  /// On the pivot since the start.
  double side_impulse_ns() { return SideMomentum() - side_ns_; }

  static std::vector<TreeLink> Links() { return Plan({}).links; }

 private:
  static CartPlan Plan(const CasterLosses& losses) {
    using Eigen::Vector3d;
    CartPlan plan(Mount().model);
    const auto Slide = [&](int parent, double mass_kg, const Vector3d& axis) {
      return plan.Add(JointedLink(parent, BoxModel(mass_kg, {0.1, 0.1, 0.1}), {0, 0, 0}, axis,
                                  JointKind::kSlide));
    };
    Slide(kMount, kHeavy_kg, Vector3d::UnitX());
    Slide(kAlong, kHeavy_kg, Vector3d::UnitY());
    Slide(kAside, kLoad_kg, Vector3d::UnitZ());
    plan.AddSwivel(kLoad, {0, 0, 0}, kFork_kg);
    TyreModel tyre = RubberTyre(kRadius_m, 0.0);
    tyre.rolling_resistance_m = losses.rolling_resistance_m;
    plan.AddWheel(kFork, {-kTrail_m, 0.0, 0.0}, tyre, kWheel_kg);
    return plan;
  }
  double SideMomentum() {
    return (kHeavy_kg + kLoad_kg + kFork_kg + kWheel_kg) * cart_.tree().rate_rad_s(kAside);
  }

  double step_s_, start_rad_, start_m_ = 0.0, side_ns_ = 0.0;
  Cart cart_;
};

}  // namespace dockyard
