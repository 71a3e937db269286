#include "run/scripted_run.h"

#include <algorithm>
#include <cmath>

#include "sim/base/hash.h"

namespace dockyard {
namespace {

constexpr double kCount_m = 1e-3;

class ScriptedPlant final : public Plant {
 public:
  ScriptedPlant(const Script& script, Diary& diary) : script_(script), diary_(diary) {}

  void Enter(const std::string& call) {
    diary_.calls.push_back(call + " " + std::to_string(tick_));
  }

  Tick tick() const override { return tick_; }
  SensorFrame Sense() override {
    Enter("sense");
    SensorFrame frame;
    frame.tick = tick_;
    frame.motors = {{std::llround(x_m_ / kCount_m), 0.0}};
    return frame;
  }
  std::vector<CameraImage> TakeImages(const std::vector<int>& cameras,
                                      double exposure_stops) override {
    diary_.exposures.push_back({tick_, cameras, exposure_stops});
    std::vector<CameraImage> images;
    for (const int camera : cameras) {
      std::vector<std::uint8_t> row = script_.pixels(camera);
      const auto width = static_cast<int>(row.size());
      if (width > 0) images.push_back({camera, GrayImage{width, 1, std::move(row)}});
    }
    return images;
  }
  void Advance(const Commands& commands) override {
    Enter("advance");
    diary_.commands.push_back(commands);
    const MotorCommand& motor = commands.motors.at(0);
    const double seconds = static_cast<double>(script_.period) * kTickSeconds;
    if (motor.mode == MotorMode::kVelocity) x_m_ += seconds * motor.target;
    tick_ += script_.period;
  }
  RobotPose X_DR() const override { return {x_m_, 0.0, 0.0}; }
  void AppendChannels(std::vector<double>& values) const override { values.push_back(2.0 * x_m_); }
  RobotPose MeasuredPose(const SightingReport& report) const override {
    return {report.X_RB.p.x(), 0.0, 0.0};
  }
  std::uint64_t StateHash(std::uint64_t seed) const override { return HashDouble(seed, x_m_); }

 private:
  const Script& script_;
  Diary& diary_;
  Tick tick_ = 0;
  double x_m_ = 0.0;
};

class ScriptedJudge final : public Judge {
 public:
  ScriptedJudge(ScriptedPlant& plant, const Script& script, Diary& diary)
      : plant_(plant), script_(script), diary_(diary) {}
  void Observe() override { plant_.Enter("observe"); }
  void ObserveSighting(const SightingReport&) override { plant_.Enter("sighting"); }
  void ObserveLostImages() override { plant_.Enter("lost"); }
  bool fatal() const override { return script_.fatal(plant_.tick()); }
  Conclusion Conclude(const Commands& last, const Belief&, const TrialWatch& watch) override {
    plant_.Enter("conclude");
    diary_.concluding = last;
    for (int i = 0; i < script_.trial_periods; ++i) {
      plant_.Advance(last);
      watch("trial");
    }
    const char* outcome = last.verdict == Verdict::kDone      ? "done"
                          : last.verdict == Verdict::kGivenUp ? "given_up"
                                                              : "timeout";
    return {outcome, "the judge's note", {plant_.X_DR().x}, script_.limits};
  }

 private:
  ScriptedPlant& plant_;
  const Script& script_;
  Diary& diary_;
};

class Scripted final : public Controller {
 public:
  Scripted(const Script& script, Diary& diary) : script_(script), diary_(diary) {}
  Commands Step(const SensorFrame& sensed) override {
    diary_.calls.push_back("step " + std::to_string(sensed.tick));
    diary_.frames.push_back(sensed);
    Commands commands;
    commands.motors.resize(1);
    script_.step(sensed, commands, belief_);
    return commands;
  }
  const Belief& belief() const override { return belief_; }

 private:
  const Script& script_;
  Diary& diary_;
  Belief belief_;
};

}  // namespace

std::vector<Tick> Diary::TicksOf(const std::string& call) const {
  std::vector<Tick> ticks;
  for (const std::string& each : calls) {
    if (each.starts_with(call + " ")) ticks.push_back(std::stoll(each.substr(call.size() + 1)));
  }
  return ticks;
}

int Diary::Count(const std::string& call) const { return static_cast<int>(TicksOf(call).size()); }

System ScriptedSystem(const Script& script, Diary& diary) {
  System system;
  system.name = "scripted";
  system.controllers = {{"scripted", [&script, &diary](const Json&) {
                           return std::make_unique<Scripted>(script, diary);
                         }}};
  system.columns.outcomes = {{"given_up", false, "the controller gave up"},
                             {"done", true, "the controller claimed to be done"},
                             {"timeout", false, "neither"}};
  system.columns.channels = {{"twice_x_m", "m", "twice the path"}};
  system.columns.beliefs = {{"stated_m", "m", "a value that the system names"}};
  system.columns.measures = WithMargins({{"x_m", "m", "path at the end"}}, script.limits);
  system.make_ready = [&script, &diary](const Scenario&) {
    ReadyRun ready;
    auto plant = std::make_unique<ScriptedPlant>(script, diary);
    ready.judge = std::make_unique<ScriptedJudge>(*plant, script, diary);
    ready.plant = std::move(plant);
    ready.nominal = Json::object();
    ready.control_period = script.period;
    ready.success_word = script.success_word;
    ready.motor_count = 1;
    ready.camera_count = script.cameras;
    return ready;
  };
  return system;
}

ScriptedRun::ScriptedRun() {
  scenario_.name = "scripted";
  scenario_.system = "scripted";
  scenario_.controller = "scripted";
  scenario_.time_limit_s = 0.2;
}

RunRecord ScriptedRun::Run(const RunOptions& options) {
  diary_ = {};
  return Simulate(ScriptedSystem(script_, diary_), Planned(), options);
}

RunOptions ScriptedRun::Logged() const {
  RunOptions options;
  options.log_dir = folder_.path();
  return options;
}

void ScriptedRun::Ask(Tick tick, const std::vector<int>& cameras, double exposure_stops) {
  script_.step = [=](const SensorFrame& sensed, Commands& commands, Belief&) {
    if (sensed.tick != tick) return;
    commands.take_images = cameras;
    commands.exposure_stops = exposure_stops;
  };
}

std::vector<Tick> ScriptedRun::SampleTicks(const RunRecord& record) {
  std::vector<Tick> ticks;
  for (const HistorySample& each : record.history) {
    ticks.push_back(std::llround(each.time_s / kTickSeconds));
  }
  return ticks;
}

MotorCommand ScriptedRun::Speed(double speed_m_s) {
  return {.mode = MotorMode::kVelocity, .target = speed_m_s};
}

}  // namespace dockyard
