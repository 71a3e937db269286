// How the commands that end a campaign tell what it came to.
#pragma once

#include <filesystem>

#include "sim/app/invocation.h"
#include "sim/campaign/merge.h"

namespace dockyard {

/// Prints the summary, or its figures as a line of JSON, and how to replay failures. Returns the
/// exit code: 10 when runs are missing or were lost.
int ReportEnd(const CampaignEnd& end, const std::filesystem::path& dir, bool json,
              const Invocation& call);

}  // namespace dockyard
