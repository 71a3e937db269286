// Curves of a design in a report: results over a factor that is a number.
#pragma once

#include "sim/base/json.h"
#include "sim/log/results.h"
#include "sim/plan/campaign.h"

namespace dockyard {

/// `curves` of the header: those that the campaign's `figures` ask for, and success over each
/// further factor of numbers that the campaign varies. Labels that are neither axis nor curve are
/// pooled. Runs with a key changed alone are left out.
Json CurvesPart(const Campaign& campaign, const FinishedRuns& runs, const RowColumns& columns);

}  // namespace dockyard
