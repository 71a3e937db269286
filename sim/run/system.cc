#include "sim/run/system.h"

#include <algorithm>

#include "models/read/config_error.h"
#include "sim/bridge/pipe_controller.h"

namespace dockyard {
namespace {

std::string Joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace

RowColumns System::Columns(std::vector<std::string> labels) const {
  RowColumns columns{std::move(labels), measures, outcomes};
  columns.outcomes.push_back(
      {kControllerCrashed, false, "the controller's program ended before the run did"});
  columns.outcomes.push_back(
      {kControllerTimeout, false, "the controller's program gave no answer in time"});
  columns.outcomes.push_back(
      {kControllerError, false, "the controller's program sent an invalid answer"});
  columns.outcomes.push_back({kCrashed, false, "the run's process died by its own fault"});
  columns.outcomes.push_back(
      {kStopped, false, "a limit, or somebody else, ended the run's process"});
  return columns;
}

const ControllerEntry& System::RequireController(const std::string& controller) const {
  std::vector<std::string> known;
  for (const ControllerEntry& entry : controllers) {
    if (entry.name == controller) return entry;
    known.push_back(entry.name);
  }
  throw ConfigError("controller: expected one of " + Joined(known) + ", found '" + controller +
                    "'");
}

const System& FindSystem(const std::vector<System>& systems, const std::string& name) {
  std::vector<std::string> known;
  for (const System& system : systems) {
    if (system.name == name) return system;
    known.push_back(system.name);
  }
  throw ConfigError("system: expected one of " + Joined(known) + ", found '" + name + "'");
}

std::vector<KnownSystem> KnownSystems(const std::vector<System>& systems) {
  std::vector<KnownSystem> known;
  for (const System& system : systems) {
    known.push_back({system.name,
                     {},
                     system.file_keys,
                     system.changes_file_keys,
                     system.model_roots,
                     system.spoiled_pictures,
                     system.rocks,
                     system.former_controllers,
                     system.start});
    for (const ControllerEntry& entry : system.controllers) {
      known.back().controllers.push_back(entry.name);
    }
  }
  return known;
}

}  // namespace dockyard
