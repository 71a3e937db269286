#include "sim/report/reproduction.h"

#include <algorithm>
#include <cmath>

#include "sim/report/points.h"
#include "sim/report/reproduction_failures.h"
#include "sim/statistics/quantile.h"

namespace dockyard {
namespace {

constexpr double kConfidence = 0.95;

bool Contains(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

/// Runs, successes and true successes of a row.
void CountRuns(const Published& published, const CampaignResults& results, RowFinding* found) {
  const std::vector<PublishedName>& outcomes = found->row->outcomes;
  if (outcomes.empty() && !published.strict.empty()) found->strict.emplace();
  for (const RunResult& row : results.rows) {
    if (!Matches(found->row->where, row, results.columns)) continue;
    ++found->runs;
    found->successes += outcomes.empty() ? Counts(published, row) : IsNamed(outcomes, row.outcome);
    if (found->strict) found->strict->successes += IsNamed(published.strict, row.outcome);
  }
}

RowFinding FindRow(const Published& published, std::size_t place, const CampaignResults& results) {
  RowFinding found;
  found.row = &published.rows[place];
  CountRuns(published, results, &found);
  const auto& judged = published.judged;
  const bool of_judged = std::find(judged.begin(), judged.end(), place) != judged.end();
  found.counts = of_judged || place == published.total;
  if (of_judged) {
    found.confidence = 1.0 - (1.0 - kConfidence) / static_cast<double>(judged.size());
  }
  if (!found.row->paper) return found;
  const PublishedCount paper = *found.row->paper;
  const int wanted = found.row->runs > 0 ? found.row->runs : paper.runs * results.replications;
  found.lacking = wanted - found.runs;
  found.at_95 = PredictCount(found.successes, found.runs, paper.runs, kConfidence);
  found.judged_at = PredictCount(found.successes, found.runs, paper.runs, found.confidence);
  found.p = PredictionP(found.successes, found.runs, paper.count, paper.runs);
  if (found.strict) {
    const int strict = found.strict->successes;
    found.strict->at_95 = PredictCount(strict, found.runs, paper.runs, kConfidence);
    found.strict->p = PredictionP(strict, found.runs, paper.count, paper.runs);
  }
  return found;
}

struct MeanAndMedian {
  double mean = std::nan(""), median = std::nan("");
};

MeanAndMedian Middle(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  double sum = 0.0;
  for (const double value : values) sum += value;
  return {sum / static_cast<double>(values.size()), SampleQuantile(values, 0.5)};
}

ErrorFinding FindError(const PublishedError& paper, const Published& published,
                       const SightingErrors& sightings) {
  ErrorFinding found;
  found.paper = paper;
  std::vector<double> r_m, place_m, heading_rad;
  for (const auto& [run, errors] : sightings) {
    const int before = found.sightings;
    for (const SightingError& error : errors) {
      if (std::abs(error.r_m - paper.at_m) > published.within_m) continue;
      if (!published.methods.empty() && !Contains(published.methods, error.method)) continue;
      ++found.sightings;
      if (IsWrong(error, published)) {
        ++found.wrong;
        continue;
      }
      r_m.push_back(std::abs(error.r_error_m));
      place_m.push_back(error.place_error_m);
      heading_rad.push_back(std::abs(error.heading_error_rad));
    }
    found.runs += found.sightings > before;
  }
  const MeanAndMedian r = Middle(r_m), place = Middle(place_m), heading = Middle(heading_rad);
  found.mean_r_m = r.mean;
  found.median_r_m = r.median;
  found.mean_place_m = place.mean;
  found.median_place_m = place.median;
  found.mean_heading_rad = heading.mean;
  found.median_heading_rad = heading.median;
  return found;
}

/// Where its campaign was not run, the first one's columns tell the unit.
MeasureFinding FindMeasure(const Published& published, const PublishedMeasure& measure,
                           const CampaignResults& results, const CampaignResults& first) {
  MeasureFinding found;
  found.measure = &measure;
  found.simulated = !results.rows.empty();
  for (const Column& column : SummedColumns(found.simulated ? results.columns : first.columns)) {
    if (column.name == measure.measure.text) found.unit = column.unit;
  }
  if (!found.simulated) return found;
  Rows rows;
  for (const RunResult& row : results.rows) {
    if (measure.counted && !Counts(published, row)) continue;
    if (Matches(measure.where, row, results.columns)) rows.push_back(&row);
  }
  const Spread spread = SpreadOf(results.columns, measure.measure.text, rows);
  found.runs = spread.count;
  found.mean = spread.mean;
  found.median = spread.median;
  found.low = spread.low;
  found.high = spread.high;
  return found;
}

/// CheckPublished holds that there is one of the name.
const CampaignResults& ResultsOf(const PublishedName& campaign, const Published& published,
                                 const std::vector<CampaignResults>& campaigns) {
  const auto at =
      std::find_if(published.campaigns.begin(), published.campaigns.end(),
                   [&](const PublishedCampaign& each) { return each.name == campaign.text; });
  return campaigns.at(static_cast<std::size_t>(at - published.campaigns.begin()));
}

ReproductionVerdict VerdictOf(const ReproductionFinding& found) {
  bool inside = true;
  for (const RowFinding& row : found.rows) {
    if (!row.counts) continue;
    if (!row.comparable()) return ReproductionVerdict::kNotJudged;
    inside = inside && row.inside();
  }
  for (const FailureFinding& each : found.failures) {
    if (!each.counts) continue;
    if (!each.comparable()) return ReproductionVerdict::kNotJudged;
    inside = inside && each.inside();
  }
  for (const MeasureFinding& each : found.measures) {
    if (!each.measure->judged) continue;
    if (!each.simulated) return ReproductionVerdict::kNotJudged;
    inside = inside && each.inside();
  }
  return inside ? ReproductionVerdict::kInside : ReproductionVerdict::kOutside;
}

}  // namespace

const char* NameOf(ReproductionVerdict verdict) {
  switch (verdict) {
    case ReproductionVerdict::kInside:
      return "inside";
    case ReproductionVerdict::kOutside:
      return "outside";
    case ReproductionVerdict::kNotJudged:
      break;
  }
  return "not judged";
}

bool Counts(const Published& published, const RunResult& row) {
  return IsNamed(published.counted, row.outcome);
}

bool Matches(const std::vector<LabelFilter>& where, const RunResult& row,
             const RowColumns& columns) {
  return std::all_of(where.begin(), where.end(), [&](const LabelFilter& filter) {
    return Contains(filter.texts, LabelOf(row, columns, filter.label.text));
  });
}

ReproductionFinding JudgeReproduction(const Published& published,
                                      const std::vector<CampaignResults>& campaigns) {
  const CampaignResults& first = campaigns.at(0);
  ReproductionFinding found;
  found.published = &published;
  found.replications = first.replications;
  found.runs = static_cast<int>(first.rows.size());
  for (std::size_t i = 0; i < published.rows.size(); ++i) {
    const std::optional<PublishedName>& campaign = published.rows[i].campaign;
    found.rows.push_back(
        FindRow(published, i, campaign ? ResultsOf(*campaign, published, campaigns) : first));
  }
  found.failures = FindFailures(published, first);
  for (const PublishedError& error : published.errors) {
    found.errors.push_back(FindError(error, published, first.sightings));
  }
  for (const PublishedMeasure& measure : published.measures) {
    found.measures.push_back(
        FindMeasure(published, measure, ResultsOf(measure.campaign, published, campaigns), first));
  }
  found.verdict = VerdictOf(found);
  return found;
}

}  // namespace dockyard
