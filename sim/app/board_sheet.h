// The drawing of a fiducial board on paper.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/read/load_board.h"
#include "sim/app/drawing.h"

namespace dockyard {

/// Names of papers, a0 to a4 and letter.
std::vector<std::string> PaperNames();

/// The board with its outline to cut along, and below it its name, its size and a rule of 100 mm.
/// @param paper  one of PaperNames, upright or sideways; none: a page as large as the board needs
/// @param tile   on as many papers as needed, to be cut along their frames and laid edge to edge
/// @throws UsageError when the board does not fit on the paper
std::vector<Page> BoardPages(const NamedBoard& named, const std::optional<std::string>& paper,
                             bool tile);

}  // namespace dockyard
