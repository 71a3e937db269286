// A publication's classes of failures, and which of them each failure here belongs to.
#pragma once

#include <vector>

#include "sim/report/reproduction.h"

namespace dockyard {

bool IsNamed(const std::vector<PublishedName>& names, const std::string& text);

/// Whether a sighting is wrong by the publication's bounds.
bool IsWrong(const SightingError& error, const Published& published);

/// The classes in the order of the file, then the others; empty where the file has none. A failure
/// belongs to the first class with a case that holds.
std::vector<FailureFinding> FindFailures(const Published& published,
                                         const CampaignResults& results);

}  // namespace dockyard
