// eyes_false_boards [views] [width]: boards accepted on rendered views without one.
#include <cstdio>
#include <cstdlib>

#include "eyes/false_boards.h"

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 1000;
  const int width = argc > 2 ? std::atoi(argv[2]) : 1024;
  if (count < 1 || width < 320) {
    std::fprintf(stderr, "eyes_false_boards [views, at least 1] [width, at least 320]\n");
    return 2;
  }
  const dockyard::FalseBoards seen = dockyard::LookWithoutBoard(0, count, width, {});
  std::printf(
      "%d stereo pairs without a board, %d px wide: %d discs detected, %d boards accepted\n",
      seen.views, width, seen.discs, seen.accepted);
  return seen.accepted == 0 ? 0 : 1;
}
