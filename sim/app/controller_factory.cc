#include "sim/app/controller_factory.h"

#include "controller/docking/axel.h"
#include "models/config_error.h"

namespace dockyard {

std::unique_ptr<Controller> MakeController(const std::string& name, const RoverSheet& sheet) {
  if (name == "axel") return MakeAxelController(sheet);
  if (name == "reel_only") return MakeReelOnlyController(sheet);
  throw ConfigError("controller: expected axel or reel_only, found '" + name + "'");
}

}  // namespace dockyard
