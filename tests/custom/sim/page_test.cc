// docs/reference/custom.md lists the keys as the code reads them.
#include <gtest/gtest.h>

#include "custom/charger_rig.h"
#include "sim/custom/custom_keys.h"
#include "sim/scenario/keys.h"
#include "support/bad_files.h"

namespace dockyard::custom {
namespace {

void ExpectTable(const std::string& whose, const Keys::Visit& visit) {
  const std::string page = Slurp(SourceFile("docs/reference/custom.md"));
  const std::string begin = "<!-- keys " + whose + ": tests/custom/sim/page_test.cc -->\n";
  const std::size_t from = page.find(begin), to = page.find("<!-- end of keys " + whose + " -->");
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::size_t first = from + begin.size();
  const std::string table = KeyTable(DocumentKeys(visit));
  EXPECT_EQ(page.substr(first, to - first), table) << "docs/reference/custom.md should have\n"
                                                   << table;
}

TEST(CustomPage, HasTheKeysOfARobotAsTheVisitorDocumentsThem) {
  ExpectTable("of a robot", VisitRobotKeys);
}

TEST(CustomPage, HasTheKeysOfADockAsTheVisitorDocumentsThem) {
  ExpectTable("of a dock", VisitDockKeys);
}

TEST(CustomPage, HasTheKeysOfAScenarioAsTheVisitorDocumentsThem) {
  ExpectTable("under custom", [](Keys& keys) {
    CustomKeys values;
    VisitCustomKeys(keys, values);
  });
}

}  // namespace
}  // namespace dockyard::custom
