// A flat plate pressed into level soil, patch by patch through the code that loads a wheel's
// patches: Bekker's curve, and unloading and reloading along the elastic line.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "soil/rig.h"

namespace dockyard::soil_test {
namespace {

/// A square plate of 5 x 5 patches that faces down, lowered and raised at a set speed.
class Plate {
 public:
  Plate(const SoilModel& soil, double width_m)
      : laws_(MakeRimLaws(soil, width_m)), width_m_(width_m) {
    grid_.undisturbed_m = grid_.heights_m;
    motion_.v_GK_G.setZero();
  }

  /// To this depth in steps of a micrometre, slowly, so that damping counts for nothing [Pa].
  double MoveTo(double depth_m) {
    const int steps = static_cast<int>(std::lround(std::abs(depth_m - depth_m_) / 1e-6));
    for (int i = 0; i < steps; ++i) Step(depth_m > depth_m_ ? 1e-6 : -1e-6, 0.1);
    return pressure_pa_;
  }
  /// Free to sink under a weight that is put on within so many seconds, and three more at rest.
  void Load(double weight_n, double within_s) {
    constexpr double kDt_s = 1e-3;
    const double mass_kg = weight_n / 9.81;
    double speed_m_s = 0.0;
    for (double t = 0.0; t < within_s + 3.0; t += kDt_s) {
      const double carried_n = pressure_pa_ * width_m_ * width_m_;
      speed_m_s += (weight_n * std::min(1.0, t / within_s) - carried_n) / mass_kg * kDt_s;
      Step(speed_m_s * kDt_s, kDt_s);
    }
    EXPECT_LT(std::abs(speed_m_s), 1e-6);
  }
  double depth_m() const { return depth_m_; }

 private:
  static constexpr int kPatches = 5;  // along each side

  void Step(double down_m, double dt_s) {
    depth_m_ += down_m;
    const double side_m = width_m_ / kPatches, area_m2 = side_m * side_m;
    motion_.v_GK_G.z() = -down_m / dt_s;
    double force_n = 0.0;
    for (int ix = 0; ix < kPatches; ++ix) {
      motion_.X_GK.p = Eigen::Vector3d((ix - 2) * side_m, 0.0, -depth_m_);
      const WheelFrame frame(motion_, dt_s);
      const SpokeAxes down = frame.Along(0.0, 1.0);
      for (int iy = 0; iy < kPatches; ++iy) {
        const PatchPlace at(GroundUnder(grid_), frame, down, 0.0, (iy - 2) * side_m, 0.0);
        const SpokeLoad load =
            LoadPatch(laws_, travel_, 0.015, at, area_m2, dt_s, patches_[ix * kPatches + iy]);
        force_n -= load.r;
        EXPECT_EQ(load.t, 0.0);
        EXPECT_EQ(load.a, 0.0);
      }
    }
    pressure_pa_ = force_n / (width_m_ * width_m_);
  }

