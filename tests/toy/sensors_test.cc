// The toy states two sensors in its own file. Nothing generic names them, and they are everywhere.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sstream>

#include "app/program.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/log/logged_run.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct Sensed {
  double gone_m = 0.0, range_m = 0.0;
};

/// A run of the program that prints its readings.
class ToySensors : public testing::Test {
 protected:
  void SetUp() override {
    const Ended ended = Dockyard(
        "run tests/toy/scenario.yaml --set start.r_m=1 --allow-commands --set "
        "'controller={command: [python3, sensing.py], folder: " +
        SourceFile("tests/toy") + "}' --out " + dir());
    ASSERT_THAT(ended.code, testing::AnyOf(0, 4)) << ended.err;
    std::istringstream lines(ReadWhole(folder_.path() / "messages.txt").value_or(""));
    std::string line;
    std::getline(lines, line);
    hello_ = Json::parse(line);
    while (std::getline(lines, line)) {
      const Json json = Json::parse(line);
      frames_[json[0].get<Tick>()] = {json[1], json[2]};
    }
    ASSERT_GT(frames_.size(), 20u);
  }
  std::string dir() const { return folder_.path().string(); }

  TemporaryFolder folder_;
  Json hello_;
  std::map<Tick, Sensed> frames_;
};

TEST_F(ToySensors, AreInTheHello) {
  ASSERT_EQ(hello_.size(), 2u);
  EXPECT_EQ(hello_[0]["name"], "gone_m");
  EXPECT_EQ(hello_[0]["period_ms"], 20);
  EXPECT_EQ(hello_[1].dump(),
            R"({"name":"range_m","unit":"m","meaning":"to the flag, by sound","period_ms":100,)"
            R"("latency_ms":60,"noise":0.0})");
}

// Path and range of one time sum up to the range at the start.
TEST_F(ToySensors, ComeAtTheirPeriodAfterTheirLatency) {
  const double start_m = frames_.at(0).range_m;
  EXPECT_NEAR(start_m, 1.0, 0.1);
  for (const auto& [tick, sensed] : frames_) {
    const Tick sampled = tick < 160 ? 0 : (tick - 60) / 100 * 100;
    EXPECT_NEAR(sensed.range_m + frames_.at(sampled).gone_m, start_m, 1e-12) << tick;
    EXPECT_NEAR(sensed.gone_m, 0.1 * 20.0 * 1e-3 * static_cast<double>(tick), 1e-12) << tick;
  }
}

TEST_F(ToySensors, AreInHistoryAndLog) {
  EXPECT_THAT(ReadWhole(folder_.path() / "history.csv").value_or(""),
              HasSubstr("wheel_rad,sensor.gone_m,sensor.range_m,phase"));
  const LoggedRun run = ReadLoggedRun(folder_.path());
  ASSERT_EQ(run.header.sensors.size(), 2u);
  EXPECT_EQ(run.header.sensors[1].unit, "m");
  EXPECT_EQ(run.header.sensors[1].latency, 60);
  const std::vector<double>& range_m = run.sensors.at("range_m");
  ASSERT_EQ(range_m.size(), run.times_s.size());
  for (std::size_t i = 0; i < range_m.size(); ++i) {
    // The run's last sample is behind its last frame.
    const auto at = frames_.find(std::llround(1e3 * run.times_s[i]));
    const Sensed& last = at == frames_.end() ? frames_.rbegin()->second : at->second;
    EXPECT_EQ(range_m[i], last.range_m) << run.times_s[i];
  }
  RunLogReader log{Folder(folder_.path())};
  for (const auto& [tick, sensed] : frames_) {
    const auto entry = log.Next();
    ASSERT_TRUE(entry);
    EXPECT_THAT(entry->sensed.values, ElementsAre(sensed.gone_m, sensed.range_m)) << tick;
  }
}

TEST_F(ToySensors, AreReplayed) {
  const Ended replay = Dockyard("replay " + dir() + " --allow-commands");
  EXPECT_EQ(replay.code, 0) << replay.err;
  EXPECT_THAT(replay.out, HasSubstr("same commands at all"));
}

}  // namespace
}  // namespace dockyard
