// The keys of a board of square tags. Part of a board's file: load_board.h.
#pragma once

#include "controller/geometry/board.h"
#include "models/read/keys.h"

namespace dockyard {

/// Names the keys of the mapping `tags`. The tags' squares stay empty: SetTagCells.
void VisitTags(Keys& keys, std::vector<SquareTag>& tags);
/// Throws ConfigError when a tag sticks out, lacks its white margin, overlaps another, or when two
/// have one id.
/// @param in  of the mapping that has the key `tags`
void CheckTags(const YamlReader& in, const FiducialBoard& board);

}  // namespace dockyard
