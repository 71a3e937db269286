// A campaign that runs until a sequential test has decided (sim/statistics/sequential.h): which
// campaigns it can judge, and what it says. The test itself takes the results in the order of the
// runs' indices, with FollowRun, so the decision is the same for any number of processes. A crashed
// run counts as a failure.
#pragma once

#include <string>

#include "sim/base/json.h"
#include "sim/plan/campaign.h"
#include "sim/statistics/sequential.h"

namespace dockyard {

/// In a results folder: SequentialJson of the test that ended the campaign.
inline constexpr const char* kAcceptanceFile = "acceptance.json";

/// Why the test cannot judge this campaign; empty if it can. Its error rates hold for runs that are
/// drawn independently and alike. Points of a grid, rows of a table, values set alone, arms and
/// stratified designs are not.
std::string WhyNotSequential(const Campaign& campaign);

/// The aims, the verdict ("accepted", "not accepted", "undecided", or "not ended"), the counts, and
/// under `exact` the test's error rates and mean numbers of runs, for a system at either
/// reliability.
Json SequentialJson(const SequentialPlan& plan, const SequentialEnd& end);
/// The same in some lines for people.
std::string SequentialText(const SequentialPlan& plan, const SequentialEnd& end);

/// How many runs decided, by SequentialJson's text; 0: no decision, or the campaign went on past it
/// (WentOnText).
int DecidedRuns(const std::string& json_text);
/// The same text, noting that the campaign went on with all its runs; empty for other text.
std::string WentOnText(const std::string& json_text);

/// Whether SequentialJson's text is of a test with the same aims. A folder's runs are judged by the
/// aims that were set before the first run: other aims, chosen after a look, have other risks.
bool HasTheseAims(const std::string& json_text, const SequentialAims& aims);

}  // namespace dockyard
