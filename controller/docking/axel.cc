#include "controller/docking/axel.h"

#include <utility>

#include "controller/docking/machine.h"

namespace dockyard {

std::unique_ptr<Controller> MakeAxelController(const RoverSheet& sheet, Locator locator) {
  if (!locator) {
    locator = [rig = sheet.rig, board = sheet.board, vision = sheet.vision](
                  const StereoImages& images, const LocateHints& hints) {
      return LocateBoard(images, rig, board, hints, vision);
    };
  }
  return MakeAxelMachine(sheet, AxelOptions{}, std::move(locator));
}

}  // namespace dockyard
