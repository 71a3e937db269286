// A reproduced experiment beside its publication: rates, causes, errors and measures, judged.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "sim/log/record.h"
#include "sim/plan/published.h"
#include "sim/statistics/intervals.h"
#include "sim/statistics/prediction.h"

namespace dockyard {

/// An accepted sighting against the truth.
struct SightingError {
  double r_m = 0.0;                // true distance from the target
  double r_error_m = 0.0;          // measured less true
  double place_error_m = 0.0;      // of the robot's place in the target's frame, >= 0
  double heading_error_rad = 0.0;  // measured less true, -pi to pi
  std::string method;              // as the report names it
};
/// Those of a run in order of time, by the run's number. A run whose log is not kept is left out.
using SightingErrors = std::map<int, std::vector<SightingError>>;

/// The results of one of the campaigns.
struct CampaignResults {
  std::vector<RunResult> rows;
  RowColumns columns;
  int replications = 1;
  SightingErrors sightings;
};

/// The paper's count against the runs that are truly successes; it is shown and does not count.
struct StrictFinding {
  int successes = 0;
  CountInterval at_95;  // of the paper's count
  double p = 1.0;       // PredictionP
};

struct RowFinding {
  const PublishedRow* row = nullptr;
  int successes = 0, runs = 0;
  std::optional<StrictFinding> strict;  // where the file has `strict` and the row no outcomes
  int lacking = 0;           // runs of the row that this campaign does not have (or has beyond it)
  double confidence = 0.95;  // at which it is judged; else 0.95
  CountInterval at_95, judged_at;  // of the paper's count
  double p = 1.0;                  // PredictionP
  bool counts = false;             // for the verdict
  /// Whether the paper's count can be held against these runs.
  bool comparable() const { return row->paper && runs > 0 && lacking == 0; }
  bool inside() const { return judged_at.Holds(row->paper->count); }
};

struct FailureFinding {
  std::string name, says;
  std::optional<PublishedCount> paper;
  int count = 0, runs = 0;
  // Of the paper's count, where the runs are those of the paper.
  std::optional<CountInterval> at_95{};
  bool counts = false;       // for the verdict
  double confidence = 0.95;  // at which it is judged; else 0.95
  CountInterval judged_at{};
  double p = 1.0;  // PredictionP
  bool comparable() const { return at_95.has_value(); }
  bool inside() const { return judged_at.Holds(paper->count); }
};

struct ErrorFinding {
  PublishedError paper;
  int sightings = 0, runs = 0;
  int wrong = 0;                            // of the sightings; the means leave them out
  double mean_r_m = 0.0, median_r_m = 0.0;  // of the errors' absolute values
  double mean_place_m = 0.0, median_place_m = 0.0;
  double mean_heading_rad = 0.0, median_heading_rad = 0.0;
};

struct MeasureFinding {
  const PublishedMeasure* measure = nullptr;
  std::string unit;
  bool simulated = false;                                  // whether its campaign was run
  int runs = 0;                                            // that have the measure
  double mean = 0.0, median = 0.0, low = 0.0, high = 0.0;  // 10 and 90 % quantiles

  bool inside() const { return runs > 0 && mean >= measure->low && mean <= measure->high; }
};

enum class ReproductionVerdict { kInside, kOutside, kNotJudged };
const char* NameOf(ReproductionVerdict verdict);  // "inside", "outside", "not judged"

/// What a reproduction came to. It points into the Published, which must live as long.
struct ReproductionFinding {
  const Published* published = nullptr;
  int replications = 1, runs = 0;
  std::vector<RowFinding> rows;          // as in the file
  std::vector<FailureFinding> failures;  // as in the file, then the others
  std::vector<ErrorFinding> errors;
  std::vector<MeasureFinding> measures;
  ReproductionVerdict verdict = ReproductionVerdict::kNotJudged;
};

/// Whether the outcome counts as the publication's success.
bool Counts(const Published& published, const RunResult& row);
/// Whether all filters hold.
bool Matches(const std::vector<LabelFilter>& where, const RunResult& row,
             const RowColumns& columns);

/// The total is judged at 0.95, each of the m rows that count at 1 - 0.05 / m (Bonferroni), and
/// each of the k classes of failures that count at 1 - 0.05 / k: outside when the paper's count
/// lies outside its exact prediction interval. A measure that is judged is
/// outside when its mean is, or when no run has it. Not judged unless each of
/// these rows and classes has all its runs, the paper's starts, each once a replication.
/// @param campaigns  as in the file; without rows: not run
ReproductionFinding JudgeReproduction(const Published& published,
                                      const std::vector<CampaignResults>& campaigns);

}  // namespace dockyard
