#include "toy/toy_system.h"

#include <cmath>
#include <cstdio>

#include "models/read/yaml_reader.h"
#include "models/read/yaml_tree.h"
#include "sim/base/hash.h"
#include "sim/base/random.h"

namespace dockyard::toy {
namespace {

constexpr Tick kPeriod = 20;
constexpr double kRadPerCount = 1e-3, kWheel_m = 0.1;

/// Drives the distance that it was told by counting its wheel's turns, then claims to be there.
class Counting final : public Controller {
 public:
  explicit Counting(const Json& nominal)
      : way_m_(nominal.at("distance_m")), speed_m_s_(nominal.at("speed_m_s")) {}
  Commands Step(const SensorFrame& sensed) override {
    const double gone_m =
        kWheel_m * kRadPerCount * static_cast<double>(sensed.motors[0].encoder_counts);
    belief_.phase = "drive";
    belief_.located = true;
    belief_.X_DR = {way_m_ - gone_m, 0.0, kPi};
    Commands commands;
    const bool there = gone_m >= way_m_;
    if (there) commands.verdict = Verdict::kDone;
    commands.motors.push_back({.mode = there ? MotorMode::kBrake : MotorMode::kVelocity,
                               .target = speed_m_s_ / kWheel_m});
    return commands;
  }
  const Belief& belief() const override { return belief_; }

 private:
  double way_m_, speed_m_s_;
  Belief belief_;
};

class Line final : public Plant {
 public:
  explicit Line(const Scenario& scenario) {
    RandomStream random(StreamKey(scenario.seed, "start"));
    x_m_ = scenario.start.on_plane().r + random.Uniform(-0.1, 0.1);  // where it was really put
  }
  Tick tick() const override { return tick_; }
  SensorFrame Sense() override {
    SensorFrame frame;
    frame.tick = tick_;
    frame.motors = {{std::llround(wheel_rad_ / kRadPerCount), 0.0}};
    frame.values = {kWheel_m * wheel_rad_, x_m_};
    return frame;
  }
  std::vector<CameraImage> TakeImages(const std::vector<int>&, double) override { return {}; }
  void Advance(const Commands& commands) override {
    const MotorCommand& motor = commands.motors[0];
    const double rad = motor.mode == MotorMode::kVelocity ? motor.target * 1e-3 * kPeriod : 0.0;
    wheel_rad_ += rad;
    x_m_ -= kWheel_m * rad;
    tick_ += kPeriod;
  }
  RobotPose X_DR() const override { return {x_m_, 0.0, kPi}; }
  void AppendChannels(std::vector<double>& values) const override { values.push_back(wheel_rad_); }
  RobotPose MeasuredPose(const SightingReport&) const override { return {}; }
  std::uint64_t StateHash(std::uint64_t seed) const override {
    return HashDouble(HashDouble(seed, x_m_), wheel_rad_);
  }

 private:
  Tick tick_ = 0;
  double x_m_ = 0.0, wheel_rad_ = 0.0;
};

std::vector<JudgedLimit> Limits(double miss_m) {
  return {{"miss_m", "m", "distance from the flag at the end", LimitSense::kAtMost, miss_m, 0.05}};
}

class AtTheFlag final : public Judge {
 public:
  explicit AtTheFlag(const Plant& plant) : plant_(plant) {}
  void Observe() override {}
  void ObserveSighting(const SightingReport&) override {}
  bool fatal() const override { return false; }
  Conclusion Conclude(const Commands& last, const Belief&, const TrialWatch&) override {
    const double miss_m = std::abs(plant_.X_DR().x);
    const bool claimed = last.verdict == Verdict::kDone;
    const char* outcome = !claimed ? "timeout" : miss_m < 0.05 ? "at_flag" : "missed";
    return {
        outcome, "stopped " + NumberText(miss_m) + " m from the flag", {miss_m}, Limits(miss_m)};
  }

 private:
  const Plant& plant_;
};

double SpeedOf(const Scenario& scenario) {
  if (scenario.of_system.kind == YamlNode::Kind::kNull) return 0.5;
  return YamlReader(scenario.of_system, "toy", {"speed_m_s"}).Number("speed_m_s", Positive(5.0));
}

ReadyRun MakeReady(const Scenario& scenario) {
  ReadyRun ready;
  ready.plant = std::make_unique<Line>(scenario);
  ready.judge = std::make_unique<AtTheFlag>(*ready.plant);
  ready.nominal = {{"distance_m", scenario.start.on_plane().r}, {"speed_m_s", SpeedOf(scenario)}};
  ready.control_period = kPeriod;
  ready.motor_count = 1;
  ready.sensors = {{"gone_m", "m", "path of the wheel"},
                   {"range_m", "m", "to the flag, by sound", /*period=*/100, /*latency=*/60}};
  return ready;
}

int SayWay(const std::string&, const std::vector<std::string>& words) {
  std::printf("the flag is %s m away\n", words.empty() ? "0" : words[0].c_str());
  return 0;
}

std::optional<FileCheck> CheckPoint(const std::string& file) {
  if (LoadYaml(file).Find("point") == nullptr) return std::nullopt;
  return FileCheck{"point", "a robot that sees a lamp"};
}

int Detect(const std::string&, const std::vector<std::string>& words) {
  std::printf("a lamp seen by a point, asked with %zu words\n", words.size());
  return 0;
}

}  // namespace

System ToySystem() {
  System system;
  system.name = "toy";
  system.controllers = {{"counting", [](const Json& n) { return std::make_unique<Counting>(n); }}};
  system.columns.outcomes = {{"at_flag", true, "within 5 cm of the flag"},
                             {"missed", false, "claimed to be there, farther off"},
                             {"timeout", false, "never claimed to be there"}};
  system.columns.channels = {{"wheel_rad", "rad", "the wheel's turn since the start"}};
  system.columns.measures =
      WithMargins({{"miss_m", "m", "distance from the flag at the end", true}}, Limits(0.0));
  system.check = [](const Scenario& s) { return "a point at " + NumberText(SpeedOf(s)) + " m/s"; };
  system.make_ready = MakeReady;
  system.files.check = CheckPoint;
  system.detect = {"detect", "Says what it was asked.", Detect};
  system.example_files.scenario = "tests/toy/scenario.yaml";
  system.example_files.reproduction = "toy";
  system.reproductions = {
      {"toy", "tests/toy/published.yaml", "Drives to the flag."},
      {"toy_never", "tests/toy/published_never.yaml",
       "The same, said never to have come to the flag."},
      {"toy_drawn", "tests/toy/published_drawn.yaml", "Drives from places that are drawn."}};
  system.commands = {{"way", "Say how far the flag is.", SayWay}};
  return system;
}

}  // namespace dockyard::toy
