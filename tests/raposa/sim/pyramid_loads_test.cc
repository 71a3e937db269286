// The pyramid alone, pushed and pulled, against closed forms of friction and statics.
#include "sim/raposa/pyramid_loads.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "raposa/sim/raposa_rig.h"
#include "support/source_tree.h"

namespace dockyard::raposa {
namespace {

constexpr double kStep_s = 1e-3, kGravity_m_s2 = 9.81;
const Eigen::Vector3d kGravity_G(0.0, 0.0, -kGravity_m_s2);
const Eigen::Vector3d kCableTo_G(-2.5, 0.0, 0.0);

PyramidModel Pyramid() { return LoadPyramid(SourceFile("models/raposa/pyramid/pyramid.yaml")); }

/// So light that it resists nothing.
PyramidModel PyramidWithoutCable() {
  PyramidModel pyramid = Pyramid();
  pyramid.cable.mass_kg_per_m = 1e-5;
  pyramid.cable.axial_stiffness_n = 1.0;
  return pyramid;
}

/// On a level floor.
class OnTheFloor {
 public:
  explicit OnTheFloor(const PyramidModel& pyramid)
      : ground_(LevelGrid(-4.0, 10.0, 10.0, 0.1)),
        body_(MakePyramid(pyramid, StartOf(pyramid))),
        loads_(pyramid, StartOf(pyramid), kCableTo_G, {std::nullopt}) {}

  /// With a force at a point of P.
  void Step(double seconds, const Eigen::Vector3d& force_G = Eigen::Vector3d::Zero(),
            const Eigen::Vector3d& p_P = Eigen::Vector3d::Zero()) {
    for (long i = 0; i < std::lround(seconds / kStep_s); ++i) {
      loads_.AddTo(body_, ground_, kGravity_G, kStep_s);
      body_.AddForce(0, force_G, X_GP() * p_P);
      body_.TakeLoads(kGravity_G, kStep_s);
      body_.Move(kStep_s);
    }
  }
  /// Takes it along the ground at a speed, against all loads.
  void Take(double seconds, const Eigen::Vector3d& speed_G) {
    for (long i = 0; i < std::lround(seconds / kStep_s); ++i) {
      loads_.AddTo(body_, ground_, kGravity_G, kStep_s);
      body_.TakeLoads(kGravity_G, kStep_s);
      TreeBody::Speeds change = -body_.speeds();
      change.head<3>() += speed_G;
      body_.AddSpeeds(change);
      body_.Move(kStep_s);
    }
  }

  double cable_pull_n() const { return loads_.cable_pull_n(); }
  std::vector<Eigen::Vector3d> CableLine() const { return loads_.CableLine(X_GP()); }
  Eigen::Vector3d p_GP() const { return X_GP().p; }
  double turn_rad() const { return std::atan2(X_GP().R(1, 0), X_GP().R(0, 0)); }
  double tilt_rad() const { return std::acos(std::min(1.0, X_GP().R(2, 2))); }

 private:
  static Pose3 StartOf(const PyramidModel& pyramid) {
    return Pose3::Translation(0.0, 0.0, pyramid.guide.height_m);
  }
  const Pose3& X_GP() const { return body_.motion(0).X_GL; }

