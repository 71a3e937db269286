#include "sim/report/reproduction_failures.h"

#include <algorithm>
#include <cmath>

#include "sim/report/points.h"

namespace dockyard {
namespace {

constexpr double kOfClass = 0.95;  // confidence

/// Of one of the summed columns; NaN where the row does not have it.
double ValueOf(const RunResult& row, const RowColumns& columns, const std::string& name) {
  const std::vector<Column> summed = SummedColumns(columns);
  const auto at = std::find_if(summed.begin(), summed.end(),
                               [&](const Column& column) { return column.name == name; });
  return SummedValue(row, static_cast<std::size_t>(at - summed.begin()));
}

bool Matches(const std::vector<ColumnFilter>& where, const RunResult& row,
             const RowColumns& columns) {
  return std::all_of(where.begin(), where.end(), [&](const ColumnFilter& filter) {
    const double value = ValueOf(row, columns, filter.column.text);
    return std::find(filter.values.begin(), filter.values.end(), value) != filter.values.end();
  });
}

/// The run's last accepted sighting; null where there is none or no log is kept.
const SightingError* LastSighting(const RunResult& row, const SightingErrors& sightings) {
  const auto found = sightings.find(row.run);
  return found == sightings.end() || found->second.empty() ? nullptr : &found->second.back();
}

bool Holds(const FailureCase& given, const RunResult& row, const RowColumns& columns,
           const SightingError* last, const Published& published) {
  if (!given.outcomes.empty() && !IsNamed(given.outcomes, row.outcome)) return false;
  if (!Matches(given.where, row, columns)) return false;
  if (!given.wrong_sighting && given.methods.empty()) return true;
  if (last == nullptr) return false;
  if (!given.methods.empty() &&
      std::find(given.methods.begin(), given.methods.end(), last->method) == given.methods.end())
    return false;
  return !given.wrong_sighting || IsWrong(*last, published);
}

/// The first class of the file that the failure belongs to; their number for the others.
std::size_t ClassOf(const RunResult& row, const CampaignResults& results,
                    const Published& published) {
  const SightingError* last = LastSighting(row, results.sightings);
  for (std::size_t i = 0; i < published.failures.size(); ++i) {
    const FailureClass& failure = published.failures[i];
    if (!Matches(failure.where, row, results.columns)) continue;
    if (std::any_of(failure.cases.begin(), failure.cases.end(), [&](const FailureCase& each) {
          return Holds(each, row, results.columns, last, published);
        })) {
      return i;
    }
  }
  return published.failures.size();
}

/// Where the runs are those of the paper.
void Predict(int replications, FailureFinding* each) {
  if (!each->paper || each->runs != each->paper->runs * replications) return;
  const PublishedCount paper = *each->paper;
  each->at_95 = PredictCount(each->count, each->runs, paper.runs, kOfClass);
  each->judged_at = PredictCount(each->count, each->runs, paper.runs, each->confidence);
  each->p = PredictionP(each->count, each->runs, paper.count, paper.runs);
}

}  // namespace

bool IsNamed(const std::vector<PublishedName>& names, const std::string& text) {
  return std::any_of(names.begin(), names.end(),
                     [&](const PublishedName& name) { return name.text == text; });
}

bool IsWrong(const SightingError& error, const Published& published) {
  return error.place_error_m > published.wrong_place_m ||
         std::abs(error.heading_error_rad) > published.wrong_heading_rad;
}

std::vector<FailureFinding> FindFailures(const Published& published,
                                         const CampaignResults& results) {
  std::vector<FailureFinding> found;
  if (published.failures.empty()) return found;
  int judged = 0;
  for (const FailureClass& failure : published.failures) {
    FailureFinding each{failure.name, failure.says, failure.paper};
    for (const RunResult& row : results.rows) {
      each.runs += Matches(failure.where, row, results.columns);
    }
    each.counts = failure.judged;
    judged += failure.judged;
    found.push_back(std::move(each));
  }
  found.push_back({"others", published.others, {}, 0, static_cast<int>(results.rows.size())});
  for (const RunResult& row : results.rows) {
    if (!Counts(published, row)) ++found[ClassOf(row, results, published)].count;
  }
  for (FailureFinding& each : found) {
    if (each.counts) each.confidence = 1.0 - (1.0 - kOfClass) / judged;
    Predict(results.replications, &each);
  }
  return found;
}

}  // namespace dockyard
