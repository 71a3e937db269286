// How well RAPOSA's controller knows its angle about the guide once it has moved a little: robots,
// lights and grounds as the acceptance draws them.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "sim/app/scenario_options.h"
#include "sim/app/systems.h"
#include "sim/plan/make_run.h"
#include "sim/run/loop.h"

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
  int runs = 0, without = 0;
  double sum2 = 0.0, most = 0.0;
  void Add(const std::optional<double>& error) {
    ++runs;
    if (!error) ++without;
    sum2 += error ? *error * *error : 0.0;
    most = std::max(most, error ? std::abs(*error) : 0.0);
  }
  double rms_deg() const { return Degrees(std::sqrt(sum2 / std::max(1, runs - without))); }
};

// The bars: 2 deg to 60 deg off the axis, 4 deg to 110 deg, root of the mean square.
TEST(RaposaAngleSurvey, KnowsItsAngleAfterAFifthOfAMetre) {
  const char* given = std::getenv("ANGLE_RUNS");
  const int count = given ? std::atoi(given) : 200;
  const std::vector<System> systems = Systems();
  const std::vector<KnownSystem> known = KnownSystems(systems);
  const Campaign campaign = LoadCampaign(DOCKYARD_SOURCE_DIR "/scenarios/raposa_acceptance.yaml",
                                         {"seed=1330"}, CampaignSystemsOf(systems));
  const RunMaker maker(campaign, known);
  Errors near_axis, all;
  for (int i = 0; i < count; ++i) {
    CampaignRun run = maker.Make(i);
    run.scenario.start.r = kRange_m;
    run.scenario.time_limit_s = 12.0;
    const RunRecord record = Simulate(FindSystem(systems, "raposa"), run, {});
    const std::optional<double> error = AngleError(record);
    const double alpha_deg = std::abs(Degrees(run.scenario.start.alpha));
    all.Add(error);
    if (alpha_deg <= 60.0) near_axis.Add(error);
    if (!error || std::abs(*error) > Radians(5.0)) {
      std::printf("  run %d: alpha %.1f deg, %s %.1f deg\n", i + 1, alpha_deg,
                  error ? "off by" : "no belief", error ? Degrees(*error) : 0.0);
    }
  }
  for (const auto& [name, errors] : {std::pair{"to 60 deg", near_axis}, {"to 110 deg", all}}) {
    std::printf("%s: %d runs, %d without a belief, rms %.2f deg, at most %.1f deg\n", name,
                errors.runs, errors.without, errors.rms_deg(), Degrees(errors.most));
  }
  EXPECT_LE(near_axis.rms_deg(), 2.0);
  EXPECT_LE(all.rms_deg(), 4.0);
}

}  // namespace
}  // namespace dockyard::raposa
