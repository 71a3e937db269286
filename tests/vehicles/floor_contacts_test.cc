// Docks and boxes on a firm floor that are pushed, slide and tip over.
#include "sim/vehicles/floor_contacts.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "vehicles/tyre_rig.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kRub = 0.5, kDock_kg = 20.0, kFoot_m = 0.04;

class FloorContactsAt : public AtStep {};

FloorPart Box(const Vector3d& centre_m, const Vector3d& size_m, double stiffness_n_per_m) {
  return {.at = {0, 0},
          .body_L = BoxHull(centre_m, size_m),
          .stiffness_n_per_m = stiffness_n_per_m,
          .damping_ns_per_m = 1e-3 * stiffness_n_per_m,
          .grip = 0.8};
}

/// A box whose frame is on the floor amid it.
class Dock {
 public:
  Dock(const Dock&) = delete;
  Dock& operator=(const Dock&) = delete;
  Dock(double step_s, const Vector3d& size_m)
      : ground_(LevelFloor(kRub / 0.8)),
        world_(kDown),
        contacts_(world_, ground_),
        step_s_(step_s) {
    world_.Add(FreeBody(BoxModel(kDock_kg, size_m, {0.0, 0.0, 0.5 * size_m.z()}), {}));
  }
  void Add(FloorPart part) { contacts_.Add(std::move(part)); }
  /// push_n at this height of the dock.
  void Run(double seconds, double push_n = 0.0, double height_m = 0.0) {
    for (long i = 0; i < std::lround(seconds / step_s_); ++i) {
      const Vector3d at_G = body().X_GL * Vector3d(0.0, 0.0, height_m);
      world_.body(0).AddForce(0, {push_n, 0.0, 0.0}, at_G);
      contacts_.AddContacts(step_s_);
      world_.Step(step_s_);
    }
  }
  const LinkMotion& body() const { return world_.body(0).motion(0); }
  double speed_m_s() const { return body().v_GL_G.x(); }
  double tilt_rad() const { return std::acos(std::min(1.0, body().X_GL.R(2, 2))); }
  Vector3d Force(int part) const { return contacts_.Force(part, step_s_); }
  std::uint64_t Hash() const { return world_.StateHash(kHashSeed); }

 private:
  FirmGround ground_;
  RigidWorld world_;
  FloorContacts contacts_;
  double step_s_;
};

/// A dock on four feet.
struct OnFeet : Dock {
  explicit OnFeet(double step_s) : Dock(step_s, {0.5, 0.4, 0.3}) {
    for (const double x : {0.2, -0.2}) {
      for (const double y : {0.15, -0.15}) {
        Add(Box({x, y, 0.5 * kFoot_m}, {kFoot_m, kFoot_m, kFoot_m}, 1e5));
      }
    }
  }
};

double Weight_n() { return kDock_kg * kG_m_s2; }

TEST_P(FloorContactsAt, DockOnFeetBearsItsWeightOnEachAlike) {
  OnFeet dock(step_s());
  dock.Run(1.0);
  for (int foot = 0; foot < 4; ++foot) {
    EXPECT_NEAR(dock.Force(foot).z(), 0.25 * Weight_n(), 1e-5 * Weight_n());
  }
}

TEST_P(FloorContactsAt, PushJustBelowFrictionMovesNoDock) {
  OnFeet dock(step_s());
  dock.Run(0.5);
  dock.Run(0.5, 0.99 * kRub * Weight_n());
  const double start_m = dock.body().X_GL.p.x();
  dock.Run(10.0, 0.99 * kRub * Weight_n());
  const double creep_m = std::abs(dock.body().X_GL.p.x() - start_m);
  RecordProperty("creep_nm", std::to_string(1e9 * creep_m));
  EXPECT_LT(creep_m, 1e-8);
}

// a = F/m - mu g.
TEST_P(FloorContactsAt, PushAboveFrictionMovesTheDockByWhatIsLeft) {
  for (const double over : {0.01, 0.5}) {
    OnFeet dock(step_s());
    dock.Run(0.5);
    dock.Run(0.1, (1.0 + over) * kRub * Weight_n());
    const double speed_m_s = dock.speed_m_s();
    dock.Run(1.0, (1.0 + over) * kRub * Weight_n());
    const double wanted_m_s2 = over * kRub * kG_m_s2;
    RecordProperty("off_share_" + std::to_string(std::lround(100 * over)),
                   std::to_string((dock.speed_m_s() - speed_m_s) / wanted_m_s2 - 1.0));
    EXPECT_NEAR(dock.speed_m_s() - speed_m_s, wanted_m_s2, 0.01 * wanted_m_s2) << over;
  }
}

// F h = m g b / 2, for a push that grows slowly.
TEST_P(FloorContactsAt, TallBoxTipsWhereThePushPassesItsEdge) {
  const Vector3d size_m(0.3, 0.3, 1.0);
  const double height_m = 0.6, tips_n = 0.5 * Weight_n() * size_m.x() / height_m;
  for (const double share : {0.99, 1.01}) {
    Dock dock(step_s(), size_m);
    dock.Add(Box({0.0, 0.0, 0.5 * size_m.z()}, size_m, 1e6));
    dock.Run(0.5);
    for (int i = 1; i <= 200; ++i) dock.Run(0.02, 0.005 * i * share * tips_n, height_m);
    dock.Run(3.0, share * tips_n, height_m);
    EXPECT_EQ(dock.tilt_rad() > 0.5, share > 1.0) << share << ' ' << dock.tilt_rad();
  }
}

// Tipped over, it comes to rest on its side.
TEST_P(FloorContactsAt, BoxThatTippedLiesOnItsSide) {
  const Vector3d size_m(0.3, 0.3, 1.0);
  Dock dock(step_s(), size_m);
  dock.Add(Box({0.0, 0.0, 0.5 * size_m.z()}, size_m, 1e6));
  dock.Run(0.7, 0.6 * Weight_n(), 0.6);
  dock.Run(4.0);
  EXPECT_NEAR(dock.tilt_rad(), 0.5 * kPi, 1e-3);
  EXPECT_LT(dock.body().v_GL_G.norm(), 1e-6);
}

TEST(FloorContacts, TwoRunsHaveTheSameBits) {
  OnFeet one(1e-3), other(1e-3);
  for (Dock* dock : {&one, &other}) dock->Run(1.0, 0.7 * Weight_n(), 0.1);
  EXPECT_EQ(one.Hash(), other.Hash());
}

INSTANTIATE_TEST_SUITE_P(Steps, FloorContactsAt, testing::Values(0.5e-3, 1e-3, 2e-3));

}  // namespace
}  // namespace dockyard
