#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "sim/campaign/statistics.h"
#include "sim/study/run_study.h"
#include "sim/study/scripted_controller.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

YamlNode Number(const std::string& text) {
  YamlNode node;
  node.kind = YamlNode::Kind::kScalar;
  node.scalar = text;
  return node;
}

/// Three values of a number; one key changed alone, to two values.
Study Sample() {
  Study study;
  study.name = "sample";
  study.repeats = 4;
  study.factors = {{"start.alpha_deg", {"0", "5", "10"}, {Number("0"), Number("5"), Number("10")}}};
  study.one_at_a_time = {{"changes.a", {"1", "2"}, {Number("1"), Number("2")}}};
  study.x = "start.alpha_deg";
  study.measures = {"docked", "tension_peak_n"};
  for (int change = 0; change < 3; ++change) {
    for (int level = 0; level < 3; ++level) {
      StudyPoint point;
      point.level = {level};
      point.changed = change == 0 ? -1 : 0;
      point.changed_level = change - 1;
      study.points.push_back(point);
    }
  }
  return study;
}

StudyRow Row(int run, int point, bool docked, double tension_n) {
  StudyRow row{run, point, 7, docked ? "docked" : "jammed", {}};
  row.measures.assign(StudyMeasures().size(), 0.0);
  row.measures[MeasureIndex("docked")] = docked ? 1.0 : 0.0;
  row.measures[MeasureIndex("tension_peak_n")] = tension_n;
  return row;
}

TEST(Study, AKeyChangedAloneMeetsTheSeedsOfTheGrid) {
  const Study study = Sample();
  std::set<std::uint64_t> seeds;
  for (int place = 0; place < 3; ++place) {
    for (int repeat = 0; repeat < 4; ++repeat) {
      const std::uint64_t seed = StudySeed(study, place, repeat);
      seeds.insert(seed);
      EXPECT_EQ(StudySeed(study, place + 3, repeat), seed);
      EXPECT_EQ(StudySeed(study, place + 6, repeat), seed);
    }
  }
  EXPECT_EQ(seeds.size(), 12u);
}

TEST(Study, ShareHasTheExactIntervalAndOthersTheirQuantiles) {
  std::vector<StudyRow> rows;
  for (int i = 0; i < 11; ++i) rows.push_back(Row(i + 1, 0, i < 8, 10.0 * i));
  std::vector<const StudyRow*> all;
  for (const StudyRow& row : rows) all.push_back(&row);
  const Spread share = SpreadOf("docked", all);
  EXPECT_DOUBLE_EQ(share.mean, 8.0 / 11.0);
  EXPECT_EQ(share.low, ClopperPearson(8, 11).low);
  EXPECT_EQ(share.high, ClopperPearson(8, 11).high);
  const Spread tension = SpreadOf("tension_peak_n", all);
  EXPECT_DOUBLE_EQ(tension.median, 50.0);
  EXPECT_DOUBLE_EQ(tension.low, 10.0);
  EXPECT_DOUBLE_EQ(tension.high, 90.0);
}

HistorySample At(double tip_depth_m, double current_a, double force_n) {
  HistorySample sample;
  sample.tip_depth_m = tip_depth_m;
  sample.spool_current_a = current_a;
  sample.cone_force_n = force_n;
  return sample;
}

TEST(Study, EntryIsFromTheMouthToTwentyCentimetresAndEndsThere) {
  RunRecord record;
  record.history = {At(-0.30, 9.0, 0.0), At(0.02, 0.5, 10.0), At(0.15, -0.7, 40.0),
                    At(0.21, 2.0, 300.0), At(0.19, 2.0, 300.0)};
  const auto measures = MeasuresOf(record);
  EXPECT_DOUBLE_EQ(measures[MeasureIndex("entry_current_mean_a")], 0.6);
  EXPECT_DOUBLE_EQ(measures[MeasureIndex("entry_current_peak_a")], 0.7);
  EXPECT_DOUBLE_EQ(measures[MeasureIndex("entry_force_peak_n")], 40.0);
}

TEST(Study, EntryOfAnArmThatStaysOutsideIsNaNAndInNoSpread) {
  RunRecord record;
  record.history = {At(-0.30, 0.5, 0.0), At(-0.01, 0.5, 90.0)};
  StudyRow outside = Row(1, 0, false, 0.0), inside = Row(2, 0, true, 0.0);
  outside.measures = MeasuresOf(record);
  EXPECT_TRUE(std::isnan(outside.measures[MeasureIndex("entry_current_mean_a")]));
  inside.measures[MeasureIndex("entry_current_mean_a")] = 0.4;
  const Spread spread = SpreadOf("entry_current_mean_a", {&outside, &inside});
  EXPECT_EQ(spread.count, 1);
  EXPECT_DOUBLE_EQ(spread.mean, 0.4);
}

