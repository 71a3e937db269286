#include "controller/axel/axel.h"

#include <utility>

#include "controller/axel/machine.h"
#include "controller/axel/options_for.h"

namespace dockyard::axel {

std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal, Locator locator) {
  if (!locator) {
    locator = [rig = nominal.rig, board = nominal.board, vision = nominal.vision](
                  const StereoImages& images, const LocateHints& hints) {
      return LocateBoard(images, rig, board, hints, vision);
    };
  }
  return MakeAxelMachine(nominal, OptionsFor(nominal), std::move(locator));
}

}  // namespace dockyard::axel
