// The codes of square tags: which families there are, and the black squares of each tag as printed.
// AprilTag's families are those of libapriltag, ArUco's those of OpenCV.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/board.h"

namespace dockyard {

/// A family of tags. All its tags have the same number of squares.
struct TagFamily {
  std::string name;
  bool aruco = false;  // OpenCV finds it, else libapriltag
  int ids = 0;         // 0 to ids - 1
  int across = 0;      // TagCells::across, at_border, margin
  int at_border = 0;
  int margin = 0;
};

/// "tag36h11", ..., "aruco_4x4_50", ..., "aruco_original".
std::vector<std::string> TagFamilyNames();
/// None for a name that is not in TagFamilyNames.
std::optional<TagFamily> TagFamilyNamed(const std::string& name);

/// The tags of these ids as printed, the ring of white that detection needs included. A family
/// of the kind tagStandard needs none: it has data around its border.
std::vector<TagCells> CellsOf(const TagFamily& family, const std::vector<int>& ids);
/// Sets the squares of all the board's tags. Each has a known family and an id of it.
void SetTagCells(FiducialBoard& board);

}  // namespace dockyard
