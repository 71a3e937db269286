// The keys of a scenario under `rocks`: a field of rocks, and given ones.
#pragma once

#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

void VisitRocks(Keys& keys, Scenario& scenario);

/// Reads `rocks.given` into the scenario's field and checks the keys against each other and the
/// yard. Throws ConfigError.
void ReadRocks(Scenario& scenario, const YamlNode& root, const KnownSystem& system);

/// Whether there is any rock.
bool HasRocks(const RockField& rocks);

}  // namespace dockyard
