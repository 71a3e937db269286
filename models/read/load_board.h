// A fiducial board from a file of its own, or from a mapping in another.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/board.h"
#include "models/parts/board_cutout.h"
#include "models/read/yaml_reader.h"

namespace dockyard {

/// Keys of a board's mapping; a station's board has more.
std::vector<std::string> BoardKeys(std::vector<std::string> more);

/// The board that the mapping describes (docs/reference/models.md). Throws ConfigError, also when a
/// disc overlaps another or sticks out, or when the layout leaves a mark's identity open.
FiducialBoard ReadBoard(const YamlReader& in);

/// Whether the root has a board's keys and not a station's.
bool IsBoardFile(const YamlNode& root);

struct NamedBoard {
  std::string name;
  FiducialBoard board;
  std::optional<BoardCutout> cutout{};  // none for a board of its own file
  double flatness_m = 0.0;              // how far the print may lie off a plane; 0 for a target's
};
/// A board's file. Throws ConfigError.
NamedBoard LoadBoard(const std::string& file);

}  // namespace dockyard
