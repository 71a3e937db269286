// A smoke test: each fault of scenarios/axel_faults.yaml takes effect in closed loop, and leaves a
// docking in one of two seeds. Single outcomes flip with any change of a solver, so this says
// nothing about a rate; the campaign has the rates.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "axel/sim/scenarios.h"

namespace dockyard::axel {
namespace {

using Overrides = std::vector<std::string>;

/// One run, and its scenario without the fault.
struct Driven {
  Scenario scenario, plain;
  RunRecord record;
};

/// `effect`: a number of a run that its fault raises to at least `from`, and that is less without.
struct Fault {
  std::string name;
  Overrides keys;
  std::function<double(const Driven&)> effect;
  double from = 0.0;
};
void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

Driven Simulated(const Overrides& keys, const std::string& seed) {
  const Overrides all{seed, "start={r_m: 2.5, alpha_deg: 8, heading_deg: 0}", "camera.width_px=640",
                      "camera.height_px=480", "time_limit_s=300"};
  Overrides with = keys;
  with.insert(with.end(), all.begin(), all.end());
  return {TypicalScenario(with), TypicalScenario(all), SimulateTypical(with)};
}

double Channel(const Driven& run, const HistorySample& sample, const std::string& name) {
  for (std::size_t i = 0; i < run.record.channels.size(); ++i) {
    if (run.record.channels[i].name == name) return sample.channels[i];
  }
  throw std::out_of_range(name);
}

/// Share of the accepted sightings that the right camera took alone.
double ByTheRightCamera(const Driven& run) {
  double accepted = 0.0, right = 0.0;
  for (const SightingSample& sighting : run.record.sightings) {
    if (!sighting.report.accepted) continue;
    ++accepted;
    right += sighting.report.method == "right" ? 1.0 : 0.0;
  }
  return right / accepted;
}

/// The leftmost mark that the left camera measured, in pixels from the image's middle: those under
/// the cover are dark.
double LeftmostMark(const Driven& run) {
  double least_px = 1e3;
  for (const SightingSample& sighting : run.record.sightings) {
    for (const SightingReport::Mark& mark : sighting.report.marks) {
      if (mark.camera == kLeftCamera) least_px = std::min(least_px, mark.u_px - 319.5);
    }
  }
  return least_px;
}

GrayImage LeftImageAtTheStart(const Scenario& scenario) {
  const ReadyRun ready = Systems().front().make_ready(scenario);
  return std::get<GrayImage>(ready.plant->TakeImages({kLeftCamera}, 0.0).at(0).pixels);
}

/// Pixels of the first left image that are brighter by 20 levels than without the fault.
double BrighterPixels(const Driven& run) {
  const GrayImage image = LeftImageAtTheStart(run.scenario), plain = LeftImageAtTheStart(run.plain);
  double count = 0.0;
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    count += image.pixels[i] > plain.pixels[i] + 20 ? 1.0 : 0.0;
  }
  return count;
}

/// Amperes of the spool beyond its idling for each kilonewton at the tether, in the median of the
/// samples in which it pulls hard.
double SpoolsCurrent(const Driven& run) {
  std::vector<double> a_per_kn;
  for (const HistorySample& sample : run.record.history) {
    const double current_a = Channel(run, sample, "spool_current_a") - 0.2;
    if (current_a > 0.6) a_per_kn.push_back(1e3 * current_a / Channel(run, sample, "tension_n"));
  }
  std::sort(a_per_kn.begin(), a_per_kn.end());
  return a_per_kn.empty() ? 0.0 : a_per_kn[a_per_kn.size() / 2];
}

double RollAtTheStart(const Driven& run) {
  return std::abs(Channel(run, run.record.history.front(), "roll_deg"));
}

/// Mean rate of yaw that the unit reads before the rover moves [deg/h].
double YawRateAtRest(const Driven& run) {
  const ReadyRun ready = Systems().front().make_ready(run.scenario);
  double sum_rad_s = 0.0;
  Commands still;
  still.motors.resize(kMotorCount);
  constexpr int kReadings = 500;  // 10 s: the random walk leaves 3 deg/h
  for (int i = 0; i < kReadings; ++i) {
    sum_rad_s += ready.plant->Sense().imu.rate_R.z();
    ready.plant->Advance(still);
  }
  return std::abs(Degrees(sum_rad_s / kReadings)) * 3600.0;
}

/// How far belief and truth are apart at most in the first 3 s after the station was moved.
double BeliefOffTheDock(const Driven& run) {
  double most_m = 0.0;
  for (const HistorySample& sample : run.record.history) {
    if (sample.time_s < 23.5 || sample.time_s > 27.0 || !sample.located) continue;
    const Pose2 is = sample.X_DR, believed = sample.X_DR_believed;
    most_m = std::max(most_m, std::hypot(is.x - believed.x, is.y - believed.y));
  }
  return most_m;
}

double FirstSighting(const Driven& run) { return run.record.sightings.at(0).time_s; }

class FaultsSmoke : public testing::TestWithParam<Fault> {};

TEST_P(FaultsSmoke, TakesEffectAndLeavesADockingInOneOfTwoSeeds) {
  const Fault& fault = GetParam();
  std::string outcomes;
  for (const char* seed : {"seed=1", "seed=2"}) {
    const Driven with = Simulated(fault.keys, seed), without = Simulated({}, seed);
    EXPECT_NE(with.record.result.state_hash, without.record.result.state_hash) << seed;
    std::printf("%s, %s: %.3f with the fault, %.3f without, %s\n", fault.name.c_str(), seed,
                fault.effect(with), fault.effect(without), with.record.result.outcome.c_str());
    EXPECT_GE(fault.effect(with), fault.from) << seed;
    EXPECT_LT(fault.effect(without), fault.from) << seed;
    EXPECT_NE(with.record.result.outcome, "false_docked");
    if (with.record.result.outcome == "docked") return;
    outcomes += with.record.result.outcome + " ";
  }
  ADD_FAILURE() << fault.name << ": " << outcomes;
}

INSTANTIATE_TEST_SUITE_P(
    Each, FaultsSmoke,
    testing::Values(
        Fault{"camera_dead", {"camera.left.picture=none"}, ByTheRightCamera, 1.0},
        Fault{"lens_half_covered",
              {"camera.left.cover=0.5", "camera.left.cover_side_deg=180"},
              LeftmostMark,
              -20.0},
        Fault{"marks_dirty", {"axel.dirty_marks={count: 3, dust: 0.8}"}, BrighterPixels, 50.0},
        Fault{"spool_weak",
              {"as_built.robot.motors.spool.torque_per_amp_nm.times=0.6"},
              SpoolsCurrent,
              7.0},
        Fault{"wheel_on_rock", {"axel.start.rock_m=0.08"}, RollAtTheStart, 3.0},
        Fault{
            "yaw_drift", {"as_built.robot.imu.gyro_bias_deg_per_h.times=10"}, YawRateAtRest, 60.0},
        Fault{"station_moved",
              {"axel.station_moved={at_s: 20, forward_m: 0.06, left_m: 0.08, turn_deg: 3}"},
              BeliefOffTheDock,
              0.1},
        Fault{"images_late", {"camera.delay_s=1"}, FirstSighting, 3.3}),
    [](const testing::TestParamInfo<Fault>& info) { return info.param.name; });

}  // namespace
}  // namespace dockyard::axel