TEST(Study, RunsWithoutMeasuresCountInNoSpread) {
  StudyRow crashed = Row(1, 0, false, 0.0);
  crashed.measures.clear();
  const StudyRow good = Row(2, 0, true, 100.0);
  const Spread spread = SpreadOf("tension_peak_n", {&crashed, &good});
  EXPECT_EQ(spread.count, 1);
  EXPECT_EQ(spread.mean, 100.0);
}

TEST(Study, TablesSayWhatWasSetAndWhatCameOut) {
  const Study study = Sample();
  const std::vector<StudyRow> rows{Row(1, 0, true, 80.0), Row(2, 0, false, 120.0),
                                   Row(5, 4, true, 90.0)};
  const std::string runs = StudyRunsCsv(study, rows);
  EXPECT_THAT(runs, HasSubstr("run,seed,start.alpha_deg,changed,changed_to,outcome,docked,"));
  EXPECT_THAT(runs, HasSubstr("\n1,7,0,,,docked,1,"));
  EXPECT_THAT(runs, HasSubstr("\n5,7,5,changes.a,1,docked,1,"));
  const std::string points = StudyPointsCsv(study, rows);
  EXPECT_THAT(points, HasSubstr("\n0,,,2,0.5,"));
  const std::string table = StudyTable(study, rows);
  EXPECT_THAT(table, HasSubstr("| 0 |  |  | 1/2 (50 %, 1-99 %) | 100 (84 to 116) |"));
}

TEST(Study, CurvesBandIsInTheirPlotAndChangedPointsStayOut) {
  const Study study = Sample();
  std::vector<StudyRow> rows;
  for (int level = 0; level < 3; ++level) rows.push_back(Row(level + 1, level, true, 50.0));
  const std::string before = StudyCurves(study, rows);
  EXPECT_THAT(before, HasSubstr("<polygon"));
  rows.push_back(Row(9, 4, false, 500.0));
  // But for the number of runs in the title.
  EXPECT_EQ(StudyCurves(study, rows).size(), before.size());
  Study without_x = study;
  without_x.x.clear();
  EXPECT_EQ(StudyCurves(without_x, rows), "");
}

TEST(Study, BarsAreTheDifferenceFromTheUnchanged) {
  Study study = Sample();
  const std::vector<StudyRow> rows{Row(1, 0, true, 80.0), Row(2, 3, false, 120.0)};
  const std::string bars = StudyBars(study, rows);
  EXPECT_THAT(bars, HasSubstr("changes.a = 1"));
  EXPECT_THAT(bars, Not(HasSubstr("changes.a = 2")));  // no run of it yet
  EXPECT_THAT(bars, HasSubstr("docked 1/1"));
  EXPECT_THAT(bars, HasSubstr("peak tension 80 N"));
  study.one_at_a_time.clear();
  EXPECT_EQ(StudyBars(study, {}), "");
}

TEST(Script, PlaysItsStepsAndGivesUp) {
  RoverSheet sheet;
  sheet.wheel_radius_m = 0.3;
  sheet.track_m = 0.8;
  sheet.drum_radius_m = 0.06;
  for (MotorSheet& motor : sheet.motors) {
    motor = {.torque_per_amp_nm = 10.0, .no_load_current_a = 0.2, .max_current_a = 2.0};
  }
  ScriptStep arc, reel, held;
  arc.for_s = 2.0;
  arc.speed_m_s = 0.06;
  arc.turn_rad_s = 0.03;
  arc.tension_n = 50.0;
  reel.for_s = 1.0;
  reel.free_wheels = true;
  reel.reel_m_s = 0.03;
  held.for_s = 1.0;
  const auto brain = MakeScriptedController(sheet, {arc, reel, held});
  const auto at = [&](double seconds) {
    SensorFrame frame;
    frame.tick = static_cast<Tick>(std::llround(seconds / kTickSeconds));
    return brain->Step(frame);
  };
  Commands c = at(0.0);
  EXPECT_NEAR(c.motors[0].target, (0.06 - 0.4 * 0.03) / 0.3, 1e-12);
  EXPECT_NEAR(c.motors[1].target, (0.06 + 0.4 * 0.03) / 0.3, 1e-12);
  EXPECT_NEAR(c.motors[3].current_limit_a, 0.2 + 50.0 * 0.06 / 10.0, 1e-12);
  c = at(2.5);
  EXPECT_EQ(c.motors[0].mode, MotorMode::kFree);
  EXPECT_NEAR(c.motors[3].target, 0.5, 1e-12);
  EXPECT_EQ(c.motors[3].current_limit_a, 2.0);
  c = at(3.5);
  EXPECT_EQ(c.motors[3].mode, MotorMode::kBrake);
  EXPECT_EQ(c.verdict, Verdict::kUnderWay);
  EXPECT_EQ(at(4.0).verdict, Verdict::kGivenUp);
}

}  // namespace
}  // namespace dockyard
