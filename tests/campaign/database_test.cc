#include "sim/campaign/database.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>

#include <limits>
#include <memory>

#include "sim/base/files.h"
#include "sim/base/text.h"
#include "sim/log/result_row.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

/// Cells of a query's rows as text, reals in their shortest exact form; "NULL" for none.
std::vector<std::vector<std::string>> Ask(const std::filesystem::path& file, const char* sql) {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  sqlite3_stmt* query = nullptr;
  EXPECT_EQ(sqlite3_prepare_v2(database, sql, -1, &query, nullptr), SQLITE_OK)
      << sqlite3_errmsg(database);
  std::vector<std::vector<std::string>> rows;
  while (sqlite3_step(query) == SQLITE_ROW) {
    auto& cells = rows.emplace_back();
    for (int i = 0; i < sqlite3_column_count(query); ++i) {
      const int type = sqlite3_column_type(query, i);
      if (type == SQLITE_NULL) {
        cells.push_back("NULL");
      } else if (type == SQLITE_FLOAT) {  // SQLite prints 15 digits only
        cells.push_back(NumberText(sqlite3_column_double(query, i)));
      } else {
        cells.push_back(reinterpret_cast<const char*>(sqlite3_column_text(query, i)));
      }
    }
  }
  sqlite3_finalize(query);
  sqlite3_close(database);
  return rows;
}

FinishedRuns SomeRuns() {
  FinishedRuns runs = FakeResults(6);
  runs.results[1].seed = 0xfedcba9876543210ull;  // beyond 2^63
  runs.results[1].labels[0] = "wet, \"sticky\"";
  return runs;
}

TEST(Database, HoldsWhatTheCsvHolds) {
  const TemporaryFolder folder;
  const FinishedRuns runs = SomeRuns();
  WriteDatabase(folder.path() / "results.sqlite", runs, FakeColumns());
  std::vector<std::vector<std::string>> cells;
  for (const RunResult& result : runs.results) cells.push_back(RowCells(result, FakeColumns()));
  EXPECT_EQ(Ask(folder.path() / "results.sqlite", "SELECT * FROM runs ORDER BY run"), cells);
}

TEST(Database, KnowsItsColumnsByNameAndKind) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "results.sqlite";
  WriteDatabase(file, SomeRuns(), FakeColumns());
  const auto asked = Ask(file,
                         "SELECT typeof(run), typeof(seed), typeof(soil), typeof(\"start.r_m\"),"
                         " typeof(success), typeof(sim_time_s), typeof(images), typeof(depth_m),"
                         " typeof(state_hash) FROM runs WHERE run = 1");
  EXPECT_EQ(asked[0], (std::vector<std::string>{"integer", "text", "text", "real", "integer",
                                                "real", "integer", "real", "text"}));
}

TEST(Database, ComparesLabelsThatAreNumbersAsNumbers) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "results.sqlite";
  FinishedRuns runs = FakeResults(3);
  runs.results[0].labels[1] = "10";
  runs.results[1].labels[1] = "9.5";
  runs.results[2].labels[1] = "far";
  WriteDatabase(file, runs, FakeColumns());
  const auto asked = Ask(file, "SELECT run FROM runs WHERE \"start.r_m\" BETWEEN 9 AND 11");
  EXPECT_EQ(asked, (std::vector<std::vector<std::string>>{{"1"}, {"2"}}));
}

TEST(Database, HasNullForNotANumberAndForACrashedRunsMeasures) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "results.sqlite";
  FinishedRuns runs = FakeResults(2);
  runs.results[0].measures[0] = std::numeric_limits<double>::quiet_NaN();
  runs.results[1].measures.clear();
  WriteDatabase(file, runs, FakeColumns());
  const auto asked = Ask(file, "SELECT depth_m, force_peak_n FROM runs ORDER BY run");
  EXPECT_EQ(asked[0], (std::vector<std::string>{"NULL", NumberText(0.1 + 0.2)}));
  EXPECT_EQ(asked[1], (std::vector<std::string>{"NULL", "NULL"}));
}

TEST(Database, TakesAnyNameForALabel) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "results.sqlite";
  RowColumns columns = FakeColumns();
  columns.labels = {"a \"quoted\" name", "Run"};
  WriteDatabase(file, FakeResults(1), columns);
  const auto asked = Ask(file, "SELECT \"a \"\"quoted\"\" name\", \"table.Run\" FROM runs");
  EXPECT_EQ(asked[0], (std::vector<std::string>{"compact", "2.5"}));
}

TEST(Database, IsTheSameFileForTheSameRows) {
  const TemporaryFolder folder;
  WriteDatabase(folder.path() / "a", SomeRuns(), FakeColumns());
  WriteDatabase(folder.path() / "b", SomeRuns(), FakeColumns());
  WriteDatabase(folder.path() / "b", SomeRuns(), FakeColumns());  // over an old one
  EXPECT_EQ(Slurp(folder.path() / "a"), Slurp(folder.path() / "b"));
}

TEST(Database, SaysWhereItCannotBeWritten) {
  try {
    WriteDatabase("/nowhere/results.sqlite", SomeRuns(), FakeColumns());
    FAIL() << "written to a folder that is not there";
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cannot write /nowhere/results.sqlite: "));
  }
}

}  // namespace
}  // namespace dockyard
