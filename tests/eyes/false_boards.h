// Views of the yard without a board, and how many boards perception accepts in them.
#pragma once

#include "controller/io/vision_settings.h"

namespace dockyard {

struct FalseBoards {
  int views = 0;  // stereo pairs
  int discs = 0;  // detections in them
  int accepted = 0;
};

/// Looks first, first + 1, ... of the yard, its station without the board, from everywhere about
/// it; the three kinds of light in turns.
FalseBoards LookWithoutBoard(int first, int count, int width, const VisionSettings& settings);

}  // namespace dockyard
