// docs/reference/run_log.md lists the columns as the code writes them.
#include <gtest/gtest.h>

#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "sim/axel/axel_columns.h"
#include "sim/log/record_files.h"
#include "sim/log/result_row.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

/// The page's lines between the comments "<!-- WHAT: ... -->" and "<!-- end of WHAT -->".
std::string PartOfPage(const std::string& what) {
  const std::string page = Slurp(SourceFile("docs/reference/run_log.md"));
  const std::size_t comment = page.find("<!-- " + what + ": ");
  const std::size_t from = page.find('\n', comment), to = page.find("<!-- end of " + what + " -->");
  if (comment == std::string::npos || to == std::string::npos || to < from) return "none";
  return page.substr(from + 1, to - from - 1);
}

std::string ColumnTable(const std::string& kind, const std::vector<Column>& columns) {
  std::string text = "| " + kind + " | unit | meaning |\n|---|---|---|\n";
  for (const Column& column : columns) {
    text += "| `" + column.name + "` | " + column.unit + " | " + column.meaning + " |\n";
  }
  return text;
}

/// The first cells of a table's rows, with commas between all their names.
std::string NamesOfRows(const std::string& table) {
  std::istringstream lines(table);
  std::string line, names;
  for (int i = 0; std::getline(lines, line); ++i) {
    if (i < 2) continue;  // the head and the rule
    const std::string cell = line.substr(1, line.find('|', 1) - 1);
    if (!names.empty()) names += ',';
    for (const char c : cell) {
      if (c != '`' && c != ' ') names += c;
    }
  }
  return names;
}

TEST(RunLogPage, HasTheTableOfAxelsMeasures) {
  const std::string table = ColumnTable("measure", axel::Measures());
  EXPECT_EQ(PartOfPage("measures of axel"), table) << "docs/reference/run_log.md should have\n"
                                                   << table;
}

TEST(RunLogPage, HasTheTableOfAxelsChannels) {
  const std::string table = ColumnTable("channel", axel::Channels());
  EXPECT_EQ(PartOfPage("channels of axel"), table) << "docs/reference/run_log.md should have\n"
                                                   << table;
}

TEST(RunLogPage, HasTheTableOfAxelsBeliefs) {
  const std::string table = ColumnTable("belief", axel::Beliefs());
  EXPECT_EQ(PartOfPage("beliefs of axel"), table) << "docs/reference/run_log.md should have\n"
                                                  << table;
}

TEST(RunLogPage, NamesTheColumnsOfResultsInTheirOrder) {
  RowColumns columns;
  columns.labels = {"labels"};
  columns.measures = {{"measures", "", ""}};
  EXPECT_EQ(NamesOfRows(PartOfPage("columns of results.csv")), CsvHeader(columns));
}

TEST(RunLogPage, NamesTheColumnsOfTheHistoryInTheirOrder) {
  RunRecord record;
  record.channels = {{"channels", "", ""}};
  record.belief_columns = {{"beliefs", "", ""}};
  EXPECT_EQ(NamesOfRows(PartOfPage("columns of history.csv")) + "\n", HistoryCsv(record));
}

TEST(AxelColumns, EachHasAMeaningAndANameThatEndsInItsUnit) {
  for (const auto& columns : {axel::Channels(), axel::Beliefs(), axel::Measures()}) {
    for (const Column& column : columns) {
      EXPECT_FALSE(column.meaning.empty()) << column.name;
      std::string ending = column.unit.empty() ? "" : "_" + column.unit;
      for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      EXPECT_TRUE(column.name.ends_with(ending)) << column.name << " [" << column.unit << "]";
    }
  }
}

}  // namespace
}  // namespace dockyard
