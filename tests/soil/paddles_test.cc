// What paddles may do whatever their number and height: never pull more than the soil can give,
// and not lose their pull where there are more or taller ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "controller/geometry/pose.h"
#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

WheelModel Paddled(int count, double height_m) {
  WheelModel wheel;
  wheel.rim_radius_m = 0.265;
  wheel.width_m = 0.15;
  wheel.paddle_count = count;
  wheel.paddle_height_m = height_m;
  wheel.paddle_thickness_m = 0.005;
  return wheel;
}

SingleWheelResult Pull(const WheelModel& wheel, const SoilModel& soil, double slip, double load_n) {
  SingleWheelSetup setup;
  setup.wheel = wheel;
  setup.soil = soil;
  setup.slip = slip;
  setup.load_n = load_n;
  setup.speed_m_s = 0.1;
  return RunSingleWheel(setup);
}

/// None of a series may lie more than a tenth below the best before it.
class NeverFallsByATenth {
 public:
  void Add(double pull) {
    EXPECT_GT(pull, 0.9 * best_);
    best_ = std::max(best_, pull);
  }

 private:
  double best_ = 0.0;
};

TEST(Paddles, PullNoLessWhereThereAreMore) {
  NeverFallsByATenth series;
  for (const int count : {6, 12, 24, 36, 48}) {
    const double pull = Pull(Paddled(count, 0.035), Soil("loose_sand"), 0.2, 200.0).ahead_n / 200.0;
    std::printf("%d paddles: %.3f of the load\n", count, pull);
    series.Add(pull);
  }
}

TEST(Paddles, PullNoLessWhereTheyAreTaller) {
  NeverFallsByATenth series;
  for (const double height_m : {0.005, 0.02, 0.035, 0.05}) {
    const double pull = Pull(Paddled(24, height_m), Soil("loose_sand"), 0.2, 200.0).ahead_n / 200.0;
    std::printf("%.0f mm high: %.3f of the load\n", 1e3 * height_m, pull);
    series.Add(pull);
  }
}

// Without cohesion soil gives W tan(phi) and one passive wedge behind the wheel.
TEST(Paddles, PullNoMoreThanSoilCanGiveAtAnySlip) {
  SoilModel soil = Soil("grc_3");
  soil.cohesion_pa = 0.0;
  const double load_n = 172.0;
  const WheelModel viper = Wheel("viper");
  for (const double friction_deg : {21.0, 37.8}) {
    soil.friction_angle_rad = Radians(friction_deg);
    const double tan_phi = std::tan(soil.friction_angle_rad);
    const double n_phi = std::pow(std::tan(Radians(45.0 + 0.5 * friction_deg)), 2);
    for (const double slip : {0.1, 0.3, 0.6, 0.9}) {
      const SingleWheelResult result = Pull(viper, soil, slip, load_n);
      const double z = result.sinkage_m;
      const double wedge_n = 0.5 * soil.density_kg_m3 * 9.81 * z * z * n_phi * viper.width_m;
      std::printf("phi %.1f deg, slip %.1f: %.3f of the load, %.0f mm, bound %.3f\n", friction_deg,
                  slip, result.ahead_n / load_n, 1e3 * z, tan_phi + wedge_n / load_n);
      EXPECT_LT(result.ahead_n, load_n * tan_phi + wedge_n);
      EXPECT_LT(result.torque_nm, (load_n * tan_phi + wedge_n) * RollingRadius(viper));
    }
  }
}

}  // namespace
}  // namespace dockyard::soil_test
