// Marks in soil against Bekker's law, the theory of passive walls and the balance of volume, by
// hand.
#include "sim/rigid/marking_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"
#include "models/read/load_soil.h"
#include "sim/soil/plate_mark.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kStep = 1e-3, kPlate_m = 0.062, kArea_m2 = 0.25 * kPi * kPlate_m * kPlate_m;
constexpr double kStiffness = 2e4, kFriction = 0.4;

SoilModel Soil(const std::string& name) {
  return LoadSoil(SourceFile("models/soils/" + name + ".yaml"));
}

double BekkerForce(const SoilModel& soil, double depth_m) {
  const double k = soil.k_c / (0.5 * kPlate_m) + soil.k_phi;
  return kArea_m2 * k * std::pow(depth_m, soil.n);
}

double BekkerDepth(const SoilModel& soil, double load_n) {
  const double k = soil.k_c / (0.5 * kPlate_m) + soil.k_phi;
  return std::pow(load_n / kArea_m2 / k, 1.0 / soil.n);
}

// Of soil and tip in series.
double Rebound(const SoilModel& soil, double stiffness = kStiffness) {
  return 1.0 / (1.0 / (kArea_m2 * soil.unloading_stiffness_pa_per_m) + 1.0 / stiffness);
}

/// A plate that goes where it is led, or bears a load.
struct Plate {
  Plate(const SoilModel& soil, HeightGrid* ground, double stiffness = kStiffness)
      : contacts({soil}), ground(ground) {
    const double damping = 0.6 * std::sqrt(kStiffness * kMass_kg);
    contacts.Add({stiffness, damping, kFriction}, kPlate_m);
  }
  Vector3d GoTo(const Vector3d& to, double speed_m_s) {
    const long steps = std::max(1L, std::lround((to - p).norm() / speed_m_s / step_s));
    v = (to - p) / (static_cast<double>(steps) * step_s);
    Vector3d force = Vector3d::Zero();
    for (long i = 0; i < steps; ++i) {
      p += step_s * v;
      force = Force();
    }
    return force;
  }
  /// Under a load that changes slowly.
  void Bear(double from_n, double to_n, double seconds) {
    const long steps = std::lround(seconds / step_s);
    for (long i = 0; i < steps; ++i) {
      const double load_n = from_n + (to_n - from_n) * static_cast<double>(i) / steps;
      v += step_s / kMass_kg * (Force() - load_n * Vector3d::UnitZ());
      p += step_s * v;
    }
  }
  void Lift() {
    p.z() = 0.2;
    v.setZero();
    for (int i = 0; i < 20000; ++i) Force();
  }
  Vector3d Force() {
    const Vector3d force = contacts.Step(*ground, 0, p, v, step_s);
    contacts.Slump(*ground, step_s);
    return force;
  }

  static constexpr double kMass_kg = 1.3;
  double step_s = kStep;
  MarkingContacts contacts;
  HeightGrid* ground;
  Vector3d p = Vector3d::Zero(), v = Vector3d::Zero();
};

HeightGrid Level() { return LevelGrid(-0.5, 1.0, 0.6, 0.02); }

double Volume(const HeightGrid& grid, double sign) {
  double volume = 0.0;
  for (const double height : grid.heights_m) volume += std::max(0.0, sign * height);
  return volume * grid.cell_m * grid.cell_m;
}

double Steepest(const HeightGrid& grid) {
  double steepest = 0.0;
  for (int iy = 0; iy + 1 < grid.ny; ++iy) {
    for (int ix = 0; ix + 1 < grid.nx; ++ix) {
      const double* at = grid.heights_m.data() + iy * grid.nx + ix;
      steepest = std::max({steepest, std::abs(at[1] - at[0]), std::abs(at[grid.nx] - at[0])});
    }
  }
  return steepest / grid.cell_m;
}

TEST(MarkingContacts, SinkByBekkersLawAndLeaveTheDepthLessTheRebound) {
  for (const auto& [name, load_n] :
       {std::pair{"loose_sand", 100.0}, std::pair{"compact_gravel", 900.0}}) {
    const SoilModel soil = Soil(name);
    HeightGrid ground = Level();
    constexpr double kStiff = 1e7;
    Plate plate(soil, &ground, kStiff);
    const double depth_m = BekkerDepth(soil, load_n);
    plate.Bear(0.0, load_n, 4.0);
    plate.Bear(load_n, load_n, 1.0);
    EXPECT_NEAR(-plate.p.z(), depth_m, 0.01 * depth_m) << name;
    const double left_m = depth_m - load_n / Rebound(soil, kStiff);
    EXPECT_GT(left_m, 1e-3) << name;
    EXPECT_NEAR(-ground.Height(0.0, 0.0), left_m, 0.015 * depth_m) << name;
  }
}

TEST(MarkingContacts, SinkAsDeepWithHalfTheStep) {
  std::vector<double> floors_m;
  for (const double step_s : {1e-3, 5e-4}) {
    HeightGrid ground = Level();
    Plate plate(Soil("loose_sand"), &ground);
    plate.step_s = step_s;
    plate.Bear(0.0, 60.0, 4.0);
    floors_m.push_back(ground.Height(0.0, 0.0));
  }
  EXPECT_LT(floors_m.front(), -0.01);
  EXPECT_NEAR(floors_m.front(), floors_m.back(), 2e-5);
}

