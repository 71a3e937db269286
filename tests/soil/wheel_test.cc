// One wheel on the soil: rest, slopes, drops, rolling, symmetry, repeatability.
#include "sim/soil/wheel_soil.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/hash.h"
#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

constexpr double kStep_s = 1e-3;

/// A braked wheel of this mass, free to move without turning, under a constant force.
struct BrakedWheel {
  HeightGrid grid = LevelGrid(-1.0, 2.0, 1.2, 0.02);
  WheelSoil contact;
  double mass_kg = 20.0, step_s = kStep_s;
  WheelMotion motion;
  WheelLoad load;

  BrakedWheel(const WheelModel& wheel, const SoilModel& soil, double height_m,
              double set_step_s = kStep_s)
      : contact(wheel, soil), step_s(set_step_s) {
    motion.X_GK.p = Eigen::Vector3d(0.0, 0.0, height_m);
  }
  void Run(double seconds, const Eigen::Vector3d& force_G) {
    const int steps = static_cast<int>(seconds / step_s);
    for (int i = 0; i < steps; ++i) {
      load = contact.Step(grid, motion, step_s);
      motion.v_GK_G += (load.force_G + force_G) / mass_kg * step_s;
      motion.X_GK.p += motion.v_GK_G * step_s;
    }
  }
};

Eigen::Vector3d WeightOnSlope(double weight_n, double slope_rad) {
  return {-weight_n * std::sin(slope_rad), 0.0, -weight_n * std::cos(slope_rad)};
}

TEST(Wheel, AboveTheSoilFeelsNothing) {
  BrakedWheel wheel(AxelWheel(12), Soil("pavlov_90"), 0.5);
  wheel.Run(kStep_s, Eigen::Vector3d::Zero());
  EXPECT_EQ(wheel.load.force_G.norm(), 0.0);
  EXPECT_LE(wheel.load.sinkage_m, 0.0);
}

TEST(Wheel, SettlesAfterADrop) {
  for (const SoilModel& soil : {Soil("pavlov_90"), Soil("compact_gravel")}) {
    for (int paddles : {0, 12}) {
      BrakedWheel wheel(AxelWheel(paddles), soil, 0.38);
      wheel.Run(3.0, WeightOnSlope(200.0, 0.0));
      EXPECT_LT(wheel.motion.v_GK_G.norm(), 1e-5) << soil.name << paddles;
      EXPECT_NEAR(wheel.load.force_G.z(), 200.0, 0.2) << soil.name << paddles;
    }
  }
}

TEST(Wheel, SettlesToTheSameDepthWhateverTheStep) {
  // Heights differ by what the steps err on the way down; it halves with the step.
  std::array<double, 4> height_m{};
  for (int i = 0; i < 4; ++i) {
    BrakedWheel wheel(AxelWheel(12), Soil("pavlov_90"), 0.33, 1e-3 / (1 << i));
    wheel.motion.X_GK.R = RotY(0.5 * kPi);  // a paddle straight down
    wheel.Run(0.5, WeightOnSlope(200.0, 0.0));
    height_m[i] = wheel.motion.X_GK.p.z();
  }
  EXPECT_LT(std::fabs(height_m[0] - height_m[1]), 4e-5);
  // Down to some micrometres, which depend on where the last swing ends.
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT(std::fabs(height_m[i + 1] - height_m[i + 2]),
              std::max(4e-6, 0.7 * std::fabs(height_m[i] - height_m[i + 1])));
  }
}

TEST(Wheel, GainsNoEnergyInABounce) {
  BrakedWheel wheel(AxelWheel(0), Soil("compact_gravel"), 0.40);
  const Eigen::Vector3d weight = WeightOnSlope(200.0, 0.0);
  double highest = 0.0;
  bool touched = false;
  for (int i = 0; i < 2000; ++i) {
    wheel.Run(kStep_s, weight);
    touched = touched || wheel.load.sinkage_m > 0.0;
    if (touched) highest = std::max(highest, wheel.motion.X_GK.p.z());
  }
  ASSERT_TRUE(touched);
  EXPECT_LT(highest, 0.35);
}

