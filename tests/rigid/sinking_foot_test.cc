// Feet on soil against Bekker's law by hand: p = (k_c / b + k_phi) z^n.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/geometry/pose.h"
#include "models/read/load_soil.h"
#include "sim/rigid/ground_contact.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

constexpr double kG = 9.81, kSole_m = 0.10, kArea_m2 = kPi * 0.05 * 0.05;

SoilModel Soil(const std::string& name) {
  return LoadSoil(SourceFile("models/soils/" + name + ".yaml"));
}

double BekkerDepth(const SoilModel& soil, double load_n) {
  const double k = soil.k_c / (0.5 * kSole_m) + soil.k_phi;
  return std::pow(load_n / kArea_m2 / k, 1.0 / soil.n);
}

/// A body of 9 kg on one foot, with a further force on it.
struct Footed {
  explicit Footed(const SoilModel& soil, double step_s = 1e-3) : dt_s(step_s) {
    const SinkingPlate plate = RoundPlate(soil, kSole_m);
    material = {plate.rebound_n_per_m, 0.6 * std::sqrt(plate.rebound_n_per_m * kMass), 0.4, plate};
  }
  void Press(double load_n, double seconds) {
    const Eigen::Vector3d load(0.0, 0.0, -load_n / kMass);
    for (long i = 0; i < std::lround(seconds / dt_s); ++i) {
      v += (load + GroundForce(ground, material, p, v, dt_s, foot) / kMass) * dt_s;
      p += v * dt_s;
    }
  }
  /// Slowly, so that the body's weight in motion presses no deeper.
  void Ramp(double from_n, double to_n, double seconds) {
    const int steps = 2000;
    for (int i = 1; i <= steps; ++i) {
      Press(from_n + (to_n - from_n) * i / steps, seconds / steps);
    }
    Press(to_n, 0.5);
  }

  static constexpr double kMass = 9.0;
  double dt_s;
  HeightGrid ground = LevelGrid(-1.0, 2.0, 2.0, 0.1);
  GroundMaterial material;
  GroundPoint foot;
  Eigen::Vector3d p = Eigen::Vector3d::Zero(), v = Eigen::Vector3d::Zero();
};

TEST(SinkingFoot, SinksByBekkersLawOnTwoSoils) {
  for (const char* name : {"compact_gravel", "loose_sand"}) {
    const SoilModel soil = Soil(name);
    Footed body(soil);
    body.Ramp(0.0, 9.0 * kG, 4.0);
    EXPECT_NEAR(-body.p.z(), BekkerDepth(soil, 9.0 * kG), 0.01 * BekkerDepth(soil, 9.0 * kG))
        << name;
    EXPECT_NEAR(DepthUnder(RoundPlate(soil, kSole_m), 9.0 * kG), BekkerDepth(soil, 9.0 * kG), 1e-9);
  }
}

TEST(SinkingFoot, KeepsItsDepthWhenTheLoadGoesButForTheRebound) {
  const SoilModel soil = Soil("loose_sand");
  Footed body(soil);
  body.Ramp(0.0, 200.0, 4.0);
  const double loaded = -body.p.z(), sunk = body.foot.sunk_m;
  body.Ramp(200.0, 80.0, 2.0);
  EXPECT_EQ(body.foot.sunk_m, sunk);
  EXPECT_NEAR(loaded + body.p.z(), 120.0 / (kArea_m2 * soil.unloading_stiffness_pa_per_m), 1e-6);
  // Loaded again it yields where it stopped, not before.
  body.Ramp(80.0, 195.0, 2.0);
  EXPECT_EQ(body.foot.sunk_m, sunk);
  body.Ramp(195.0, 300.0, 2.0);
  EXPECT_NEAR(-body.p.z(), BekkerDepth(soil, 300.0), 0.01 * BekkerDepth(soil, 300.0));
}

TEST(SinkingFoot, DoesNotCreepAtRest) {
  Footed body(Soil("loose_sand"));
  body.Ramp(0.0, 9.0 * kG, 4.0);
  const double depth = body.p.z();
  body.Press(9.0 * kG, 60.0);
  EXPECT_NEAR(body.p.z(), depth, 1e-8);
}

TEST(SinkingFoot, SinksAsDeepWithHalfTheStep) {
  for (const double load_n : {90.0, 250.0}) {
    Footed coarse(Soil("compact_gravel"), 1e-3), fine(Soil("compact_gravel"), 5e-4);
    coarse.Ramp(0.0, load_n, 4.0);
    fine.Ramp(0.0, load_n, 4.0);
    EXPECT_NEAR(coarse.p.z(), fine.p.z(), 1e-6);
  }
}

TEST(SinkingFoot, NeverHoldsAFootThatIsLifted) {
  Footed body(Soil("loose_sand"));
  body.Ramp(0.0, 200.0, 2.0);
  const Eigen::Vector3d above(0.0, 0.0, -body.foot.sunk_m + 1e-6);
  EXPECT_EQ(GroundForce(body.ground, body.material, above, {0, 0, 0.1}, 1e-3, body.foot).z(), 0.0);
}

}  // namespace
}  // namespace dockyard
