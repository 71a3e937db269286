// perception_false_boards [views] [width] [jobs] [views for tsai2013]: boards accepted on rendered
// views without one.
#include <cstdio>
#include <cstdlib>

#include "perception/false_boards.h"

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int width = argc > 2 ? std::atoi(argv[2]) : 1024;
  const int jobs = argc > 3 ? std::atoi(argv[3]) : 1;
  const int tsai_count = argc > 4 ? std::atoi(argv[4]) : 0;
  if (count < 3 || width < 320 || jobs < 1) {
    std::fprintf(stderr,
                 "perception_false_boards [views, at least 3] [width, at least 320] "
                 "[jobs, at least 1] [views for tsai2013]\n");
    return 2;
  }
  const dockyard::axel::FalseBoards seen =
      dockyard::axel::LookWithoutBoard(count, width, jobs, tsai_count);
  std::printf(
      "%d stereo pairs without a board, %d px wide: %d discs detected, %d boards accepted; by "
      "tsai2013 "
      "%d of %d\n",
      seen.views, width, seen.discs, seen.accepted, seen.tsai2013_accepted, seen.tsai2013_views);
  return seen.accepted == 0 ? 0 : 1;
}
