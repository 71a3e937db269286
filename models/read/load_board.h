// A fiducial board from a file of its own, or from a mapping in another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/board.h"
#include "models/parts/board_cutout.h"
#include "models/read/keys.h"

namespace dockyard {

/// Names the keys of a board of discs as a mapping (docs/reference/models.md); a station's board
/// has more.
void VisitBoard(Keys& keys, FiducialBoard& board);
/// Throws ConfigError when a disc overlaps another or sticks out, or when the layout leaves a
/// mark's identity open.
void CheckBoard(const YamlReader& in, const FiducialBoard& board);

/// Whether the root has a board's keys and not a station's.
bool IsBoardFile(const YamlNode& root);

struct NamedBoard {
  std::string name;
  FiducialBoard board;                  // of discs or of tags
  std::optional<BoardCutout> cutout{};  // none for a board of its own file
  double flatness_m = 0.0;              // how far the print may lie off a plane; 0 for a target's
};
/// Names every key of a board's file.
void VisitNamedBoard(Keys& keys, NamedBoard& named);
/// A board's file. Throws ConfigError.
NamedBoard LoadBoard(const std::string& file);

}  // namespace dockyard
