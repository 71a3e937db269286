// Views of the yard without a board, and how many boards perception accepts in them.
#pragma once

namespace dockyard::axel {

struct FalseBoards {
  int views = 0;  // stereo pairs
  int discs = 0;  // detections in them
  int accepted = 0;
  int tsai2013_views = 0, tsai2013_accepted = 0;
};

/// Image pairs 0 to count - 1 of the yard, with no board on its station, from everywhere about it;
/// the three kinds of light in turns. The first tsai_count are shown to tsai2013 too, which is
/// slow.
FalseBoards LookWithoutBoard(int count, int width, int jobs, int tsai_count);

}  // namespace dockyard::axel
