// A disc that spins about an axle whose one end is held.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "rigid/world_scenes.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

class WorldGyroscope : public AtStep {};
INSTANTIATE_TEST_SUITE_P(Steps, WorldGyroscope, testing::Values(0.5e-3, 1e-3, 2e-3));

constexpr double kDisc_kg = 1.0, kArm_m = 0.1, kAlong_kg_m2 = 0.01;
constexpr double kAcross_kg_m2 =
    0.5 * kAlong_kg_m2 + kDisc_kg * kArm_m * kArm_m;  // at the held end
constexpr double kTop_nm = kDisc_kg * kEarthGravity_m_s2 * kArm_m;

/// Its axle tilted from the vertical, in the plane of x; w_G turns it.
class SpinningDisc {
 public:
  SpinningDisc(double tilt_rad, const Vector3d& w_G) : world_(kDown) {
    TreeBody disc =
        FreeBody(TurningModel(kDisc_kg, kAlong_kg_m2, 0.5 * kAlong_kg_m2, {0.0, 0.0, kArm_m}),
                 {RotY(tilt_rad), Vector3d::Zero()});
    const Vector3d v_G = w_G.cross(RotY(tilt_rad) * Vector3d(0.0, 0.0, kArm_m));
    SetSpeeds(disc, {v_G.x(), v_G.y(), v_G.z(), w_G.x(), w_G.y(), w_G.z()});
    world_.Add(std::move(disc));
    world_.Add(PointTie{.a = {0, 0}, .stiffness_n_per_m = 1e7, .damping_ns_per_m = 100.0});
  }
  void Step(double step_s) {
    world_.Step(step_s);
    const double now_rad = std::atan2(axle().y(), axle().x());
    azimuth_rad_ += std::remainder(now_rad - azimuth_rad_, 2.0 * kPi);
  }
  Vector3d axle() const { return world_.body(0).motion(0).X_GL.R.col(2); }
  double azimuth_rad() const { return azimuth_rad_; }
  double held_off_m() const { return world_.body(0).motion(0).X_GL.p.norm(); }

 private:
  RigidWorld world_;
  double azimuth_rad_ = 0.0;
};

// m g l / (C s) about the vertical.
TEST_P(WorldGyroscope, LevelAxlePrecessesByWeightOverSpin) {
  const double spin_rad_s = 100.0, wanted_rad_s = kTop_nm / (kAlong_kg_m2 * spin_rad_s);
  SpinningDisc disc(0.5 * kPi, {spin_rad_s, 0.0, wanted_rad_s});
  for (long i = 0; i < StepsIn(1.0); ++i) disc.Step(step_s());
  RecordProperty("off_share", std::to_string(disc.azimuth_rad() / wanted_rad_s - 1.0));
  EXPECT_NEAR(disc.azimuth_rad(), wanted_rad_s, 0.01 * wanted_rad_s);
  EXPECT_NEAR(disc.axle().z(), 0.0, 0.01);
  EXPECT_LT(disc.held_off_m(), 1e-4);
}

// The two roots of A p^2 cos(tilt) - C w p + m g l = 0, w the turning about the axle.
TEST_P(WorldGyroscope, TiltedAxlePrecessesSteadilyAtASlowAndAFastRate) {
  const double tilt_rad = kPi / 3.0, about_rad_s = 20.0;
  const double a = kAcross_kg_m2 * std::cos(tilt_rad), b = kAlong_kg_m2 * about_rad_s;
  for (const double sign : {-1.0, 1.0}) {
    const double wanted_rad_s = (b + sign * std::sqrt(b * b - 4.0 * a * kTop_nm)) / (2.0 * a);
    const Vector3d axle(std::sin(tilt_rad), 0.0, std::cos(tilt_rad)), up = Vector3d::UnitZ();
    // About the axle the precession has a part of that turning.
    SpinningDisc disc(tilt_rad,
                      wanted_rad_s * up + (about_rad_s - wanted_rad_s * std::cos(tilt_rad)) * axle);
    for (long i = 0; i < StepsIn(1.0); ++i) disc.Step(step_s());
    RecordProperty(sign < 0.0 ? "slow_share" : "fast_share",
                   std::to_string(disc.azimuth_rad() / wanted_rad_s - 1.0));
    EXPECT_NEAR(disc.azimuth_rad(), wanted_rad_s, 0.01 * wanted_rad_s);
    EXPECT_NEAR(disc.axle().z(), std::cos(tilt_rad), 0.01);
  }
}

// A small swing about the steady precession of a level axle, of the circular frequency
// sqrt((C s / A)^2 + p^2). Within a step the disc turns as a free one, by C s h / A rad with A
// about its centre, and the period is too long by a twelfth of the square of that: by 0.3 % at 2
// ms.
TEST_P(WorldGyroscope, LevelAxleNutatesAtItsFrequency) {
  const double spin_rad_s = 50.0, steady_rad_s = kTop_nm / (kAlong_kg_m2 * spin_rad_s);
  SpinningDisc disc(0.5 * kPi, {spin_rad_s, 0.05, steady_rad_s});
  UpwardPasses passes;
  for (long i = 0; i < StepsIn(2.0); ++i) {
    disc.Step(step_s());
    passes.Take(step_s() * static_cast<double>(i), disc.axle().z());
  }
  ASSERT_GE(passes.count(), 8u);
  const double wanted_s =
      2.0 * kPi / std::hypot(kAlong_kg_m2 * spin_rad_s / kAcross_kg_m2, steady_rad_s);
  RecordProperty("off_share", std::to_string(passes.Period() / wanted_s - 1.0));
  EXPECT_NEAR(passes.Period(), wanted_s, 0.01 * wanted_s);
}

}  // namespace
}  // namespace dockyard
