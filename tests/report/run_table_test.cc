// A run's result for people.
#include <gmock/gmock.h>

#include <cmath>

#include "sim/report/run_table.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

RunRecord SomeRecord() {
  RunRecord record;
  record.columns.measures = {{"current_peak_a", "A", "of the motor", false},
                             {"tip_depth_m", "m", "behind the mouth", true},
                             {"yaw_deg", "deg", "of the body", false},
                             {"flips", "", "of the arm", false},
                             {"force_peak_n", "N", "on the arm", false},
                             {"rate_per_s", "1/s", "of the arm", false}};
  record.result.system = "toy";
  record.result.controller = "counting";
  record.result.outcome = "docked";
  record.result.sim_time_s = 99.52;
  record.result.images = 12;
  record.result.seed = 18446744073709551615u;
  record.result.measures = {
      1.9999999999999998, 0.2301781625982762, -0.8697770301835713, 0.0, std::nan(""), 3.0};
  record.result.state_hash = 0x00ab;
  record.timing.cpu_time_s = 3.14159;
  return record;
}

TEST(FourDigits, RoundsToFourAndDropsZeros) {
  const std::vector<std::pair<double, std::string>> cases{{0.2301781625982762, "0.2302"},
                                                          {1.9999999999999998, "2"},
                                                          {-0.86977, "-0.8698"},
                                                          {372.874, "372.9"},
                                                          {12345.6, "12346"},
                                                          {0.0, "0"},
                                                          {-0.0, "0"},
                                                          {0.00016924, "0.000169"},
                                                          {1e-9, "1.000e-09"},
                                                          {100.0, "100"},
                                                          {2.5e12, "2.500e+12"}};
  for (const auto& [value, text] : cases) EXPECT_EQ(FourDigits(value), text);
}

TEST(RunTable, HasUnitsAndRoundedNumbersInGroups) {
  const std::string table = RunTable("typical", SomeRecord());
  EXPECT_THAT(table, HasSubstr("typical (system toy, controller counting)\n"));
  EXPECT_THAT(table, testing::ContainsRegex(
                         "\n  simulated time +99.52 s +from the start to the last command\n"));
  EXPECT_THAT(table, testing::ContainsRegex("\n  tip depth +0.2302 m +behind the mouth\n"));
  EXPECT_THAT(table, testing::ContainsRegex("\nCurrents\n  current peak +2 A +of the motor\n"));
  EXPECT_THAT(table, testing::ContainsRegex("\nAngles\n  yaw +-0.8698 deg "));
  EXPECT_THAT(table, testing::ContainsRegex("\nIn 1/s\n  rate per s +3 1/s "));
  EXPECT_THAT(table, testing::ContainsRegex("\nCounts and shares\n  flips +0 "));
  EXPECT_LT(table.find("tip depth"), table.find("Angles"));
}

TEST(RunTable, KeepsEveryDigitOfSeedAndHash) {
  const std::string table = RunTable("typical", SomeRecord());
  EXPECT_THAT(table, HasSubstr("18446744073709551615"));
  EXPECT_THAT(table, testing::ContainsRegex("\n  hash +00000000000000ab "));
}

TEST(RunTable, NamesNumbersThatDoNotApplyInOneLine) {
  const std::string table = RunTable("typical", SomeRecord());
  EXPECT_THAT(table, testing::ContainsRegex("\n  does not apply +force peak\n"));
  EXPECT_THAT(table, Not(HasSubstr("nan")));
  EXPECT_THAT(table, Not(HasSubstr("Forces")));
}

TEST(RunSentence, SaysTheOutcomeItsTimeAndWhy) {
  RunRecord record = SomeRecord();
  EXPECT_EQ(RunSentence(record), "docked after 99.5 s");
  record.failure_note = "tip 230 mm deep";
  EXPECT_EQ(RunSentence(record), "docked after 99.5 s: tip 230 mm deep");
}

}  // namespace
}  // namespace dockyard