TEST(MarkingContacts, BearTheSameLoadAgainWithoutGoingDeeper) {
  const SoilModel soil = Soil("loose_sand");
  HeightGrid ground = Level();
  Plate first(soil, &ground);
  first.Bear(0.0, 100.0, 4.0);
  const double floor_m = ground.Height(0.0, 0.0);
  Plate second(soil, &ground);
  second.p.z() = floor_m;
  second.Bear(0.0, 98.0, 4.0);
  EXPECT_EQ(ground.Height(0.0, 0.0), floor_m);
  EXPECT_NEAR(second.p.z(), floor_m - 98.0 / Rebound(soil), 1e-4);
  second.Bear(98.0, 150.0, 4.0);
  EXPECT_NEAR(-second.p.z(), BekkerDepth(soil, 150.0), 0.01 * BekkerDepth(soil, 150.0));
}

TEST(MarkingContacts, PloughAFurrowWhoseVolumeBecomesItsHeap) {
  HeightGrid ground = Level();
  Plate plate(Soil("loose_sand"), &ground);
  plate.p.x() = -0.2;
  plate.GoTo({-0.2, 0.0, -0.015}, 0.01);
  plate.GoTo({0.2, 0.0, -0.015}, 0.05);
  plate.Lift();
  const double furrow_m3 = Volume(ground, -1.0);
  EXPECT_NEAR(Volume(ground, 1.0), furrow_m3, 1e-9 * furrow_m3);
  // Of a trench as wide as the plate and as long as its path, some has slid back.
  EXPECT_GT(furrow_m3, 0.3 * kPlate_m * 0.4 * 0.012);
  EXPECT_LT(furrow_m3, 1.6 * kPlate_m * 0.45 * 0.015);
  EXPECT_LT(ground.Height(0.0, 0.0), -0.006);
  EXPECT_GT(ground.Height(0.0, 0.07), 0.002);
  EXPECT_NEAR(ground.Height(0.0, 0.07), ground.Height(0.0, -0.07), 1e-3);
  EXPECT_GT(ground.Height(0.24, 0.0), 0.002);  // pushed ahead
}

TEST(MarkingContacts, LeaveNoSlopeSteeperThanTheAngleOfRepose) {
  const SoilModel soil = Soil("loose_sand");
  HeightGrid ground = Level();
  Plate plate(soil, &ground);
  plate.p.x() = -0.2;
  plate.GoTo({-0.2, 0.0, -0.04}, 0.05);
  plate.GoTo({0.2, 0.05, -0.04}, 0.05);
  EXPECT_GT(Steepest(ground), 0.5);
  plate.Lift();
  EXPECT_GT(Steepest(ground), 0.4);
  EXPECT_LT(Steepest(ground), std::tan(soil.friction_angle_rad) + 1e-5 / ground.cell_m + 1e-9);
}

// Rankine's passive wall of soil under a heap (docs/reference/soil.md) over the plate's width.
TEST(MarkingContacts, AreHeldByFrictionAndByTheWallThatTheyPlough) {
  const SoilModel soil = Soil("loose_sand");
  HeightGrid ground = Level();
  Plate plate(soil, &ground);
  plate.p.x() = -0.2;
  const double depth_m = 0.03;
  plate.GoTo({-0.2, 0.0, -depth_m}, 0.01);
  const Vector3d force = plate.GoTo({0.1, 0.0, -depth_m}, 0.05);
  const double bearing_n = BekkerForce(soil, depth_m);
  EXPECT_NEAR(force.z(), bearing_n, 0.01 * bearing_n);
  const double sunk_m = depth_m - bearing_n / Rebound(soil);
  const double root = std::tan(0.25 * kPi + 0.5 * soil.friction_angle_rad), n_phi = root * root;
  const double weight = 0.5 * soil.density_kg_m3 * 9.81 * n_phi *
                        (1.0 + 0.5 * root * std::tan(soil.friction_angle_rad));
  const double wall_n =
      kPlate_m * (4.8 * weight * sunk_m * sunk_m + 2.0 * soil.cohesion_pa * root * sunk_m);
  EXPECT_GT(wall_n, 3.0);
  EXPECT_NEAR(-force.x(), kFriction * bearing_n + wall_n, 0.02 * (kFriction * bearing_n + wall_n));
  // In its own furrow there is a wall of the soil alone that has slid in.
  const Vector3d back = plate.GoTo({-0.1, 0.0, -depth_m}, 0.05);
  EXPECT_LT(back.x(), kFriction * back.z() + 0.5 * wall_n);
  EXPECT_GE(back.x(), kFriction * back.z() - 1e-9);
}

TEST(MarkingContacts, BearOnTheSoilAsItWasAndNotOnAHeap) {
  HeightGrid ground = Level();
  KeepUndisturbed(ground);
  AddSoil(ground, {0.0, 0.0}, 0.02 * 0.02 * 0.03);
  ASSERT_GT(ground.Height(0.0, 0.0), 0.02);
  Plate plate(Soil("loose_sand"), &ground);
  plate.p.z() = 0.03;
  EXPECT_EQ(plate.GoTo({0.0, 0.0, 0.005}, 0.01).norm(), 0.0);
  EXPECT_LT(ground.Height(0.0, 0.0), 0.0051);
  EXPECT_NEAR(Volume(ground, 1.0), 0.02 * 0.02 * 0.03, 1e-15);
  EXPECT_GT(plate.GoTo({0.0, 0.0, -0.005}, 0.01).z(), 1.0);
}

TEST(MarkingContacts, LeaveAloneWhatBearsThem) {
  HeightGrid ground = Level();
  Plate plate(Soil("compact_gravel"), &ground);
  plate.Bear(0.0, 15.0, 1.0);
  plate.Bear(15.0, 15.0, 1.0);
  EXPECT_NEAR(plate.p.z(), -15.0 / Rebound(Soil("compact_gravel")), 1e-6);
  EXPECT_EQ(Volume(ground, -1.0), 0.0);
}

}  // namespace
}  // namespace dockyard
