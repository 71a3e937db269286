// The tables of columns against the headers that the program writes.
#include "sim/report/column_tables.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

#include "sim/base/text.h"
#include "sim/log/record_files.h"
#include "sim/log/result_row.h"
#include "sim/log/results.h"
#include "sim/log/value_table.h"
#include "sim/report/points.h"
#include "sim/report/sensitivity.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

/// The first line of a table with these columns, the names in brackets filled in.
std::string HeaderOf(const std::string& file,
                     const std::vector<std::pair<std::string, std::vector<std::string>>>& filled) {
  for (const ColumnTable& table : ColumnTables()) {
    if (table.file != file) continue;
    std::vector<std::string> names;
    for (const Column& column : table.columns) {
      const auto known = std::find_if(filled.begin(), filled.end(),
                                      [&](const auto& each) { return each.first == column.name; });
      if (known == filled.end()) {
        names.push_back(column.name);
      } else {
        names.insert(names.end(), known->second.begin(), known->second.end());
      }
    }
    return CsvLine(names);
  }
  throw std::runtime_error("no table of " + file);
}

std::string FirstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

RowColumns OneEach() {
  return {.labels = {"soil"}, .measures = {{"depth_m", "m", "x"}}, .outcomes = {}};
}

TEST(ColumnTables, AreThoseOfResults) {
  EXPECT_EQ(HeaderOf("results.csv", {{"[labels]", {"soil"}}, {"[measures]", {"depth_m"}}}),
            CsvHeader(OneEach()));
  EXPECT_EQ(HeaderOf("timing.csv", {}), FirstLine(TimingHeader()));
}

TEST(ColumnTables, AreThoseOfValues) {
  RunRecord record;
  record.value_names = {"reeled_m"};
  EXPECT_EQ(HeaderOf("values.csv", {{"[values]", {"reeled_m"}}}), FirstLine(ValuesCsv(record)));
}

TEST(ColumnTables, AreThoseOfPoints) {
  const std::string filled =
      HeaderOf("points.csv", {{"[settings]", {"soil"}},
                              {"[measure]_mean", {"sim_time_s_mean", "sim_time_s_p10"}},
                              {"[measure]_p10", {"sim_time_s_p90", "depth_m_mean"}},
                              {"[measure]_p90", {"depth_m_p10", "depth_m_p90"}}});
  EXPECT_EQ(filled, FirstLine(PointsCsv({"soil"}, OneEach(), {})));
}

TEST(ColumnTables, AreThoseOfSensitivities) {
  EXPECT_EQ(HeaderOf("sensitivity.csv", {}), FirstLine(SensitivityCsv({})));
  EXPECT_EQ(HeaderOf("sensitivity_levels.csv", {}), FirstLine(SensitivityLevelsCsv({})));
}

TEST(ColumnTables, AreThoseOfTheHistory) {
  RunRecord record;
  record.channels = {{"tension_n", "N", "x"}};
  record.belief_columns = {{"recoveries", "", "x"}};
  record.sensors = {{.name = "depth_m", .unit = "m", .meaning = "x"}};
  EXPECT_EQ(HeaderOf("history.csv", {{"[channels]", {"tension_n"}},
                                     {"sensor.NAME", {"sensor.depth_m"}},
                                     {"[beliefs]", {"recoveries"}}}),
            FirstLine(HistoryCsv(record)));
}

TEST(ColumnTables, HaveAMeaningAndTheUnitThatTheNameEndsIn) {
  for (const ColumnTable& table : ColumnTables()) {
    EXPECT_FALSE(table.about.empty());
    for (const Column& column : table.columns) {
      EXPECT_FALSE(column.meaning.empty()) << column.name;
      EXPECT_TRUE(column.unit.empty() || column.name.ends_with("_" + column.unit)) << column.name;
    }
  }
}

TEST(ColumnsPage, ListsTheColumnsOfEachSystem) {
  const std::string page = ColumnsPage({{"toy", {{"miss_m", "m", "from the flag"}}, {}, {}}});
  EXPECT_THAT(page, testing::HasSubstr("\n## Of the system toy\n\n| measure | unit | meaning |\n"
                                       "|---|---|---|\n| `miss_m` | m | from the flag |\n"));
  EXPECT_THAT(page, testing::HasSubstr("\n## history.csv\n\nOf a run"));
}

}  // namespace
}  // namespace dockyard
