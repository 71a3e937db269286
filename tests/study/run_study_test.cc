#include "sim/study/run_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include "models/read/config_error.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
namespace fs = std::filesystem;

RowColumns Columns() {
  RowColumns columns = FakeColumns();
  columns.labels.clear();
  return columns;
}

/// Three starts, two runs each.
Study SmallStudy() {
  Study study;
  study.name = "small";
  study.repeats = 2;
  study.measures = {"docked"};
  StudyFactor factor{"start.r_m", {"1", "2", "3"}, std::vector<YamlNode>(3)};
  study.factors = {factor};
  for (int level = 0; level < 3; ++level) {
    StudyPoint point;
    point.level = {level};
    point.scenario.start.r = 1.0 + level;
    study.points.push_back(point);
  }
  return study;
}

RunRecord Simulate(const CampaignRun& run) {
  RunRecord record = FakeRecord(run);
  record.result.measures[0] = run.scenario.start.r;
  return record;
}

StudyOptions OptionsFor(const fs::path& dir, int jobs) {
  StudyOptions options;
  options.out_dir = dir;
  options.jobs = jobs;
  return options;
}

TEST(RunStudy, GivesTheSameRowsForAnyNumberOfProcesses) {
  const TemporaryFolder folder;
  const Study study = SmallStudy();
  std::vector<std::string> tables;
  for (const int jobs : {1, 4}) {
    const StudyEnd end = RunStudy(study, Simulate, Columns(), OptionsFor(folder.path(), jobs));
    ASSERT_TRUE(end.complete());
    EXPECT_FALSE(end.any_crashed());
    tables.push_back(StudyRunsCsv(study, Columns(), end.rows));
  }
  EXPECT_EQ(tables[0], tables[1]);
}

TEST(RunStudy, MeasuresEachPointsOwnScenario) {
  const TemporaryFolder folder;
  const Study study = SmallStudy();
  const StudyEnd end = RunStudy(study, Simulate, Columns(), OptionsFor(folder.path(), 2));
  ASSERT_EQ(end.rows.size(), 6u);
  for (int i = 0; i < 6; ++i) {
    const StudyRow& row = end.rows[static_cast<std::size_t>(i)];
    EXPECT_EQ(row.run, i + 1);
    const int point = i / 2;
    EXPECT_EQ(row.point, point);
    EXPECT_EQ(row.seed, StudySeed(study, point, i % 2));
    EXPECT_EQ(row.measures[2], 1.0 + point);
    EXPECT_EQ(row.outcome, row.measures[0] == 1.0 ? "docked" : "missed");
  }
}

TEST(RunStudy, ARunThatDiesThrowsOrHangsHasCrashedWithoutMeasures) {
  const TemporaryFolder folder;
  StudyOptions options = OptionsFor(folder.path(), 2);
  options.run_time_limit_s = 1.0;
  int most = 0;
  options.progress = [&](int done, int) { most = done; };
  const auto bad = [](const CampaignRun& run) {
    if (run.run == 1) ::_exit(3);
    if (run.run == 2) throw std::runtime_error("no context");
    while (run.run == 3) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return Simulate(run);
  };
  const StudyEnd end = RunStudy(SmallStudy(), bad, Columns(), options);
  ASSERT_TRUE(end.complete());
  EXPECT_TRUE(end.any_crashed());
  for (const std::size_t i : {0u, 1u, 2u}) {
    EXPECT_EQ(end.rows[i].outcome, kCrashed);
    EXPECT_THAT(end.rows[i].measures, IsEmpty());
  }
  EXPECT_EQ(end.rows[3].measures.size(), 5u);
  EXPECT_THAT(Slurp(folder.path() / "run_2.txt"), HasSubstr("run 2: no context"));
  EXPECT_EQ(most, 6);
}

TEST(RunStudy, KeepsWhatIsDoneWhenASignalStopsIt) {
  const TemporaryFolder folder;
  StudyOptions options = OptionsFor(folder.path(), 1);
  options.progress = [](int done, int) {
    if (done == 2) ::raise(SIGINT);
  };
  const StudyEnd end = RunStudy(SmallStudy(), Simulate, Columns(), options);
  EXPECT_EQ(end.signal, SIGINT);
  EXPECT_EQ(end.rows.size(), 2u);
  EXPECT_FALSE(end.complete());
}

TEST(RunStudy, RunsNothingForAPlotOfWhatIsNotMeasured) {
  const TemporaryFolder folder;
  Study study = SmallStudy();
  study.measures = {"tension"};
  EXPECT_THROW(RunStudy(study, Simulate, Columns(), OptionsFor(folder.path(), 1)), ConfigError);
}

}  // namespace
}  // namespace dockyard
