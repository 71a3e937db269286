// The black squares of a tag as polygons.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/board.h"

namespace dockyard {

/// A polygon along the squares' sides, in squares from the top left of all that is printed.
struct TagOutline {
  std::vector<Eigen::Vector2i> corners;
  bool black = true;  // else a white hole
};

/// Painted one after the other they give the tag. Squares that touch at a corner alone belong to
/// two outlines.
std::vector<TagOutline> OutlinesOf(const TagCells& cells);

}  // namespace dockyard
