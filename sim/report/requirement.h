// Requirements on a campaign's results, for continuous integration:
//
//   success >= 0.9                        the share of all runs that succeeded; also as `docked`
//   success[arm=ours, soil=loose] >= 0.9  of the runs with these labels
//   success.lower95 >= 0.9                its lower bound at 95 %, one-sided (Clopper and Pearson)
//   outcome.crashed <= 0                  the share of one outcome; .lower95, .upper95 as above
//   tip_depth_m.p90 <= 0.2                a measure: .mean, .min, .median, .max, .p and per cent
//   margin.seat_m.min >= 0                a limit's margin, likewise
//
// Spaces may stand between the parts. The relations are >=, >, <= and <.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "controller/base/result.h"
#include "sim/log/record.h"
#include "sim/plan/campaign.h"

namespace dockyard {

struct Requirement {
  enum class Statistic { kShare, kLower, kUpper, kMean, kQuantile };
  enum class Relation { kAtLeast, kAbove, kAtMost, kBelow };

  std::string text;      // as written
  std::string figure;    // "success", a measure's name, or an outcome's
  bool outcome = false;  // the figure is an outcome's share
  std::vector<std::pair<std::string, std::string>> where;  // label and its text
  Statistic statistic = Statistic::kShare;
  double level = 0.0;  // of kLower and kUpper the confidence, of kQuantile the share
  Relation relation = Relation::kAtLeast;
  double limit = 0.0;
};

/// The requirement, or a sentence that says what is known and what was found.
/// @param columns   of the results that will be judged
/// @param campaign  tells the texts that a label can have, where the file fixes them
Result<Requirement, std::string> ParseRequirement(const std::string& text,
                                                  const RowColumns& columns,
                                                  const Campaign& campaign);

/// What became of a requirement.
struct Judgement {
  Requirement requirement;
  bool met = false;
  int count = 0;       // runs that the figure was computed from
  double found = 0.0;  // NaN when there are none; then the requirement is not met
  std::string text;    // "met: success >= 0.9, found 0.95 (19/20)"
};

/// A run that was lost has not succeeded, and has no measure. A measure that is NaN is left out.
Judgement Judge(const Requirement& requirement, const RowColumns& columns,
                const std::vector<RunResult>& rows);

}  // namespace dockyard
