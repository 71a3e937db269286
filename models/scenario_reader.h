// The keys of a scenario, shared by scenario files and the base of a campaign.
#pragma once

#include <string>
#include <vector>

#include "models/scenario.h"
#include "models/yaml_reader.h"

namespace dockyard {

/// A whole scenario needs name, soil and start; in a campaign's base the runs bring them.
enum class ScenarioPart { kWhole, kBase };
Scenario ReadScenario(const YamlNode& node, const std::string& path, ScenarioPart part);

/// Throws ConfigError unless the start lies inside the yard, 1 m from its border.
void CheckStartInYard(const Scenario& scenario, const YamlReader& start);

/// r_m, alpha_deg and heading_deg of a mapping that has them.
StartPose ReadStart(const YamlReader& in);
const std::vector<std::string>& LightWords();

}  // namespace dockyard
