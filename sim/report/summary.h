// The result table of a campaign: rates with intervals by label, failures by cause, a line per run.
#pragma once

#include <string>

#include "sim/log/results.h"

namespace dockyard {

/// Plain text, the same for the same rows. A label with 2 to 8 values, of two runs each on average,
/// has a line for each, in the order in which they appear. The table of runs has the labels that
/// differ between runs, the outcome and the headline measures; its lines stay under 100 columns
/// where the labels allow. The rate in the first line is of the runs in which no key was changed
/// alone.
/// @param total   runs of the whole campaign
/// @param enough  a sequential test needed no more runs
std::string SummaryText(const std::string& title, const FinishedRuns& runs,
                        const RowColumns& columns, std::int64_t total, bool enough = false);

}  // namespace dockyard
