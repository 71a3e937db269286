// A robot for these tests alone: a test says what its controller answers and what ends its run, and
// reads afterwards what was called, and when.
#pragma once

#include <gmock/gmock.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/run/loop.h"
#include "support/bad_files.h"

namespace dockyard {

/// What a test says of a run.
struct Script {
  /// Fills in the commands, which are to brake one motor, and changes the belief.
  std::function<void(const SensorFrame&, Commands&, Belief&)> step = [](const SensorFrame&,
                                                                        Commands&, Belief&) {};
  std::function<bool(Tick)> fatal = [](Tick) { return false; };
  /// The image of a camera, one row of grey values; empty: the camera gives none.
  std::function<std::vector<std::uint8_t>(int camera)> pixels = [](int camera) {
    return std::vector<std::uint8_t>{static_cast<std::uint8_t>(camera), 200};
  };
  int trial_periods = 0;  // that the judge goes on at the end
  std::vector<JudgedLimit> limits{};
  Tick period = 20;
  int cameras = 0;
  std::string success_word{};
};

struct Exposure {
  Tick tick = 0;
  std::vector<int> cameras;
  double stops = 0.0;

  bool operator==(const Exposure&) const = default;
};

/// What happened in a run.
struct Diary {
  std::vector<std::string> calls{};      // "sense 20", in their order
  std::vector<SensorFrame> frames{};     // that the controller got
  std::vector<Commands> commands{};      // that the plant got
  std::vector<Exposure> exposures{};     // that the plant was asked for
  std::optional<Commands> concluding{};  // that the judge got at the end

  int Count(const std::string& call) const;
  /// The ticks of the calls of that name.
  std::vector<Tick> TicksOf(const std::string& call) const;
};

/// A motor in velocity mode moves the robot along x at its target [m/s]. Outcomes are done (a
/// success), given_up and timeout; the measure is x_m. Both must outlive the system and its runs.
System ScriptedSystem(const Script& script, Diary& diary);

class ScriptedRun : public testing::Test {
 protected:
  ScriptedRun();
  CampaignRun Planned() const { return {7, {}, scenario_}; }
  /// With a new diary.
  RunRecord Run(const RunOptions& options = {});
  RunOptions Logged() const;
  /// The controller asks for these images at a tick.
  void Ask(Tick tick, const std::vector<int>& cameras, double exposure_stops = 0.0);
  /// The times of the history's samples.
  static std::vector<Tick> SampleTicks(const RunRecord& record);
  static MotorCommand Speed(double speed_m_s);

  Script script_;
  Diary diary_;
  Scenario scenario_;
  ScratchFolder folder_;
};

}  // namespace dockyard