  SoilLaws laws_;
  double width_m_, depth_m_ = 0.0, pressure_pa_ = 0.0;
  HeightGrid grid_ = LevelGrid(-1.0, 2.0, 2.0, 0.1);
  WheelMotion motion_;
  WheelTravel travel_;
  std::array<Patch, kPatches * kPatches> patches_;
};

/// A soil whose bearing does not depend on how a patch moved. Otherwise the law counts lifting as
/// it counts sliding (BearingShare), and a plate raised by millimetres comes back to less than it
/// bore: docs/results/physics_checks.md.
SoilModel Unweakened(const char* name) {
  SoilModel soil = Soil(name);
  soil.slip_weakening = 0.0;
  return soil;
}

/// A soil's published constants (docs/results/soil.md), and two plates that it has to carry
/// differently.
struct Bed {
  const char* soil;
  double n, k_c, k_phi;
  std::array<double, 2> widths_m;
};
const std::array kBeds = {Bed{"lete_sand", 0.793, 102e3, 5301e3, {0.05, 0.15}},
                          Bed{"grc_1", 1.27, -2.02e5, 2.99e6, {0.10, 0.30}}};

double Bekker(const Bed& bed, double width_m, double depth_m) {
  return (bed.k_c / width_m + bed.k_phi) * std::pow(depth_m, bed.n);
}

TEST(Plate, SinksAlongBekkersCurveForTwoSoilsAndTwoWidths) {
  for (const Bed& bed : kBeds) {
    for (const double width_m : bed.widths_m) {
      Plate plate(Soil(bed.soil), width_m);
      for (const double depth_m : {0.002, 0.005, 0.01, 0.02, 0.04}) {
        EXPECT_NEAR(plate.MoveTo(depth_m) / Bekker(bed, width_m, depth_m), 1.0, 1e-3)
            << bed.soil << " " << width_m << " " << depth_m;
      }
    }
    // Width counts: otherwise the above would hold for k_phi alone.
    EXPECT_GT(std::abs(Bekker(bed, bed.widths_m[0], 0.01) / Bekker(bed, bed.widths_m[1], 0.01) - 1),
              0.2);
  }
}

TEST(Plate, SinksUnderAWeightToWhereBekkerCarriesIt) {
  for (const Bed& bed : kBeds) {
    for (const double width_m : bed.widths_m) {
      Plate plate(Soil(bed.soil), width_m);
      const double weight_n = 20e3 * width_m * width_m;  // 20 kPa
      plate.Load(weight_n, 20.0);                        // slowly: what it overshoots, it keeps
      const double depth_m = std::pow(20e3 / Bekker(bed, width_m, 1.0), 1.0 / bed.n);
      EXPECT_NEAR(plate.depth_m() / depth_m, 1.0, 0.01) << bed.soil << " " << width_m;
    }
  }
}

TEST(Plate, UnloadsAndReloadsAlongTheElasticLineAndThenSinksOn) {
  for (const Bed& bed : kBeds) {
    for (const double width_m : bed.widths_m) {
      SCOPED_TRACE(testing::Message() << bed.soil << " " << width_m);
      const SoilModel soil = Unweakened(bed.soil);
      const double K = soil.unloading_stiffness_pa_per_m;
      Plate plate(soil, width_m);
      const double deepest_m = 0.02, most_pa = plate.MoveTo(deepest_m);
      const double rebound_m = most_pa / K;
      for (const double share : {0.25, 0.5, 0.75}) {
        EXPECT_NEAR(plate.MoveTo(deepest_m - share * rebound_m) / most_pa, 1.0 - share, 2e-3);
      }
      // Clear of the soil's floor nothing pulls, although it is still below the level.
      EXPECT_EQ(plate.MoveTo(deepest_m - 1.02 * rebound_m), 0.0);
      EXPECT_GT(plate.depth_m(), 0.5 * deepest_m);
      // Back: nothing above the floor, the line, the point where it yielded, and the curve.
      EXPECT_NEAR(plate.MoveTo(deepest_m - 0.5 * rebound_m) / most_pa, 0.5, 2e-3);
      EXPECT_NEAR(plate.MoveTo(deepest_m) / most_pa, 1.0, 2e-3);
      EXPECT_NEAR(plate.MoveTo(0.03) / Bekker(bed, width_m, 0.03), 1.0, 1e-3);
    }
  }
}

TEST(Plate, SetsByWhatItPressedInForGoodHoweverOftenItIsLoaded) {
  const Bed& bed = kBeds[0];
  const SoilModel soil = Unweakened(bed.soil);
  Plate plate(soil, 0.05);
  const double most_pa = plate.MoveTo(0.01),
               rebound_m = most_pa / soil.unloading_stiffness_pa_per_m;
  for (int i = 0; i < 5; ++i) {
    EXPECT_EQ(plate.MoveTo(0.01 - 1.1 * rebound_m), 0.0);
    EXPECT_NEAR(plate.MoveTo(0.01) / most_pa, 1.0, 2e-3);
  }
}

}  // namespace
}  // namespace dockyard::soil_test
