// Success by the values of each setting, in a report.
#pragma once

#include "sim/base/json.h"
#include "sim/log/results.h"
#include "sim/plan/campaign.h"

namespace dockyard {

/// Counts with their exact 95 % interval.
Json ShareJson(int successes, int runs);

/// `groups` of the header: an entry for each label with a few values. Drawn numbers are no
/// settings: each run has its own; nor are the numbers of points and repeats. Numbers rise; words
/// keep the order in which they appear.
/// @param campaign  none: these are single runs
Json GroupsPart(const Campaign* campaign, const FinishedRuns& runs, const RowColumns& columns);

}  // namespace dockyard
