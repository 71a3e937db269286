// Prints of paddles: section, volume, slopes, and where a rolling wheel leaves them.
#include "sim/soil/paddle_print.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

double Sum(const HeightGrid& grid, double sign) {
  double sum = 0.0;
  for (const double height : grid.heights_m) sum += std::max(0.0, sign * height);
  return sum * grid.cell_m * grid.cell_m;
}

// 10 mm thick and 19 mm deep: a V whose walls have slid to 29 deg is 10.3 mm deep.
TEST(PaddlePrint, IsAVOfThePlatesSectionBetweenTwoRidges) {
  const double tan_repose = std::tan(Radians(29.0)), section_m2 = 0.010 * 0.019;
  HeightGrid grid = LevelGrid(-0.3, 0.6, 0.6, 0.002);
  LeavePrint(grid, {.across = {0.0, 1.0}, .width_m = 0.15, .thickness_m = 0.010, .depth_m = 0.019},
             tan_repose);
  const double deep_m = std::sqrt(section_m2 * tan_repose);
  EXPECT_NEAR(-grid.Height(0.0, 0.0), deep_m, 0.06 * deep_m);
  const double half_m = deep_m / tan_repose;
  EXPECT_NEAR(grid.Height(0.5 * half_m, 0.03), -0.5 * deep_m, 0.05 * deep_m);
  const double ridge_m = deep_m / std::sqrt(2.0);
  const double at_m = half_m * (1.0 + 1.0 / std::sqrt(2.0));
  for (const double side : {1.0, -1.0}) {
    EXPECT_NEAR(grid.Height(side * at_m, -0.03), ridge_m, 0.08 * deep_m);
  }
  EXPECT_EQ(grid.Height(0.0, 0.09), 0.0);
}

TEST(PaddlePrint, KeepsItsVolumeOnACoarseGridWhichItDoesNotMakeTooSteep) {
  const double tan_repose = std::tan(Radians(29.0));
  for (const double turn : {0.0, 0.4, 1.2}) {
    HeightGrid grid = LevelGrid(-0.3, 0.6, 0.6, 0.02);
    LeavePrint(grid,
               {.at = {0.013, -0.007},
                .across = {std::sin(turn), std::cos(turn)},
                .width_m = 0.15,
                .thickness_m = 0.010,
                .depth_m = 0.019},
               tan_repose);
    const double cut_m3 = Sum(grid, -1.0);
    EXPECT_NEAR(Sum(grid, 1.0), cut_m3, 1e-12) << turn;
    EXPECT_GT(cut_m3, 0.5 * 0.15 * 0.010 * 0.019) << turn;
    EXPECT_LE(cut_m3, 0.15 * 0.010 * 0.019 + 1e-12) << turn;
    for (int i = 0; i + grid.nx + 1 < grid.nx * grid.ny; ++i) {
      for (const int next : {1, grid.nx}) {
        const double step_m = std::abs(grid.heights_m[i + next] - grid.heights_m[i]);
        EXPECT_LE(step_m, 1.05 * tan_repose * grid.cell_m) << turn;
      }
    }
  }
}

/// Floor of the rut of a wheel that has rolled along +x on its paddles.
std::vector<double> RutFloor(bool prints, int paddles, const char* soil) {
  HeightGrid grid = LevelGrid(-0.5, 2.0, 1.0, 0.02);
  const WheelModel wheel = AxelWheel(paddles);
  WheelSoil contact(wheel, Soil(soil));
  if (prints) contact.PrintPaddles();
  const double step_s = 1e-3, speed_m_s = 0.2, load_n = 200.0, mass_kg = load_n / 9.81;
  const double spin_rad_s = speed_m_s / (wheel.rim_radius_m + 0.5 * wheel.paddle_height_m);
  WheelMotion motion;
  motion.X_GK.p = {0.0, 0.0, wheel.rim_radius_m + wheel.paddle_height_m};
  double sink_m_s = 0.0, angle = 0.0;
  for (int i = 0; i < 5000; ++i) {
    motion.X_GK.R = RotY(angle);
    motion.v_GK_G = {speed_m_s, 0.0, sink_m_s};
    motion.w_GK_G = {0.0, spin_rad_s, 0.0};
    const WheelLoad load = contact.Step(grid, motion, step_s);
    sink_m_s += (load.force_G.z() - load_n) / mass_kg * step_s;
    motion.X_GK.p += step_s * motion.v_GK_G;
    angle += spin_rad_s * step_s;
  }
  std::vector<double> floor;
  for (double x = 0.15; x < 0.8; x += 0.005) floor.push_back(grid.Height(x, 0.0));
  return floor;
}

int Grooves(const std::vector<double>& floor, double least_m) {
  int grooves = 0;
  double high = floor.front(), low = floor.front();
  bool falling = true;
  for (const double height : floor) {
    if (falling) {
      low = std::min(low, height);
      if (height > low + least_m) {
        falling = false;
        ++grooves;
        high = height;
      }
    } else {
      high = std::max(high, height);
      if (height < high - least_m) {
        falling = true;
        low = height;
      }
    }
  }
  return grooves;
}

TEST(PaddlePrint, ComesWithEachPaddleOfARollingWheel) {
  // 0.65 m of rut over a pitch of the rolling wheel, 2 pi 0.315 m / 12 = 0.165 m: 3.9 prints.
  const std::vector<double> with = RutFloor(true, 12, "pavlov_90");
  EXPECT_GE(Grooves(with, 4e-3), 3);
  EXPECT_LE(Grooves(with, 4e-3), 5);
  EXPECT_EQ(Grooves(RutFloor(false, 12, "pavlov_90"), 4e-3), 0);
  // A smooth wheel has none.
  EXPECT_EQ(RutFloor(true, 0, "pavlov_90"), RutFloor(false, 0, "pavlov_90"));
}

}  // namespace
}  // namespace dockyard::soil_test
