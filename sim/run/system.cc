#include "sim/run/system.h"

#include <algorithm>

#include "models/read/config_error.h"
#include "sim/base/text.h"
#include "sim/bridge/pipe_controller.h"

namespace dockyard {

RowColumns System::Columns(std::vector<std::string> labels) const {
  RowColumns row{std::move(labels), columns.measures, columns.outcomes, false};
  row.outcomes.push_back(
      {kControllerCrashed, false, "the controller's program ended before the run did"});
  row.outcomes.push_back(
      {kControllerTimeout, false, "the controller's program gave no answer in time"});
  row.outcomes.push_back(
      {kControllerError, false, "the controller's program sent an invalid answer"});
  row.outcomes.push_back({kCrashed, false, "the run's process died by its own fault"});
  row.outcomes.push_back({kStopped, false, "a limit, or somebody else, ended the run's process"});
  return row;
}

const ControllerEntry& System::RequireController(const std::string& controller) const {
  std::vector<std::string> known;
  for (const ControllerEntry& entry : controllers) {
    if (entry.name == controller) return entry;
    known.push_back(entry.name);
  }
  throw ConfigError("controller: expected one of " + Listed(known) + ", found '" + controller +
                    "'");
}

const System& FindSystem(const std::vector<System>& systems, const std::string& name) {
  std::vector<std::string> known;
  for (const System& system : systems) {
    if (system.name == name) return system;
    known.push_back(system.name);
  }
  throw ConfigError("system: expected one of " + Listed(known) + ", found '" + name + "'");
}

std::vector<KnownSystem> KnownSystems(const std::vector<System>& systems) {
  std::vector<KnownSystem> known;
  for (const System& system : systems) {
    KnownSystem& each = known.emplace_back(system.scenario);
    each.name = system.name;
    for (const ControllerEntry& entry : system.controllers) {
      each.controllers.push_back(entry.name);
      if (entry.former_name.empty()) continue;
      each.former_controllers.push_back({entry.former_name, entry.name});
    }
  }
  return known;
}

}  // namespace dockyard
