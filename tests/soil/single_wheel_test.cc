// The model against measured single-wheel tests in dry sand (data/single_wheel.csv).
//
// Of the rows with |slip| <= 0.76 and side slip <= 45 deg every second one, the first included, was
// used to fit the law's constants; the others check it, though they were in view when its structure
// was chosen (docs/results/soil.md). Locked rows and those at slip 0.9 counted with a quarter and
// half of the weight in the fit. The rows of data/single_wheel_unseen.csv were not at hand then.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "soil/rig.h"
#include "support/source_tree.h"

namespace dockyard::soil_test {
namespace {

struct Trial {
  std::string wheel;  // "grouser" or "smooth"
  double beta_deg = 0.0, slip = 0.0, ahead_n = 0.0, side_n = 0.0, load_n = 0.0;
  double sinkage_mm = 0.0, speed_mm_s = 0.0;
  bool core = false, fitted = false;

  /// The model's answers, simulated when first asked for: each test runs in a process of its own.
  const SingleWheelResult& model() const;
  double AheadError() const { return (model().ahead_n - ahead_n) / load_n; }
  double SideError() const { return (model().side_n - side_n) / load_n; }
  double SinkageError_mm() const { return 1e3 * model().sinkage_m - sinkage_mm; }

 private:
  mutable std::optional<SingleWheelResult> driven_;
};

SingleWheelResult Simulate(const Trial& trial) {
  SingleWheelSetup setup;
  setup.wheel = Wheel("pavlov_" + trial.wheel);
  setup.soil = Soil("pavlov_90");
  setup.load_n = trial.load_n;
  setup.slip = trial.slip;
  setup.side_slip_rad = Radians(trial.beta_deg);
  setup.speed_m_s = 1e-3 * trial.speed_mm_s;
  return RunSingleWheel(setup);
}

const SingleWheelResult& Trial::model() const {
  if (!driven_) {
    driven_ = Simulate(*this);
    std::printf(
        "%-7s %2.0f deg, slip %5.2f: Fx %6.2f (%6.2f) N, Fy %5.2f (%5.2f) N, z %4.1f "
        "(%4.1f) mm, torque %5.3f N m\n",
        wheel.c_str(), beta_deg, slip, driven_->ahead_n, ahead_n, driven_->side_n, side_n,
        1e3 * driven_->sinkage_m, sinkage_mm, driven_->torque_nm);
  }
  return *driven_;
}

std::vector<Trial> ReadTrials(const std::string& name = "single_wheel.csv") {
  std::ifstream file(SourceFile("tests/soil/data/" + name));
  std::vector<Trial> trials;
  std::string line;
  int core_rows = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line[0] == '#' || line.rfind("wheel,", 0) == 0) continue;
    std::stringstream cells(line);
    Trial trial;
    std::string cell;
    std::getline(cells, trial.wheel, ',');
    std::vector<double> v;
    while (std::getline(cells, cell, ',')) v.push_back(std::stod(cell));
    trial.beta_deg = v.at(0);
    trial.slip = v.at(1);
    trial.ahead_n = v.at(2);
    trial.side_n = v.at(3);
    trial.load_n = v.at(4);
    trial.sinkage_mm = v.at(5);
    trial.speed_mm_s = v.at(6);
    trial.core = std::fabs(trial.slip) <= 0.76 && trial.beta_deg <= 45.0;
    trial.fitted = trial.core && core_rows++ % 2 == 0;
    trials.push_back(trial);
  }
  return trials;
}

/// Every trial up to 45 deg of side slip.
const std::vector<Trial>& Trials() {
  static const std::vector<Trial> trials = [] {
    std::vector<Trial> all = ReadTrials();
    std::erase_if(all, [](const Trial& trial) { return trial.beta_deg > 45.0; });
    return all;
  }();
  return trials;
}

const Trial& At(const std::string& wheel, double beta_deg, double slip) {
  for (const Trial& trial : Trials()) {
    if (trial.wheel == wheel && trial.beta_deg == beta_deg && std::fabs(trial.slip - slip) < 0.03) {
      return trial;
    }
  }
  throw std::runtime_error("no such trial");
}

struct Errors {
  double ahead = 0.0, side = 0.0, sinkage_mm = 0.0;  // rms; forces over the load
  int trials = 0;
};

Errors Compare(const std::vector<Trial>& trials, const char* name) {
  Errors sum;
  for (const Trial& trial : trials) {
    sum.ahead += std::pow(trial.AheadError(), 2);
    sum.side += std::pow(trial.SideError(), 2);
    sum.sinkage_mm += std::pow(trial.SinkageError_mm(), 2);
    ++sum.trials;
  }
  const auto rms = [&](double square) { return std::sqrt(square / sum.trials); };
  const Errors errors{rms(sum.ahead), rms(sum.side), rms(sum.sinkage_mm), sum.trials};
  std::printf("%d %s rows: rms Fx %.3f, Fy %.3f of the load, sinkage %.2f mm\n", errors.trials,
              name, errors.ahead, errors.side, errors.sinkage_mm);
  return errors;
}

Errors Compare(const std::string& wheel, bool fitted) {
  std::vector<Trial> trials = Trials();
  std::erase_if(trials, [&](const Trial& trial) {
    return trial.wheel != wheel || !trial.core || trial.fitted != fitted;
  });
  return Compare(trials, fitted ? "fit" : "check");
}

