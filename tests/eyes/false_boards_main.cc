// eyes_false_boards [views] [width] [jobs]: boards accepted on rendered views without one.
#include <cstdio>
#include <cstdlib>

#include "eyes/false_boards.h"

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int width = argc > 2 ? std::atoi(argv[2]) : 1024;
  const int jobs = argc > 3 ? std::atoi(argv[3]) : 1;
  if (count < 3 || width < 320 || jobs < 1) {
    std::fprintf(
        stderr, "eyes_false_boards [views, at least 3] [width, at least 320] [jobs, at least 1]\n");
    return 2;
  }
  const dockyard::FalseBoards seen = dockyard::LookWithoutBoard(count, width, jobs, true);
  std::printf(
      "%d stereo pairs without a board, %d px wide: %d discs detected; boards accepted by dockyard "
      "%d, by tsai2013 %d\n",
      seen.views, width, seen.discs, seen.accepted, seen.accepted_by_tsai2013);
  return seen.accepted == 0 ? 0 : 1;
}
