// The progress of a campaign that other programs run, from its results folder.
#pragma once

#include <filesystem>

#include "sim/app/invocation.h"

namespace dockyard {

/// Prints a line whenever runs have ended, until all have, or a signal. Returns the exit code.
/// Throws UsageError for a folder without a campaign, ConfigError, ResultsError and IoError.
int WatchCampaign(const std::filesystem::path& dir, bool json, const Invocation& call);

}  // namespace dockyard
