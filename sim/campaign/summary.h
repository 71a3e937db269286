// The result table of a campaign: rates with intervals by region, light and soil, failures by
// cause.
#pragma once

#include <map>
#include <string>

#include "sim/campaign/results.h"

namespace dockyard {

/// Plain text, lines under 100 columns; the same for the same rows. notes: by run number, a
/// sentence on what went wrong.
std::string SummaryText(const std::string& title, const FinishedRuns& runs, int total,
                        const std::map<int, std::string>& notes);

}  // namespace dockyard
