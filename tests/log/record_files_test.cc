#include "sim/log/record_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/log/result_row.h"
#include "sim/log/value_table.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::StartsWith;

TEST(History, HasTheSystemsChannelsAndBeliefsByName) {
  RunRecord record = FakeRecord(FakeRuns(1)[0]);
  HistorySample& sample = record.history[0];
  sample = {};
  sample.time_s = 0.1;
  sample.X_DR = {4.0, -0.5, Radians(90.0)};
  sample.channels = {40.5, -1.5};
  sample.phase = "look, again";
  sample.located = true;
  sample.X_DR_believed =
      RobotPose::FromAngles({3.5, 0.25, -0.5}, {.roll = 0.0, .pitch = 0.0, .yaw = 0.0});
  sample.sighting_count = 3;
  sample.plan_count = 2;
  sample.beliefs = {1.0};
  record.history.resize(1);
  EXPECT_EQ(HistoryCsv(record),
            "time_s,x_m,y_m,heading_deg,z_m,roll_DR_deg,pitch_DR_deg,tension_n,roll_deg,phase,"
            "located,believed_x_m,believed_y_m,believed_heading_deg,believed_z_m,"
            "believed_roll_deg,believed_pitch_deg,sightings,plans,recoveries,"
            "error_x_m,error_y_m,error_yaw_deg,error_z_m\n"
            "0.1,4,-0.5,90,0,0,0,40.5,-1.5,\"look, again\",1,3.5,0.25,0,-0.5,0,0,3,2,1,"
            "-0.5,0.75,-90,-0.5\n");
}

TEST(History, OfASystemWithoutChannelsIsThePathAndTheBelief) {
  RunRecord record;
  record.history.resize(1);
  EXPECT_EQ(HistoryCsv(record),
            "time_s,x_m,y_m,heading_deg,z_m,roll_DR_deg,pitch_DR_deg,phase,located,believed_x_m,"
            "believed_y_m,believed_heading_deg,believed_z_m,believed_roll_deg,believed_pitch_deg,"
            "sightings,plans,error_x_m,error_y_m,error_yaw_deg,error_z_m\n"
            "0,0,0,0,0,0,0,,0,0,0,0,0,0,0,0,0,nan,nan,nan,nan\n");
}

TEST(History, HasPoseInSpaceAndSensorsByName) {
  RunRecord record;
  record.sensors = {{"depth_m", "m", "below the surface"}};
  record.history.resize(1);
  const RollPitchYaw angles{.roll = Radians(-90.0), .pitch = Radians(30.0), .yaw = 0.0};
  record.history[0].X_DR = RobotPose::FromAngles({1.0, 2.0, -3.5}, angles);
  record.history[0].sensed = {12.5};
  const std::string csv = HistoryCsv(record);
  EXPECT_THAT(csv, StartsWith("time_s,x_m,y_m,heading_deg,z_m,roll_DR_deg,pitch_DR_deg,"
                              "sensor.depth_m,phase"));
  double x = 0.0, y = 0.0, heading = 0.0, z = 0.0, roll = 0.0, pitch = 0.0, depth = 0.0;
  const std::string row = csv.substr(csv.find('\n') + 1);
  ASSERT_EQ(std::sscanf(row.c_str(), "0,%lf,%lf,%lf,%lf,%lf,%lf,%lf", &x, &y, &heading, &z, &roll,
                        &pitch, &depth),
            7);
  EXPECT_THAT((std::vector{x, y, heading, z, depth}), ElementsAre(1.0, 2.0, 0.0, -3.5, 12.5));
  EXPECT_NEAR(roll, -90.0, 1e-12);
  EXPECT_NEAR(pitch, 30.0, 1e-12);
}

TEST(HistoryDeathTest, RefusesASampleThatLacksAChannel) {
  RunRecord record = FakeRecord(FakeRuns(1)[0]);
  record.history[7].channels.pop_back();
  EXPECT_DEATH(HistoryCsv(record), "check failed");
}

/// Two samples; the second has a name more.
RunRecord RecordWithValues(std::vector<std::string> names) {
  RunRecord record;
  record.value_names = std::move(names);
  record.history.resize(2);
  record.history[0].values = {0.5};
  record.history[1].time_s = 0.1;
  record.history[1].values = {std::nan(""), -2.0};
  return record;
}

TEST(ValuesTable, HasEachValueAtItsTimeAndNanWhereThereIsNone) {
  EXPECT_EQ(ValuesCsv(RecordWithValues({"reeled_m", "late, and quoted"})),
            "time_s,reeled_m,\"late, and quoted\"\n0,0.5,nan\n0.1,nan,-2\n");
}

