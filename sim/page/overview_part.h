// What a campaign came to, in numbers: the head of a report, and the report as JSON.
#pragma once

#include <optional>
#include <vector>

#include "sim/base/json.h"
#include "sim/log/results.h"
#include "sim/plan/campaign.h"
#include "sim/report/requirement.h"

namespace dockyard {

/// A reliability to be shown, as of the command `accept`.
struct AcceptanceAim {
  double reliability = 0.0, confidence = 0.95;
};

/// `totals`, `groups`, `causes`, `sensitivity`, `arms`, `curves`, `acceptance`, `requirements` and
/// `aims` of the header (docs/reference/report_payload.md). Intervals are exact, 95 %.
/// @param campaign  none: these are single runs
Json OverviewPart(const Campaign* campaign, const FinishedRuns& runs, const RowColumns& columns,
                  const std::optional<AcceptanceAim>& aim,
                  const std::vector<Requirement>& requirements = {});

}  // namespace dockyard
