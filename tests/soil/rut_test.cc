// Ruts: volume, reach, growth and repeated passes.
#include "sim/soil/rut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

/// Drives a loaded wheel over the grid at a set slip and returns its axle heights' last value.
double DrivePass(HeightGrid& grid, const WheelModel& wheel, double load_n, double slip) {
  WheelSoil contact(wheel, Soil("pavlov_90"));
  WheelMotion motion;
  const double speed = 0.2, mass_kg = load_n / 9.81, step = 1e-3;
  const double spin = speed / wheel.rim_radius_m / (1.0 - slip);
  motion.X_GK.p = Eigen::Vector3d(0.0, 0.0, wheel.rim_radius_m);
  double sink_speed = 0.0, angle = 0.0;
  for (int i = 0; i < 5000; ++i) {
    motion.X_GK.R = RotY(angle);
    motion.v_GK_G = Eigen::Vector3d(speed, 0.0, sink_speed);
    motion.w_GK_G = Eigen::Vector3d(0.0, spin, 0.0);
    const WheelLoad load = contact.Step(grid, motion, step);
    sink_speed += (load.force_G.z() - load_n) / mass_kg * step;
    motion.X_GK.p += Eigen::Vector3d(speed, 0.0, sink_speed) * step;
    angle += spin * step;
  }
  return motion.X_GK.p.z();
}

double Volume(const HeightGrid& grid, bool below) {
  double volume = 0.0;
  for (double height : grid.heights_m) {
    if ((height < 0.0) == below) volume += std::fabs(height) * grid.cell_m * grid.cell_m;
  }
  return volume;
}

TEST(Rut, ConservesVolume) {
  HeightGrid grid = LevelGrid(-1.0, 3.0, 1.6, 0.02);
  DrivePass(grid, AxelWheel(12), 200.0, 0.1);
  ASSERT_GT(Volume(grid, true), 1e-4);
  EXPECT_NEAR(Volume(grid, false) / Volume(grid, true), 1.0, 0.01);
}

TEST(Rut, IsPressedUnderTheWheelAndHeapedBesideIt) {
  HeightGrid grid = LevelGrid(-1.0, 3.0, 1.6, 0.02);
  DrivePass(grid, AxelWheel(0), 200.0, 0.1);
  EXPECT_LT(grid.Height(0.5, 0.0), -0.008);
  EXPECT_GT(grid.Height(0.5, 0.12), 0.002);
  EXPECT_EQ(grid.Height(0.5, 0.5), 0.0);
  EXPECT_GT(grid.revision, 100u);
}

TEST(Rut, WallsSlumpToTheFrictionAngle) {
  HeightGrid grid = LevelGrid(-1.0, 3.0, 1.6, 0.02);
  DrivePass(grid, AxelWheel(0), 300.0, 0.3);
  double steepest = 0.0;
  for (double y = -0.3; y < 0.3; y += grid.cell_m) {
    steepest = std::max(
        steepest, std::fabs(grid.Height(0.3, y + grid.cell_m) - grid.Height(0.3, y)) / grid.cell_m);
  }
  EXPECT_GT(steepest, 0.2);
  EXPECT_LT(steepest, 1.15 * std::tan(Radians(29.0)));
}

TEST(Rut, SlumpsByTheTimeAndNotByTheNumberOfPasses) {
  // A ridge beside a wheel that hangs above the soil, for 40 ms in passes of 1, 2 and 4 ms.
  const RimPlace rim{{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, 0.3, 0.15, 0.15};
  const SoilLaws laws = MakeRimLaws(Soil("pavlov_90"), 0.15);
  const auto ridge = [&](double pass_s) {
    HeightGrid grid = LevelGrid(-1.0, 2.0, 1.2, 0.02);
    for (int ix = 45; ix < 56; ++ix) grid.heights_m[34 * grid.nx + ix] = 0.03;
    RutScratch scratch;
    for (double t = 0.0; t < 0.04 - 1e-9; t += pass_s) {
      SlumpBeside(grid, rim, laws, pass_s, scratch);
    }
    EXPECT_NEAR(Volume(grid, false), 11 * 0.03 * 0.02 * 0.02, 1e-12);
    return grid.heights_m[34 * grid.nx + 50];
  };
  const double fine_m = ridge(1e-3);
  EXPECT_LT(fine_m, 0.025);
  EXPECT_NEAR(ridge(2e-3), fine_m, 2e-4);
  EXPECT_NEAR(ridge(4e-3), fine_m, 4e-4);
}

TEST(Rut, SecondPassSinksLittleFurther) {
  HeightGrid grid = LevelGrid(-1.0, 3.0, 1.6, 0.02);
  const WheelModel wheel = AxelWheel(0);
  const double first_m = wheel.rim_radius_m - DrivePass(grid, wheel, 200.0, 0.0);
  const double second_m = wheel.rim_radius_m - DrivePass(grid, wheel, 200.0, 0.0);
  EXPECT_GT(second_m, first_m - 1e-3);
  EXPECT_LT(second_m, 1.35 * first_m);
}

}  // namespace
}  // namespace dockyard::soil_test