TEST(ValuesTable, HasNoNameThatIsAFormulaOrThere) {
  const auto header = [](const std::vector<std::string>& names) {
    const std::string csv = ValuesCsv(RecordWithValues(names));
    return csv.substr(0, csv.find('\n'));
  };
  EXPECT_EQ(header({"=1+1", "@cmd", "+a", "-b", "a=b"}), "time_s,'=1+1,'@cmd,'+a,'-b,a=b");
  EXPECT_EQ(header({"time_s", "value.time_s"}), "time_s,value.value.time_s,value.time_s");
}

TEST(ValuesTable, HasTheValuesThatNoColumnOfTheSystemHas) {
  std::vector<std::string> names;
  Belief belief;
  belief.values = {{"recoveries", 2.0}, {"b", 1.0}};
  const std::vector<Column> columns{{"recoveries", "", "so far"}};
  EXPECT_THAT(FurtherValues(belief, columns, names), ElementsAre(1.0));
  belief.values = {{"a", 3.0}};
  EXPECT_THAT(FurtherValues(belief, columns, names), ElementsAre(testing::IsNan(), 3.0));
  EXPECT_THAT(names, ElementsAre("b", "a"));
}

TEST(RecordFiles, HaveATableOfValuesOnlyWhereThereAreSome) {
  const TemporaryFolder folder;
  WriteRecordFiles(folder.path(), RecordWithValues({"a", "b"}));
  EXPECT_THAT(Slurp(folder.path() / "values.csv"), StartsWith("time_s,a,b\n"));
  WriteRecordFiles(folder.path(), RunRecord{});
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "values.csv"));
}

TEST(RecordFiles, HaveMarksAndCountsByCamera) {
  const TemporaryFolder folder;
  WriteRecordFiles(folder.path(), FakeRecord(FakeRuns(1)[0]));
  const Json sightings = Json::parse(Slurp(folder.path() / "sightings.json"));
  ASSERT_EQ(sightings.size(), 1u);
  EXPECT_THAT(sightings[0]["detected"].get<std::vector<int>>(), ElementsAre(3, 4));
  EXPECT_EQ(sightings[0]["marks"][0]["camera"], 1);
  EXPECT_EQ(sightings[0]["marks"][0]["id"], 7);
  EXPECT_EQ(Json::parse(Slurp(folder.path() / "plans.json"))[0]["arcs"].size(), 2u);
  EXPECT_THAT(Slurp(folder.path() / "history.csv"), StartsWith("time_s,"));
}

TEST(RecordFiles, HoldNoFormulaInAPhaseThatAControllerNames) {
  RunRecord record = FakeRecord(FakeRuns(3)[2]);
  ASSERT_FALSE(record.history.empty());
  record.history[0].phase = "=HYPERLINK(1)";
  EXPECT_NE(HistoryCsv(record).find(",'=HYPERLINK(1),"), std::string::npos);
}

TEST(RecordFiles, TellTheOutcomeWithTheRowAndTheNote) {
  const TemporaryFolder folder;
  const RunRecord record = FakeRecord(FakeRuns(3)[2]);
  WriteRecordFiles(folder.path(), record);
  Json outcome = Json::parse(Slurp(folder.path() / "outcome.json"));
  EXPECT_EQ(outcome["failure_note"], "it passed the flag on the left");
  outcome.erase("failure_note");
  EXPECT_TRUE(outcome["limits"].is_array());
  outcome.erase("limits");
  EXPECT_EQ(outcome.dump(), RowJson(record.result, FakeColumns()).dump());
}

TEST(SingleResult, ReadsBackAndIsNoneForOtherColumns) {
  const TemporaryFolder folder;
  const RowColumns columns = FakeColumns();
  const RunResult row = FakeRecord(FakeRuns(1)[0]).result;
  EXPECT_FALSE(ReadSingleResult(folder.path(), columns).has_value());
  WriteSingleResult(folder.path(), row, columns);
  const auto back = ReadSingleResult(folder.path(), columns);
  ASSERT_TRUE(back.has_value());
  EXPECT_EQ(CsvRow(*back, columns), CsvRow(row, columns));
  RowColumns others = columns;
  others.measures.pop_back();
  EXPECT_FALSE(ReadSingleResult(folder.path(), others).has_value());
}

}  // namespace
}  // namespace dockyard
