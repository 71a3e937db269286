#include "sim/report/junit.h"

#include <gmock/gmock.h>
#include <tinyxml.h>

#include <set>

#include "sim/base/json.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

RowColumns Columns() {
  RowColumns columns = FakeColumns();
  columns.labels = {"arm", "soil"};
  return columns;
}

RunResult Row(int run, const std::string& arm, const std::string& outcome) {
  RunResult row;
  row.run = run;
  row.labels = {arm, "loose"};
  row.outcome = outcome;
  row.success = outcome == "docked";
  if (outcome != kCrashed) row.measures = {0.1, 2.0, 3.0};
  return row;
}

const std::vector<RunResult> kRows{Row(1, "ours", "docked"), Row(2, "paper", "missed"),
                                   Row(3, "ours", kCrashed)};

std::vector<JUnitRun> Runs(const std::string& note = "it drove past") {
  return {{&kRows[0], 1.25, "", ""},
          {&kRows[1], 2.5, note, "dockyard replay results/yard 2"},
          {&kRows[2], 0.0, "killed by signal 9", ""}};
}

std::vector<Judgement> Judged() {
  std::vector<Judgement> judged(2);
  judged[0].requirement.text = "docked >= 0.3";
  judged[0].met = true;
  judged[1].requirement.text = "docked[arm=ours] > 0.9";
  judged[1].text = "not met: docked[arm=ours] > 0.9, found 0.5 (1/2)";
  return judged;
}

const JUnitSuite kSuite{"yard", {"soil"}, {{"planned", "4"}}};

/// The parsed file; the test fails if it is no XML.
struct Parsed {
  explicit Parsed(const std::string& xml) {
    document.Parse(xml.c_str(), nullptr, TIXML_ENCODING_UTF8);
    EXPECT_FALSE(document.Error()) << document.ErrorDesc() << "\n" << xml;
    suite = document.RootElement()->FirstChildElement("testsuite");
  }
  std::vector<const TiXmlElement*> Cases() const {
    std::vector<const TiXmlElement*> cases;
    for (auto* at = suite->FirstChildElement("testcase"); at != nullptr;
         at = at->NextSiblingElement("testcase")) {
      cases.push_back(at);
    }
    return cases;
  }
  TiXmlDocument document;
  const TiXmlElement* suite = nullptr;
};

std::string Text(const TiXmlElement* element, const char* attribute) {
  const char* value = element->Attribute(attribute);
  return value == nullptr ? "none" : value;
}

TEST(JUnit, CountsRunsAndRequirements) {
  const Parsed xml(JUnitXml(kSuite, Columns(), Runs(), Judged()));
  for (const TiXmlElement* element :
       {static_cast<const TiXmlElement*>(xml.document.RootElement()), xml.suite}) {
    EXPECT_EQ(Text(element, "name"), "yard");
    EXPECT_EQ(Text(element, "tests"), "5");
    EXPECT_EQ(Text(element, "failures"), "2");
    EXPECT_EQ(Text(element, "errors"), "1");
    EXPECT_EQ(Text(element, "time"), "3.750");
  }
  ASSERT_EQ(xml.Cases().size(), 5u);
}

TEST(JUnit, HasATestCaseForEachRun) {
  const Parsed xml(JUnitXml(kSuite, Columns(), Runs(), {}));
  const auto runs = xml.Cases();
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(Text(runs[0], "classname"), "yard.ours");
  EXPECT_EQ(Text(runs[0], "name"), "run 1 soil=loose");
  EXPECT_EQ(Text(runs[0], "time"), "1.250");
  EXPECT_EQ(runs[0]->FirstChildElement(), nullptr);
  const TiXmlElement* failure = runs[1]->FirstChildElement("failure");
  ASSERT_NE(failure, nullptr);
  EXPECT_EQ(Text(failure, "type"), "missed");
  EXPECT_EQ(Text(failure, "message"), "missed: it drove past");
  EXPECT_THAT(failure->GetText(), HasSubstr("again: dockyard replay results/yard 2"));
  const TiXmlElement* error = runs[2]->FirstChildElement("error");
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(Text(error, "message"), "crashed: killed by signal 9");
}

TEST(JUnit, HasATestCaseForEachRequirement) {
  const Parsed xml(JUnitXml(kSuite, Columns(), {}, Judged()));
  const auto cases = xml.Cases();
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(Text(cases[0], "classname"), "yard.requirements");
  EXPECT_EQ(Text(cases[0], "name"), "docked >= 0.3");
  EXPECT_EQ(cases[0]->FirstChildElement(), nullptr);
  EXPECT_EQ(Text(cases[1], "name"), "docked[arm=ours] > 0.9");
  ASSERT_NE(cases[1]->FirstChildElement("failure"), nullptr);
  EXPECT_EQ(Text(cases[1]->FirstChildElement("failure"), "message"), Judged()[1].text);
}

TEST(JUnit, HasTheTotalsAsProperties) {
  const Parsed xml(JUnitXml(kSuite, Columns(), Runs(), {}));
  std::vector<std::string> properties;
  const TiXmlElement* list = xml.suite->FirstChildElement();
  ASSERT_STREQ(list->Value(), "properties");  // before the first case, as the older schema has it
  for (auto* at = list->FirstChildElement(); at != nullptr; at = at->NextSiblingElement()) {
    properties.push_back(Text(at, "name") + " " + Text(at, "value"));
  }
  EXPECT_THAT(properties, ElementsAre("planned 4", "runs 3", "successes 1", "docked 1",
                                      "outcome.crashed 1", "outcome.docked 1", "outcome.missed 1"));
}

TEST(JUnit, UsesTheElementsAndAttributesOfTheSchemaAlone) {
  const std::set<std::string> known{"testsuites name tests failures errors time",
                                    "testsuite name tests failures errors time",
                                    "properties",
                                    "property name value",
                                    "testcase classname name time",
                                    "failure type message",
                                    "error type message"};
  const Parsed xml(JUnitXml(kSuite, Columns(), Runs(), Judged()));
  std::vector<const TiXmlElement*> open{xml.document.RootElement()};
  while (!open.empty()) {
    const TiXmlElement* element = open.back();
    open.pop_back();
    std::string shape = element->Value();
    for (auto* at = element->FirstAttribute(); at != nullptr; at = at->Next()) {
      shape += std::string(" ") + at->Name();
    }
    EXPECT_EQ(known.count(shape), 1u) << shape;
    for (auto* at = element->FirstChildElement(); at != nullptr; at = at->NextSiblingElement()) {
      open.push_back(at);
    }
  }
}

TEST(JUnit, StaysXmlWhateverAProgramWrote) {
  for (const char* note : {"<&>\"'", "line\nbreak\ttab\x01", "\xff\xfe broken \xc3", "\xef\xbf\xbf",
                           "\xed\xa0\x80 half a pair", "]]>", "\xe2\x82\xac"}) {
    const std::string xml = JUnitXml(kSuite, Columns(), Runs(note), {});
    const Parsed parsed(xml);
    EXPECT_EQ(parsed.Cases().size(), 3u);
    EXPECT_EQ(xml.find("\xef\xbf\xbf"), std::string::npos);
    EXPECT_NO_THROW((void)Json(xml).dump()) << note;  // throws on bytes that are no UTF-8
  }
  const std::string euro = JUnitXml(kSuite, Columns(), Runs("\xe2\x82\xac"), {});
  EXPECT_THAT(euro, HasSubstr("missed: \xe2\x82\xac"));
}

}  // namespace
}  // namespace dockyard
