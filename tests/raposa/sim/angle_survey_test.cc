// How well RAPOSA's controller knows its angle about the guide once it has moved a little: robots,
// lights and grounds as the acceptance draws them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <vector>

#include "sim/app/scenario_options.h"
#include "sim/app/systems.h"
#include "sim/plan/make_run.h"
#include "sim/run/loop.h"
#include "support/source_tree.h"

namespace dockyard::raposa {
namespace {

constexpr double kRange_m = 1.33, kMoved_m = 0.2;
constexpr double kLever_m = 0.25;  // from R back to the camera, about

Eigen::Vector2d CameraOf(const Pose2& X_DR) {
  const Pose2 X_DC = X_DR * Pose2{-kLever_m, 0.0, 0.0};
  return {X_DC.x, X_DC.y};
}

double AngleOf(const Eigen::Vector2d& p_DC) { return std::atan2(p_DC.y(), p_DC.x()); }

/// Of the belief, at the first sample with a belief once the camera has moved.
std::optional<double> AngleError(const RunRecord& record) {
  double moved_m = 0.0;
  Eigen::Vector2d last = CameraOf(record.history.front().X_DR);
  for (const HistorySample& sample : record.history) {
    const Eigen::Vector2d now = CameraOf(sample.X_DR);
    moved_m += (now - last).norm();
    last = now;
    if (moved_m < kMoved_m || !sample.located) continue;
    return WrapPi(AngleOf(CameraOf(sample.X_DR_believed)) - AngleOf(now));
  }
  return std::nullopt;
}

struct Errors {
  int without = 0;
  std::vector<double> deg;  // without their signs
  void Add(const std::optional<double>& error) {
    if (error) deg.push_back(std::abs(Degrees(*error)));
    without += !error;
  }
  double RmsUpTo(double most_deg) const {
    double sum2 = 0.0;
    int count = 0;
    for (const double each : deg) {
      if (each > most_deg) continue;
      sum2 += each * each;
      ++count;
    }
    return std::sqrt(sum2 / std::max(1, count));
  }
  double Median() const {
    std::vector<double> sorted = deg;
    std::ranges::sort(sorted);
    return sorted.empty() ? 180.0 : sorted[sorted.size() / 2];
  }
};

// The aims are 2 deg to 60 deg off the axis and 4 deg to 110 deg, root of the mean square.
// docs/raposa.md tells how far they are missed. Half of the runs are good to 1.5 and 2 deg.
TEST(RaposaAngleSurvey, HalfOfTheRunsKnowTheirAngleAfterAFifthOfAMetre) {
  const char* given = std::getenv("ANGLE_RUNS");
  const int count = given ? std::atoi(given) : 200;
  const std::vector<System> systems = Systems();
  const std::vector<KnownSystem> known = KnownSystems(systems);
  const Campaign campaign = LoadCampaign(SourceFile("scenarios/raposa_acceptance.yaml"),
                                         {"seed=1330"}, CampaignSystemsOf(systems));
  const RunMaker maker(campaign, known);
  Errors near_axis, all;
  for (int i = 0; i < count; ++i) {
    CampaignRun run = maker.Make(i);
    run.scenario.start.SetInFile("r_m", kRange_m);
    run.scenario.time_limit_s = 12.0;
    const RunRecord record = Simulate(FindSystem(systems, "raposa"), run, {});
    const std::optional<double> error = AngleError(record);
    const double alpha_deg = std::abs(Degrees(run.scenario.start.on_plane().alpha));
    all.Add(error);
    if (alpha_deg <= 60.0) near_axis.Add(error);
    if (!error || std::abs(*error) > Radians(5.0)) {
      std::printf("  run %d: alpha %.1f deg, %s %.1f deg\n", i + 1, alpha_deg,
                  error ? "off by" : "no belief", error ? Degrees(*error) : 0.0);
    }
  }
  for (const auto& [name, errors] : {std::pair{"to 60 deg", near_axis}, {"to 110 deg", all}}) {
    std::printf(
        "%s: %zu runs, %d without a belief, median %.2f deg, rms %.2f deg, of those within "
        "20 deg %.2f deg\n",
        name, errors.deg.size() + static_cast<std::size_t>(errors.without), errors.without,
        errors.Median(), errors.RmsUpTo(180.0), errors.RmsUpTo(20.0));
  }
  EXPECT_LE(near_axis.Median(), 1.5);
  EXPECT_LE(all.Median(), 2.0);
}

}  // namespace
}  // namespace dockyard::raposa
