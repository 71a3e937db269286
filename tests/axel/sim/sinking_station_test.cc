// The station on soles that sink, against levers and Bekker's law by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "axel/sim/product.h"
#include "sim/axel/station_body.h"

namespace dockyard::axel {
namespace {

constexpr double kG = 9.81, kStep = 1e-3;
constexpr std::size_t kFront = 0, kHind = 2;  // of the feet in the file

StationModel SoftStation() {
  StationModel station = Station();
  station.sole_diameter_m = 0.10;
  return station;
}

struct Standing {
  Standing(const StationModel& model, const SoilModel& soil)
      : station(world, model,
                Pose3::Translation(0.0, 0.0, -DepthUnder(SoleOf(model, soil), Share(model))),
                SoleOf(model, soil)) {}
  static double Share(const StationModel& model) {
    return model.module.mass_kg * kG / static_cast<double>(model.feet.size());
  }
  void Push(double force_x_n, double seconds, double rising_s = 0.0) {
    for (double t = 0.0; t < seconds; t += kStep) {
      const double share = rising_s > 0.0 ? std::min(1.0, t / rising_s) : 1.0;
      station.AddForce({share * force_x_n, 0.0, 0.0}, station.X_GM().p);
      station.AddFeetForces(ground, kStep);
      world.Step(kStep);
    }
  }
  double Depth(std::size_t foot) const {
    return -(station.motion().X_GL * Station().feet[foot].p_SF).z();
  }
  double pitch() const { return ToRollPitchYaw(station.motion().X_GL.R).pitch; }

  HeightGrid ground = LevelGrid(-3.0, 6.0, 6.0, 0.1);
  RigidWorld world{{0.0, 0.0, -kG}};
  StationBody station;
};

double Bekker(const SoilModel& soil, double load_n) {
  const double k = soil.k_c / 0.05 + soil.k_phi;
  return std::pow(load_n / (kPi * 0.05 * 0.05) / k, 1.0 / soil.n);
}

TEST(SinkingStation, StartsAsDeepAsItsWeightPressesIt) {
  for (const SoilModel& soil : {CompactGravel(), LooseSand()}) {
    const StationModel model = SoftStation();
    Standing at(model, soil);
    at.Push(0.0, 3.0);
    // Its middle of mass lies a little off the soles' middle.
    const double depth = Bekker(soil, Standing::Share(model));
    EXPECT_NEAR(-at.station.motion().X_GL.p.z(), depth, 0.03 * depth + 1e-5) << soil.name;
    EXPECT_GT(at.station.sunk_m(), 0.5 * depth) << soil.name;
  }
}

// A pull at the mouth moves load from the hind pair to the front pair: F h / base.
TEST(SinkingStation, TiltsForwardByTheLeversAndStaysSo) {
  const SoilModel soil = LooseSand();
  const StationModel model = SoftStation();
  Standing at(model, soil);
  at.Push(0.0, 3.0);
  const double level = at.pitch(), before = at.Depth(kFront), hind_before = at.Depth(kHind);
  constexpr double kPull = 60.0, kBase = 0.5;
  const double weight = model.module.mass_kg * kG;
  const auto on_front = [&](double pull_n) {
    const Eigen::Vector3d com = at.station.CentreOfMass();
    const double hind_x = (at.station.motion().X_GL * model.feet[kHind].p_SF).x();
    const double lever = at.station.X_GM().p.z() + hind_before;
    return (weight * (com.x() - hind_x) + pull_n * lever) / kBase;
  };
  const double free = on_front(0.0);
  at.Push(kPull, 8.0, 6.0);
  const double pulled = on_front(kPull);
  // The hind pair, relieved, only springs back.
  const double rebound = kPi * 0.05 * 0.05 * soil.unloading_stiffness_pa_per_m;
  const double front = Bekker(soil, 0.5 * pulled);
  const double hind = hind_before - 0.5 * (pulled - free) / rebound;
  EXPECT_NEAR(at.Depth(kFront), front, 0.02 * front);
  EXPECT_NEAR(at.Depth(kHind), hind, 0.02 * hind);
  EXPECT_NEAR(at.pitch(), std::atan((front - hind) / kBase), 1e-4);
  at.Push(0.0, 3.0);
  const double springs_back = 0.5 * (pulled - free) / rebound;
  EXPECT_NEAR(at.Depth(kFront), front - springs_back, 0.02 * front);
  EXPECT_GT(at.pitch() - level, 0.8 * (front - before - springs_back) / kBase);
}

}  // namespace
}  // namespace dockyard::axel
