// The words `assumed` and `tolerance` in place of a distribution.
#pragma once

#include <vector>

#include "sim/plan/campaign.h"

namespace dockyard {

/// Writes the distributions of the model files into the campaign's tree, in place of words:
///   changes.KEY: assumed      what the model may be: built so, and the controller is told
///   as_built.KEY: tolerance   what is built against that: KEY.times or KEY.plus is drawn
/// KEY may also be the head of keys, down to none at all: each key below it that has such a spread
/// and that nothing else in the file sets. The campaign's base, arms, table and factors must have
/// been read. Throws ConfigError.
void WriteSpreads(Campaign& campaign, const std::vector<KnownSystem>& systems);

}  // namespace dockyard
