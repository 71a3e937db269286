#include "sim/report/point_verdicts.h"

#include <algorithm>

#include "sim/base/count_text.h"
#include "sim/base/text.h"
#include "sim/report/rate_text.h"
#include "sim/statistics/multiple.h"

namespace dockyard {
namespace {

int CountOf(const PointVerdicts& judged, AcceptanceVerdict verdict) {
  return static_cast<int>(
      std::count_if(judged.points.begin(), judged.points.end(),
                    [&](const PointVerdict& point) { return point.found.verdict == verdict; }));
}

/// Columns as wide as their longest cell.
std::string Aligned(const std::vector<std::vector<std::string>>& lines) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& cells : lines) {
    for (std::size_t i = 0; i < cells.size(); ++i) widths[i] = std::max(widths[i], cells[i].size());
  }
  std::string text;
  for (const auto& cells : lines) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      line += cells[i] + std::string(widths[i] - cells[i].size() + 2, ' ');
    }
    text += line.erase(line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace

AcceptanceVerdict PointVerdicts::verdict() const {
  if (CountOf(*this, AcceptanceVerdict::kNotAccepted) > 0) return AcceptanceVerdict::kNotAccepted;
  const bool all = !points.empty() &&
                   CountOf(*this, AcceptanceVerdict::kAccepted) == static_cast<int>(points.size());
  return all ? AcceptanceVerdict::kAccepted : AcceptanceVerdict::kUndecided;
}

PointVerdicts JudgePoints(const std::vector<std::string>& keys, const RowColumns& columns,
                          const Rows& rows, double reliability, double confidence) {
  PointVerdicts judged{keys, reliability, confidence, confidence, {}};
  const std::vector<Point> points = ByPoint(keys, columns, rows);
  if (!points.empty()) {
    judged.confidence_of_each = ConfidenceOfEach(confidence, static_cast<int>(points.size()));
  }
  for (const Point& point : points) {
    PointVerdict verdict{point.settings, static_cast<int>(point.rows.size()), 0, {}};
    for (const RunResult* row : point.rows) verdict.failures += row->success ? 0 : 1;
    verdict.found =
        JudgeAcceptance(verdict.runs, verdict.failures, reliability, judged.confidence_of_each);
    judged.points.push_back(verdict);
  }
  return judged;
}

Json PointVerdictsJson(const PointVerdicts& judged, AcceptanceVerdict verdict) {
  Json points = Json::array();
  int runs = 0, failures = 0;
  for (const PointVerdict& point : judged.points) {
    runs += point.runs;
    failures += point.failures;
    Json settings = Json::object();
    for (std::size_t i = 0; i < judged.keys.size(); ++i) settings[judged.keys[i]] = point.values[i];
    points.push_back({{"value", Listed(point.values)},
                      {"settings", settings},
                      {"runs", point.runs},
                      {"failures", point.failures},
                      {"lower", point.found.lower},
                      {"upper", point.found.upper},
                      {"verdict", NameOf(point.found.verdict)},
                      {"further_runs", nullptr}});
    if (point.found.further_runs) points.back()["further_runs"] = *point.found.further_runs;
  }
  return {{"verdict", NameOf(verdict)},
          {"trials", runs},
          {"failures", failures},
          {"reliability", judged.reliability},
          {"confidence", judged.confidence},
          {"by", judged.keys},
          {"points", points},
          {"family_error", 1.0 - judged.confidence},
          {"correction", "bonferroni"},
          {"confidence_of_each", judged.confidence_of_each}};
}

std::string PointVerdictsText(const PointVerdicts& judged, AcceptanceVerdict verdict) {
  std::vector<std::vector<std::string>> lines{judged.keys};
  for (const char* name : {"runs", "failures", "at least", "at most", "verdict"}) {
    lines.front().push_back(name);
  }
  for (const PointVerdict& point : judged.points) {
    std::vector<std::string> cells = point.values;
    for (std::string& cell : cells) cell = cell.empty() ? "-" : cell;
    cells.insert(cells.end(), {std::to_string(point.runs), std::to_string(point.failures),
                               BriefNumber(point.found.lower), BriefNumber(point.found.upper),
                               NameOf(point.found.verdict)});
    lines.push_back(cells);
  }
  return Aligned(lines) + NameOf(verdict) + ": reliability " + NumberText(judged.reliability) +
         " at confidence " + NumberText(judged.confidence) + " for " +
         CountText(judged.points.size(), "point") + " together; " +
         std::to_string(CountOf(judged, AcceptanceVerdict::kAccepted)) + " accepted, " +
         std::to_string(CountOf(judged, AcceptanceVerdict::kNotAccepted)) + " not accepted\n" +
         "a point that is below it is accepted with a chance of at most " +
         BriefNumber(1.0 - judged.confidence) + " in all (Bonferroni: each point at confidence " +
         BriefNumber(judged.confidence_of_each) + ")\n";
}

}  // namespace dockyard