TEST(Wheel, SinksAsBekkerSays) {
  // Quasi-static lowering of a braked smooth wheel: W = integral of b k z^n over the chord.
  const WheelModel model = AxelWheel(0);
  const SoilModel soil = Soil("pavlov_90");
  HeightGrid grid = LevelGrid(-1.0, 2.0, 1.2, 0.02);
  WheelSoil contact(model, soil);
  WheelMotion motion;
  motion.v_GK_G = Eigen::Vector3d(0.0, 0.0, -1e-3);
  WheelLoad load;
  for (int i = 0; i <= 2000; ++i) {
    motion.X_GK.p = Eigen::Vector3d(0.0, 0.0, 0.30 - 1e-5 * i);
    load = contact.Step(grid, motion, 1e-2);
  }
  double weight_n = 0.0;
  const int strips = 4000;
  const double sinkage = 0.02, half = std::sqrt(0.3 * 0.3 - 0.28 * 0.28), dx = 2 * half / strips;
  for (int i = 0; i < strips; ++i) {
    const double x = -half + (i + 0.5) * dx;
    const double z = std::sqrt(0.09 - x * x) - 0.3 + sinkage;
    weight_n +=
        model.width_m * PlateModulus(soil, model.width_m) * std::pow(std::max(0.0, z), soil.n) * dx;
  }
  // The sides' shear while sinking carries a little of it.
  EXPECT_NEAR(load.force_G.z() / weight_n, 1.0, 0.08);
  EXPECT_NEAR(load.sinkage_m, sinkage, 2e-4);
}

TEST(Wheel, HoldsOnATenDegreeSlopeWithoutCreep) {
  for (const SoilModel& soil : {Soil("pavlov_90"), Soil("compact_gravel")}) {
    for (int paddles : {0, 12}) {
      BrakedWheel wheel(AxelWheel(paddles), soil, 0.335);
      wheel.Run(4.0, WeightOnSlope(200.0, 0.0));
      wheel.Run(4.0, WeightOnSlope(200.0, Radians(10.0)));
      const Eigen::Vector3d at = wheel.motion.X_GK.p;
      wheel.Run(60.0, WeightOnSlope(200.0, Radians(10.0)));
      EXPECT_LT((wheel.motion.X_GK.p - at).norm(), 1e-4) << soil.name << paddles;
    }
  }
}

TEST(Wheel, SlidesDownASlopeSteeperThanTheSoilHolds) {
  BrakedWheel wheel(AxelWheel(0), Soil("pavlov_90"), 0.30);
  wheel.Run(1.0, WeightOnSlope(200.0, 0.0));
  wheel.Run(2.0, WeightOnSlope(200.0, Radians(60.0)));
  EXPECT_LT(wheel.motion.X_GK.p.x(), -0.3);
}

TEST(Wheel, ForgetsTheSoilWhenLifted) {
  BrakedWheel wheel(AxelWheel(12), Soil("pavlov_90"), 0.335);
  const std::uint64_t fresh = WheelSoil(AxelWheel(12), Soil("pavlov_90")).StateHash(kHashSeed);
  wheel.Run(1.0, WeightOnSlope(200.0, Radians(5.0)));
  EXPECT_NE(wheel.contact.StateHash(kHashSeed), fresh);
  wheel.motion.X_GK.p.z() = 0.6;
  wheel.motion.v_GK_G.setZero();
  const WheelLoad load = wheel.contact.Step(wheel.grid, wheel.motion, kStep_s);
  EXPECT_EQ(load.force_G.norm(), 0.0);
  EXPECT_EQ(load.sinkage_m, 0.0);
}

