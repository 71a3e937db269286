// The keys of a scenario: every one stated once, with its range, unit and meaning.
#pragma once

#include <string>
#include <vector>

#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// Names every key of a scenario that may be of one of these systems. The system's own keys stay a
/// tree; its own visitor names them. `scenario.system` decides which system's mapping is allowed,
/// and which values `controller` may have.
void VisitScenario(Keys& keys, Scenario& scenario, const std::vector<KnownSystem>& systems);

/// A whole scenario from a tree, checked but for what its system checks. File names in the system's
/// mapping and in `changes` become absolute, as KnownSystem says. Throws ConfigError.
Scenario ReadScenario(const YamlNode& root, const std::vector<KnownSystem>& systems);

/// Every key with its value, defaults included; ReadScenario reads it back to the same scenario.
YamlNode WriteScenario(const Scenario& scenario);

/// Dotted keys whose values differ, those of the system and of `changes` too.
std::vector<std::string> DifferingKeys(const Scenario& a, const Scenario& b);

/// All that the system's own check may use, as text: scenarios with equal texts differ in name,
/// seed and start alone.
std::string ModelText(const Scenario& scenario);

/// The rows of the reference page: `<system>` stands for the system's name.
std::vector<KeyRow> ScenarioRows();

const std::vector<std::string>& LightWords();

}  // namespace dockyard