/// Rows that were not at hand when the law's structure was chosen.
Errors CompareUnseen(const std::string& wheel) {
  std::vector<Trial> trials = ReadTrials("single_wheel_unseen.csv");
  std::erase_if(trials, [&](const Trial& trial) { return trial.wheel != wheel || !trial.core; });
  return Compare(trials, "unseen");
}

void ExpectWithin(const Errors& errors, int trials, double ahead, double sinkage_mm) {
  EXPECT_EQ(errors.trials, trials);
  EXPECT_LT(errors.ahead, ahead);
  EXPECT_LT(errors.side, 0.07);
  EXPECT_LT(errors.sinkage_mm, sinkage_mm);
}

TEST(SingleWheel, WithGrousersFollowsTheData) {
  ExpectWithin(Compare("grouser", true), 9, 0.05, 3.5);
  ExpectWithin(Compare("grouser", false), 8, 0.05, 3.5);
}

TEST(SingleWheel, SmoothFollowsTheData) {
  ExpectWithin(Compare("smooth", true), 8, 0.04, 2.5);
  ExpectWithin(Compare("smooth", false), 9, 0.04, 2.5);
}

TEST(SingleWheel, WithGrousersFollowsRowsThatNobodySaw) {
  ExpectWithin(CompareUnseen("grouser"), 11, 0.05, 3.5);
}

TEST(SingleWheel, SmoothFollowsRowsThatNobodySaw) {
  ExpectWithin(CompareUnseen("smooth"), 11, 0.04, 2.5);
}

TEST(SingleWheel, GrousersGainDrawbarAsMeasured) {
  // Within 0.05 of the load at each slip but the last, which counted half in no fit. The smooth
  // wheel's slip is 0.23 where the other's is 0.21.
  for (double slip : {-0.7, -0.5, -0.2, 0.0, 0.22, 0.5, 0.75, 0.9}) {
    const Trial paddled = At("grouser", 0.0, slip), smooth = At("smooth", 0.0, slip);
    const double measured = paddled.ahead_n - smooth.ahead_n;
    const double gain = paddled.model().ahead_n - smooth.model().ahead_n;
    std::printf("slip %5.2f: grousers gain %5.2f N, measured %5.2f N\n", slip, gain, measured);
    EXPECT_NEAR(gain, measured, (slip > 0.8 ? 0.09 : 0.05) * paddled.load_n) << slip;
  }
}

TEST(SingleWheel, LockedWheelDragsAsMeasured) {
  for (const Trial& trial : Trials()) {
    if (trial.slip > -0.99 || trial.beta_deg > 45.0) continue;
    EXPECT_NEAR(trial.model().ahead_n / trial.ahead_n, 1.0, 0.3) << trial.wheel << trial.beta_deg;
    EXPECT_NEAR(trial.model().sinkage_m / (1e-3 * trial.sinkage_mm), 1.0, 0.3)
        << trial.wheel << trial.beta_deg;
  }
}

TEST(SingleWheel, SlipDigsItInAsMeasured) {
  // Slip-sinkage: the wheel with grousers sinks 2.7 times as deep at slip 0.9 as at none.
  const double measured = At("grouser", 0.0, 0.9).sinkage_mm / At("grouser", 0.0, 0.0).sinkage_mm;
  const double model =
      At("grouser", 0.0, 0.9).model().sinkage_m / At("grouser", 0.0, 0.0).model().sinkage_m;
  EXPECT_NEAR(model / measured, 1.0, 0.15);
}

TEST(SingleWheel, FollowsStrongSideSlipRoughly) {
  // Side slip beyond 45 deg took no part in the fit. At 60 deg the model's errors are three to five
  // times those up to 45; at 75 and 90 deg it is wrong by half and more (docs/results/soil.md).
  double ahead = 0.0, side = 0.0, sinkage = 0.0;
  int trials = 0;
  for (const Trial& trial : ReadTrials()) {
    if (trial.beta_deg != 60.0 || std::fabs(trial.slip) > 0.76) continue;
    ahead += std::pow(trial.AheadError(), 2);
    side += std::pow(trial.SideError(), 2);
    sinkage += std::pow(trial.SinkageError_mm(), 2);
    ++trials;
  }
  ASSERT_EQ(trials, 10);
  std::printf("60 deg: rms Fx %.3f, Fy %.3f of the load, sinkage %.1f mm\n",
              std::sqrt(ahead / trials), std::sqrt(side / trials), std::sqrt(sinkage / trials));
  EXPECT_LT(std::sqrt(ahead / trials), 0.12);
  EXPECT_LT(std::sqrt(side / trials), 0.25);
  EXPECT_LT(std::sqrt(sinkage / trials), 8.0);
}

TEST(SingleWheel, SpeedHardlyMatters) {
  const Trial& trial = At("grouser", 15.0, 0.0);
  Trial faster = trial;
  faster.speed_mm_s = 50.0;
  const SingleWheelResult fast = Simulate(faster);
  EXPECT_NEAR(fast.ahead_n, trial.model().ahead_n, 0.03 * trial.load_n);
  EXPECT_NEAR(fast.sinkage_m, trial.model().sinkage_m, 0.5e-3);
}

}  // namespace
}  // namespace dockyard::soil_test
