// A campaign's results as JUnit XML, which CI servers read: a test case for each run and for each
// requirement. The elements and attributes are those that Jenkins' schema knows
// (jenkinsci/xunit-plugin, junit-10.xsd).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/log/record.h"
#include "sim/report/requirement.h"

namespace dockyard {

/// A run as a test case.
struct JUnitRun {
  const RunResult* row = nullptr;  // not null
  double wall_time_s = 0.0;
  std::string note;    // what went wrong
  std::string replay;  // the command that shows it again; empty: there is none
};

/// What stands in the suite's head and in the names of its cases.
struct JUnitSuite {
  std::string campaign;
  std::vector<std::string> named;  // labels in a case's name; draws would make it long
  std::vector<std::pair<std::string, std::string>> properties;  // beside the counts
};

/// A run that succeeded passes, a run that was lost is an error, any other a failure by its
/// outcome. A requirement that is not met is a failure. Bytes that are no UTF-8 are replaced.
std::string JUnitXml(const JUnitSuite& suite, const RowColumns& columns,
                     const std::vector<JUnitRun>& runs, const std::vector<Judgement>& requirements);

}  // namespace dockyard
