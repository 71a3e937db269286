#include "sim/report/junit.h"

#include <algorithm>
#include <map>

#include "controller/base/check.h"
#include "sim/base/json.h"
#include "sim/base/text.h"
#include "sim/report/points.h"
#include "sim/report/svg.h"

namespace dockyard {
namespace {

/// As UTF-8: the JSON library replaces other bytes by U+FFFD. XML excludes two characters more.
std::string Escaped(const std::string& text) {
  const std::string json = Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string valid = Json::parse(json).get<std::string>();
  for (const char* excluded : {"\xef\xbf\xbe", "\xef\xbf\xbf"}) {  // U+FFFE, U+FFFF
    for (std::size_t at = 0; (at = valid.find(excluded, at)) != std::string::npos;) {
      valid.replace(at, 3, "?");
    }
  }
  return XmlText(valid);
}

std::string Attribute(const char* name, const std::string& value) {
  return " " + std::string(name) + "=\"" + Escaped(value) + "\"";
}

std::string NameOf(const JUnitSuite& suite, const RowColumns& columns, const RunResult& row) {
  std::string name = "run " + std::to_string(row.run);
  for (const std::string& label : suite.named) {
    const std::string& text = LabelOf(row, columns, label);
    if (!text.empty()) name += " " + label + "=" + text;
  }
  return name;
}

std::string ClassOf(const JUnitSuite& suite, const RowColumns& columns, const RunResult& row) {
  const auto& labels = columns.labels;
  if (std::find(labels.begin(), labels.end(), "arm") == labels.end()) return suite.campaign;
  return suite.campaign + "." + LabelOf(row, columns, "arm");
}

/// @param element  failure or error
std::string Fault(const char* element, const std::string& type, const std::string& message,
                  const std::string& more) {
  std::string text = "      <" + std::string(element) + Attribute("type", type) +
                     Attribute("message", message) + ">" + Escaped(message);
  if (!more.empty()) text += "\n" + Escaped(more);
  return text + "</" + element + ">\n";
}

std::string CaseOf(const JUnitSuite& suite, const RowColumns& columns, const JUnitRun& run) {
  const RunResult& row = *run.row;
  std::string text = "    <testcase" + Attribute("classname", ClassOf(suite, columns, row)) +
                     Attribute("name", NameOf(suite, columns, row)) +
                     Attribute("time", Fixed(run.wall_time_s, 3));
  if (row.success) return text + "/>\n";
  const bool lost = IsLost(row.outcome);
  const std::string message = row.outcome + (run.note.empty() ? "" : ": " + run.note);
  return text + ">\n" +
         Fault(lost ? "error" : "failure", row.outcome, message,
               run.replay.empty() ? "" : "again: " + run.replay) +
         "    </testcase>\n";
}

std::string CaseOf(const JUnitSuite& suite, const Judgement& judged) {
  std::string text = "    <testcase" + Attribute("classname", suite.campaign + ".requirements") +
                     Attribute("name", judged.requirement.text) + Attribute("time", "0");
  if (judged.met) return text + "/>\n";
  return text + ">\n" + Fault("failure", "requirement", judged.text, "") + "    </testcase>\n";
}

std::string Property(const std::string& name, const std::string& value) {
  return "      <property" + Attribute("name", name) + Attribute("value", value) + "/>\n";
}

struct Totals {
  int successes = 0, errors = 0, failures = 0;
  double wall_time_s = 0.0;
  std::map<std::string, int> outcomes;
};

Totals TotalsOf(const std::vector<JUnitRun>& runs, const std::vector<Judgement>& requirements) {
  Totals totals;
  for (const JUnitRun& run : runs) {
    DOCKYARD_CHECK(run.row != nullptr);
    const bool lost = IsLost(run.row->outcome);
    totals.successes += run.row->success;
    totals.errors += lost;
    totals.failures += !run.row->success && !lost;
    totals.wall_time_s += run.wall_time_s;
    ++totals.outcomes[run.row->outcome];
  }
  for (const Judgement& judged : requirements) totals.failures += !judged.met;
  return totals;
}

}  // namespace

std::string JUnitXml(const JUnitSuite& suite, const RowColumns& columns,
                     const std::vector<JUnitRun>& runs,
                     const std::vector<Judgement>& requirements) {
  const Totals totals = TotalsOf(runs, requirements);
  const std::string counts = Attribute("name", suite.campaign) +
                             Attribute("tests", std::to_string(runs.size() + requirements.size())) +
                             Attribute("failures", std::to_string(totals.failures)) +
                             Attribute("errors", std::to_string(totals.errors)) +
                             Attribute("time", Fixed(totals.wall_time_s, 3)) + ">\n";
  std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + counts +
                     "  <testsuite" + counts + "    <properties>\n";
  for (const auto& [name, value] : suite.properties) text += Property(name, value);
  text += Property("runs", std::to_string(runs.size()));
  text += Property("successes", std::to_string(totals.successes));
  text += Property("docked", std::to_string(totals.successes));  // the former name
  for (const auto& [outcome, count] : totals.outcomes) {
    text += Property("outcome." + outcome, std::to_string(count));
  }
  text += "    </properties>\n";
  for (const JUnitRun& run : runs) text += CaseOf(suite, columns, run);
  for (const Judgement& judged : requirements) text += CaseOf(suite, judged);
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace dockyard