/// A fixed, eventful motion: sinks, rolls, steers, leans and slips; mirrored about y = 0 if asked.
WheelMotion Manoeuvre(double t, bool mirrored) {
  const double side = mirrored ? -1.0 : 1.0;
  const double yaw = 0.5 * t, roll = 0.05 * std::sin(3.0 * t), spin = 1.1 * t;
  WheelMotion motion;
  motion.X_GK.p = Eigen::Vector3d(0.3 * t, side * (0.02 + 0.05 * t), 0.29 + 0.01 * std::cos(5 * t));
  motion.X_GK.R = RotZ(side * yaw) * RotX(side * roll) * RotY(spin);
  motion.v_GK_G = Eigen::Vector3d(0.3, side * 0.05, -0.05 * std::sin(5.0 * t));
  const Eigen::Matrix3d R_heading = RotZ(side * yaw) * RotX(side * roll);
  motion.w_GK_G = Eigen::Vector3d(0.0, 0.0, side * 0.5) +
                  RotZ(side * yaw) * Eigen::Vector3d(side * 0.15 * std::cos(3.0 * t), 0.0, 0.0) +
                  R_heading * Eigen::Vector3d(0.0, 1.1, 0.0);
  return motion;
}

TEST(Wheel, MirroredMotionGivesTheMirroredLoad) {
  for (const SoilModel& soil : {Soil("pavlov_90"), Soil("compact_gravel")}) {
    HeightGrid ground = LevelGrid(-1.0, 3.0, 2.0, 0.02), mirror = ground;
    for (int iy = 0; iy < ground.ny; ++iy) {
      for (int ix = 0; ix < ground.nx; ++ix) {
        const double height = 0.005 * std::sin(0.3 * ix + 0.2 * iy);
        ground.heights_m[iy * ground.nx + ix] = height;
        mirror.heights_m[(ground.ny - 1 - iy) * ground.nx + ix] = height;
      }
    }
    WheelSoil left(AxelWheel(12), soil), right(AxelWheel(12), soil);
    double worst = 0.0, largest = 0.0;
    for (int i = 0; i < 1500; ++i) {
      const WheelLoad a = left.Step(ground, Manoeuvre(i * kStep_s, false), kStep_s);
      const WheelLoad b = right.Step(mirror, Manoeuvre(i * kStep_s, true), kStep_s);
      const Eigen::Vector3d force(b.force_G.x(), -b.force_G.y(), b.force_G.z());
      const Eigen::Vector3d torque(-b.torque_G.x(), b.torque_G.y(), -b.torque_G.z());
      worst = std::max({worst, (a.force_G - force).norm(), (a.torque_G - torque).norm()});
      largest = std::max(largest, a.force_G.norm());
    }
    ASSERT_GT(largest, 100.0);
    EXPECT_LT(worst / largest, 1e-10) << soil.name;
  }
}

TEST(Wheel, SameCallsGiveTheSameBits) {
  HeightGrid ground = LevelGrid(-1.0, 3.0, 2.0, 0.02), again = ground;
  WheelSoil one(AxelWheel(12), Soil("pavlov_90")), two(AxelWheel(12), Soil("pavlov_90"));
  for (int i = 0; i < 1000; ++i) {
    const WheelLoad a = one.Step(ground, Manoeuvre(i * kStep_s, false), kStep_s);
    const WheelLoad b = two.Step(again, Manoeuvre(i * kStep_s, false), kStep_s);
    ASSERT_EQ(a.force_G, b.force_G);
  }
  EXPECT_EQ(one.StateHash(kHashSeed), two.StateHash(kHashSeed));
  EXPECT_EQ(ground.heights_m, again.heights_m);
}

TEST(Wheel, CopyContinuesLikeTheOriginal) {
  HeightGrid ground = LevelGrid(-1.0, 3.0, 2.0, 0.02);
  WheelSoil original(AxelWheel(12), Soil("pavlov_90"));
  for (int i = 0; i < 300; ++i) original.Step(ground, Manoeuvre(i * kStep_s, false), kStep_s);
  HeightGrid other = ground;
  WheelSoil copy = original;
  const WheelLoad a = original.Step(ground, Manoeuvre(0.3, false), kStep_s);
  const WheelLoad b = copy.Step(other, Manoeuvre(0.3, false), kStep_s);
  EXPECT_EQ(a.force_G, b.force_G);
  EXPECT_EQ(original.StateHash(1), copy.StateHash(1));
}

}  // namespace
}  // namespace dockyard::soil_test
