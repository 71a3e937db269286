// A scenario's file as a JSON Schema, from the keys that its reader reads (scenario_keys.h).
#pragma once

#include <vector>

#include "sim/base/json.h"
#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// A system with the keys under its own name; without a visitor they stay open.
struct SystemKeys {
  KnownSystem known;
  Keys::Visit visit;
};

/// @param whole  false: keys on top of another scenario, of which none is required
Json ScenarioSchema(const std::vector<SystemKeys>& systems, bool whole);

/// The first keys of a complete schema: dialect, title and the rest of `schema`.
Json SchemaDocument(const std::string& title, const Json& schema);

}  // namespace dockyard
