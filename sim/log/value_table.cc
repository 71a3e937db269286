#include "sim/log/value_table.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "controller/base/check.h"
#include "sim/base/text.h"

namespace dockyard {
namespace {

std::vector<std::string> HeaderOf(const std::vector<std::string>& names) {
  std::vector<std::string> header{"time_s"};
  const std::set<std::string> taken(names.begin(), names.end());
  for (const std::string& name : names) {
    std::string shown = name;
    if (name == "time_s") {
      do {
        shown.insert(0, "value.");
      } while (taken.count(shown) > 0);
    }
    header.push_back(shown);
  }
  return header;
}

}  // namespace

std::vector<double> FurtherValues(const Belief& belief, const std::vector<Column>& columns,
                                  std::vector<std::string>& names) {
  std::vector<double> values(names.size(), std::nan(""));
  for (const NamedValue& each : belief.values) {
    const auto has_name = [&](const Column& column) { return column.name == each.name; };
    if (std::any_of(columns.begin(), columns.end(), has_name)) continue;
    const auto at = std::find(names.begin(), names.end(), each.name);
    const auto place = static_cast<std::size_t>(at - names.begin());
    if (at == names.end()) {
      DOCKYARD_CHECK(!each.name.empty() && names.size() < kMostValueNames);
      names.push_back(each.name);
      values.push_back(0.0);
    }
    values[place] = each.value;
  }
  return values;
}

std::string ValuesCsv(const RunRecord& record) {
  std::string csv = SafeCsvLine(HeaderOf(record.value_names)) + "\n";
  for (const HistorySample& sample : record.history) {
    std::vector<std::string> cells{NumberText(sample.time_s)};
    // Samples from before a name came are shorter.
    for (std::size_t i = 0; i < record.value_names.size(); ++i) {
      cells.push_back(NumberText(i < sample.values.size() ? sample.values[i] : std::nan("")));
    }
    csv += CsvLine(cells) + "\n";
  }
  return csv;
}

}  // namespace dockyard
