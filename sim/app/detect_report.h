// Answers of the command detect on one image or a pair: JSON, and lines for people.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/io/belief.h"
#include "sim/base/json.h"

namespace dockyard {

/// What a board has on it, and how many.
struct BoardMarks {
  std::size_t count = 0;
  std::string noun = "disc";  // or "tag"
};
BoardMarks MarksOf(const FiducialBoard& board);

struct DetectAnswer {
  SightingReport report;
  std::string detail;  // more about why there is no board; empty: nothing
  std::string pipeline;
  BoardMarks board_marks;
  std::array<std::string, 2> cameras{"left", "right"};  // names, by SightingReport::Mark::camera
};

/// Discs or tags of the board that were measured, in all images.
std::size_t NamedDiscs(const SightingReport& report);

/// "43 of the board's 44 discs", or before they have names "116 discs in the image".
std::string DiscsText(const SightingReport& report, const BoardMarks& board);

Json DetectJson(const DetectAnswer& answer, const std::vector<std::string>& warnings);
void PrintDetectText(const DetectAnswer& answer);

}  // namespace dockyard
