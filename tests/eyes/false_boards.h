// Views of the yard without a board, and how many boards perception accepts in them.
#pragma once

namespace dockyard {

struct FalseBoards {
  int views = 0;  // stereo pairs
  int discs = 0;  // detections in them
  int accepted = 0;
  int accepted_by_tsai2013 = 0;
};

/// Looks 0 to count - 1 of the yard, its station without the board, from everywhere about it; the
/// three kinds of light in turns.
FalseBoards LookWithoutBoard(int count, int width, int jobs, bool with_tsai2013);

}  // namespace dockyard
