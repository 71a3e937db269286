// What a reproduction reads from its results folders, and the figures that it writes.
#pragma once

#include <filesystem>
#include <vector>

#include "sim/app/invocation.h"
#include "sim/app/kept_campaign.h"
#include "sim/plan/published.h"
#include "sim/report/reproduction.h"
#include "sim/run/system.h"

namespace dockyard {

/// For CheckPublished.
CampaignNames NamesOf(const Campaign& campaign, const std::vector<System>& systems);

/// How many runs the campaign's file has at each point: those of one replication. 1 but for a
/// campaign whose runs are drawn.
int RunsOfOne(const PublishedCampaign& campaign, const std::vector<System>& systems);

/// The campaigns of the file, each from the folder of its name; without rows where that is missing.
/// Throws ConfigError, ResultsError, IoError.
std::vector<CampaignResults> ReadReproduced(const Published& published,
                                            const std::filesystem::path& dir,
                                            const std::vector<System>& systems);

/// Writes figures/*.svg of the first campaign's runs, and returns a line for each figure: what it
/// shows, or why it is missing. Throws as ReadReproduced, and DataError for a damaged log.
std::vector<std::string> WriteFigures(const Published& published, const std::filesystem::path& dir,
                                      const Invocation& call);

}  // namespace dockyard
