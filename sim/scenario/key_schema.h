// The keys of a mapping as a JSON Schema (draft 2020-12), by which editors complete and check
// files.
#pragma once

#include "sim/base/json.h"
#include "sim/scenario/keys.h"

namespace dockyard {

/// {"type": "object", "properties": ..., "required": ..., "additionalProperties": false}: types,
/// ranges, words, defaults and meanings of the keys that the visitor names.
/// @param whole  required keys must be there
Json SchemaOfKeys(const Keys::Visit& visit, bool whole);

/// Of a model's file. One with a `base` may leave out all other keys.
Json SchemaOfModel(const Keys::Visit& visit);

/// Of a seed, which any 64 bits may be.
Json SeedSchema();

}  // namespace dockyard
