// scenarios/*.yaml -> Scenario; and a scenario back to YAML with every default written
// out. docs/reference/scenarios.md lists the keys.
#pragma once

#include <string>
#include <vector>

#include "sim/scenario/scenario.h"

namespace dockyard {

/// `overrides` are "key.path=value" as of the option --set; a later one replaces an earlier one.
/// File names in them are relative to the working directory. The system checks its own part
/// (System::check). Throws ConfigError.
Scenario LoadScenario(const std::string& file, const std::vector<std::string>& overrides,
                      const std::vector<KnownSystem>& systems);

/// Everything, defaults included, with absolute paths; LoadScenario reads it back to the same
/// values, bit for bit, when angles came from degrees in a file.
std::string ResolvedYaml(const Scenario& scenario);
/// The same for a file that others get: a path below `dir` is relative to it, and of any other
/// absolute path the last name alone stays.
std::string YamlWithoutFolders(const Scenario& scenario, const std::string& dir);

}  // namespace dockyard