  HeightGrid ground_;
  TreeBody body_;
  PyramidLoads loads_;
};

/// Load of each sole, from the moments of the weight and of a force across the axis at the guide.
/// Soles stand in pairs, left and right; a pair shares the force's moment with the other.
std::vector<double> SoleLoads(const PyramidModel& pyramid, double side_n) {
  double front_m = -1e9, rear_m = 1e9, half_track_m = 0.0;
  for (const Eigen::Vector2d& p : pyramid.p_P_soles) {
    front_m = std::max(front_m, p.x());
    rear_m = std::min(rear_m, p.x());
    half_track_m = std::max(half_track_m, p.y());
  }
  const double weight_n = pyramid.body.mass_kg * kGravity_m_s2;
  const double front = (pyramid.body.p_LoCom_L.x() - rear_m) / (front_m - rear_m);
  const double lever_n = side_n * pyramid.guide.height_m / (4.0 * half_track_m);
  std::vector<double> loads;
  for (const Eigen::Vector2d& p : pyramid.p_P_soles) {
    loads.push_back(0.5 * weight_n * (p.x() == front_m ? front : 1.0 - front) +
                    std::copysign(lever_n, p.y()));
  }
  return loads;
}

/// Of a force across the axis at the guide: the least over all centres of rotation of friction's
/// power by the force's speed, the upper bound of limit analysis. The loads are those of that
/// force.
double LeastSideForce(const PyramidModel& pyramid) {
  double side_n = 0.0;
  for (int pass = 0; pass < 20; ++pass) {
    const std::vector<double> loads = SoleLoads(pyramid, side_n);
    double least_n = 1e9;
    for (double x = -0.6; x < -0.06; x += 1e-3) {
      for (double y = -0.06; y < 0.06; y += 1e-3) {
        double power = 0.0;
        for (std::size_t i = 0; i < loads.size(); ++i) {
          const Eigen::Vector2d& p = pyramid.p_P_soles[i];
          power += pyramid.foot_friction * loads[i] * std::hypot(p.x() - x, p.y() - y);
        }
        least_n = std::min(least_n, power / -x);
      }
    }
    side_n = least_n;
  }
  return side_n;
}

TEST(RaposaPyramid, ASideForceAtTheGuideTurnsItWhereItsFrictionEnds) {
  const PyramidModel model = PyramidWithoutCable();
  const double least_n = LeastSideForce(model);
  EXPECT_NEAR(least_n, 1.4, 0.2);  // about what a finger does
  OnTheFloor below(model), above(model);
  for (OnTheFloor* floor : {&below, &above}) floor->Step(0.5);
  below.Step(1.0, {0.0, 0.95 * least_n, 0.0});
  above.Step(1.0, {0.0, 1.05 * least_n, 0.0});
  EXPECT_LT(Degrees(std::abs(below.turn_rad())), 0.2);
  EXPECT_GT(Degrees(std::abs(above.turn_rad())), 3.0);
}

TEST(RaposaPyramid, AForceAtItsMassSlidesItWhereItsFrictionEnds) {
  const PyramidModel model = PyramidWithoutCable();
  const double limit_n = model.foot_friction * model.body.mass_kg * kGravity_m_s2;
  EXPECT_LT(limit_n, 5.0);
  // Low, so that it does not tip.
  const Eigen::Vector3d p_P(model.body.p_LoCom_L.x(), 0.0, -model.guide.height_m);
  OnTheFloor below(model), above(model);
  for (OnTheFloor* floor : {&below, &above}) floor->Step(0.5);
  const double before_m = below.p_GP().x();
  below.Step(1.0, {-0.97 * limit_n, 0.0, 0.0}, p_P);
  above.Step(1.0, {-1.03 * limit_n, 0.0, 0.0}, p_P);
  EXPECT_LT(std::abs(below.p_GP().x() - before_m), 1e-3);
  // It accelerates by the rest: s = a t^2 / 2.
  EXPECT_NEAR(before_m - above.p_GP().x(), 0.5 * 0.03 * model.foot_friction * kGravity_m_s2, 0.01);
}

// On feet that do not slide, pushed sideways above its mass: F z = m g (half the track).
TEST(RaposaPyramid, ItTipsOverWhereItsWeightNoLongerHoldsIt) {
  PyramidModel model = PyramidWithoutCable();
  model.foot_friction = 10.0;
  const double half_track_m = std::abs(model.p_P_soles.front().y()), height_m = 0.08;
  const double limit_n = model.body.mass_kg * kGravity_m_s2 * half_track_m / height_m;
  const Eigen::Vector3d p_P(model.body.p_LoCom_L.x(), 0.0, height_m - model.guide.height_m);
  OnTheFloor below(model), above(model);
  for (OnTheFloor* floor : {&below, &above}) floor->Step(0.5);
  below.Step(0.6, {0.0, 0.95 * limit_n, 0.0}, p_P);
  above.Step(0.6, {0.0, 1.05 * limit_n, 0.0}, p_P);
  EXPECT_LT(Degrees(below.tilt_rad()), 1.0);
  EXPECT_GT(Degrees(above.tilt_rad()), 10.0);
}

// Until the cable is taut it holds the pyramid by its friction alone, then by all that pulls beyond
// that of the feet.
TEST(RaposaPyramid, ATautCableHoldsIt) {
  PyramidModel model = Pyramid();
  const double limit_n = model.foot_friction * model.body.mass_kg * kGravity_m_s2;
  const Eigen::Vector3d p_P(model.body.p_LoCom_L.x(), 0.0, -model.guide.height_m);
  OnTheFloor with(model), without(PyramidWithoutCable());
  for (OnTheFloor* floor : {&with, &without}) {
    floor->Step(1.0);
    floor->Step(2.0, {3.0 * limit_n, 0.0, 0.0}, p_P);
  }
  EXPECT_GT(without.p_GP().x(), 2.0);
  EXPECT_NEAR(with.p_GP().x(), model.cable.slack_m, 0.02);
  EXPECT_GT(with.cable_pull_n(), 1.9 * limit_n);
}

// A cable that lies still is not stepped; it wakes when its end is taken along.
TEST(RaposaPyramid, ACableThatLiesStillFollowsItsEnd) {
  OnTheFloor floor(Pyramid());
  floor.Step(5.0);
  const double pull_n = floor.cable_pull_n();
  floor.Step(1.0);
  EXPECT_EQ(floor.cable_pull_n(), pull_n);
  const std::vector<Eigen::Vector3d> before = floor.CableLine();
  floor.Take(3.0, {0.0, 0.1, 0.0});
  const std::vector<Eigen::Vector3d> after = floor.CableLine();
  ASSERT_EQ(before.size(), after.size());
  const std::size_t last = after.size() - 2;  // the mass beside the pyramid
  EXPECT_GT(after[last].y() - before[last].y(), 0.1);
  EXPECT_LT((after.front() - before.front()).norm(), 1e-9);
}

}  // namespace
}  // namespace dockyard::raposa
