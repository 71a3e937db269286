#include "controller/custom/sighting.h"

namespace dockyard::custom {

// TODO: find tags in the image, then both poses of each board of tags.
Result<Perceive, Refusal> PerceiveTags(const Nominal& nominal) {
  std::string names;
  for (const DockBoard& board : nominal.boards) {
    if (board.board.fiducials.empty()) names += (names.empty() ? "" : ", ") + board.name;
  }
  return Refusal{"board " + names + ": it has no discs, and tags are not detected yet"};
}

}  // namespace dockyard::custom
