// What the paper's tracker takes for the summit of a rounded boulder, on rendered image pairs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "controller/base/number_text.h"
#include "controller/rocky7/face_tracker.h"
#include "rocky7/sim/test_scenario.h"
#include "sim/rocky7/rocky7_plant.h"

namespace dockyard::rocky7 {
namespace {

// A boulder of 0.5 to 0.8 m with its summit 0.15 to 0.35 m up, by the seed.
Scenario BeforeSummit(std::uint64_t seed, double from_m, Light light) {
  const double width_m = 0.5 + 0.05 * static_cast<double>(seed % 7);
  const double up_m = 0.15 + 0.04 * static_cast<double>(seed % 6);
  Scenario scenario = OnGravel("{task: place, boulder: rounded, face_up_deg: 90, boulder_m: " +
                                   NumberText(width_m) + ", target_up_m: " + NumberText(up_m) + "}",
                               from_m, 9.0);
  scenario.light = light;
  scenario.seed = seed;
  return scenario;
}

// An image pair of the nominal mast cameras, and where the summit is in E.
struct SummitPair {
  SummitPair(std::uint64_t seed, double from_m, Light light)
      : scenario(BeforeSummit(seed, from_m, light)), plant(scenario, Built(scenario), kept) {
    const SensorFrame sensed = plant.Sense();
    attitude = sensed.imu;
    const std::vector<CameraImage> images = plant.TakeImages({kMastLeft, kMastRight}, 0.0);
    pair = {std::get<GrayImage>(images[0].pixels), std::get<GrayImage>(images[1].pixels)};
    X_EG = LevelFrame(plant.built().nominal, attitude) * Inverse(plant.truth().X_WR) * plant.X_WG();
    p_ET = X_EG * plant.target_G();
  }
  static BuiltRun Built(const Scenario& scenario) {
    BuiltRun built = BuildRun(scenario, LoadModels(scenario));
    built.mast_pair = built.world.robot.mast_pair.nominal;
    return built;
  }
  /// Of the boulder in the window about a place; the ground's where there is none.
  double HighestAbout(const Eigen::Vector2d& p_E) const {
    double highest_m = 0.0;
    for (const Eigen::Vector3d& vertex : plant.built().world.boulder->vertices) {
      const Eigen::Vector3d at = X_EG * vertex;
      const bool within = (at.head<2>() - p_E).cwiseAbs().maxCoeff() < nominal().nesnas.window_m;
      if (within) highest_m = std::max(highest_m, at.z());
    }
    return highest_m;
  }
  const Nominal& nominal() const { return plant.built().nominal; }

  std::shared_ptr<KeptRenderer> kept = std::make_shared<KeptRenderer>();
  Scenario scenario;
  Rocky7Plant plant;
  ImuSample attitude;
  StereoImages pair;
  Pose3 X_EG;
  Eigen::Vector3d p_ET{0, 0, 0};
};

// By how much the tracker's summit is higher than the rock is in its window; none: no summit.
std::vector<double> TooHigh(double from_m, double predicted_off_m, bool without_filter) {
  std::vector<double> up_m;
  for (const Light light : {Light::kEven, Light::kSpeckled, Light::kHardShadow}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const SummitPair at(seed, from_m, light);
      const double angle_rad = 2.4 * static_cast<double>(seed);
      Eigen::Vector3d expected_E = at.p_ET;
      expected_E.head<2>() +=
          predicted_off_m * Eigen::Vector2d(std::cos(angle_rad), std::sin(angle_rad));
      const FaceStereo stereo(at.nominal(), FrontEnd::kBlocks7);
      FaceView view = stereo.Look(at.pair, at.nominal().mast.watch_rad, at.attitude, expected_E);
      if (without_filter) {
        view.disparities = Match(
            Rectifier(at.nominal().mast.pair_K), at.pair,
            {.matcher = Matcher::kBandPassed, .block_px = 7, .count_px = 128, .speckle_px = 0});
      }
      const FaceSighting found =
          MakeTopTracker(at.nominal().nesnas)->Follow(stereo, view, {expected_E, 0.0, 0.0});
      if (found.found) up_m.push_back(found.p_E.z() - at.HighestAbout(expected_E.head<2>()));
    }
  }
  std::sort(up_m.begin(), up_m.end());
  if (!up_m.empty()) {
    std::printf("%.1f m, %.1f m off: %zu of 12, %.3f %.3f %.3f m high\n", from_m, predicted_off_m,
                up_m.size(), up_m.front(), up_m[up_m.size() / 2], up_m.back());
  }
  return up_m;
}

// All are some centimetres high: blocks reach over the summit's edge, and on a ray that falls the
// nearest range is the highest.
TEST(Rocky7TopView, NoSummitIsAnOutlier) {
  for (const double off_m : {0.0, 0.1}) {
    for (const double from_m : {3.0, 5.0}) {
      const std::vector<double> up_m = TooHigh(from_m, off_m, false);
      ASSERT_GE(up_m.size(), 8u);  // in the others there is no range data
      EXPECT_GT(up_m.front(), -0.1);
      EXPECT_LT(up_m.back(), 0.1);
    }
  }
}

// A maximum takes outliers: what keeps them out is that small patches of disparity are left out, as
// matchers did in the 1990s.
TEST(Rocky7TopView, WithoutTheFilterOfSmallPatchesSomeSummitIsAnOutlier) {
  const std::vector<double> up_m = TooHigh(3.0, 0.0, true);
  ASSERT_GE(up_m.size(), 10u);
  EXPECT_GT(up_m.back(), 0.3);
}

}  // namespace
}  // namespace dockyard::rocky7
