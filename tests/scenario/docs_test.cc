// docs/reference/scenarios.md lists the keys as the code reads them.
#include <gtest/gtest.h>

#include "sim/scenario/scenario_keys.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

TEST(ScenarioPage, HasTheTableOfKeysThatTheVisitorDocuments) {
  const std::string page = Slurp(SourceFile("docs/reference/scenarios.md"));
  const std::string begin = "tests/scenario/docs_test.cc -->\n", end = "<!-- end of keys -->";
  const std::size_t from = page.find(begin), to = page.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::size_t first = from + begin.size();
  const std::string table = KeyTable(ScenarioRows());
  EXPECT_EQ(page.substr(first, to - first), table) << "docs/reference/scenarios.md should have\n"
                                                   << table;
}

TEST(ScenarioPage, EveryRowHasAMeaning) {
  for (const KeyRow& row : ScenarioRows()) EXPECT_FALSE(row.meaning.empty()) << row.key;
}

}  // namespace
}  // namespace dockyard
