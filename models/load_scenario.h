// scenarios/*.yaml -> Scenario and Campaign; and back to YAML with every default written out.
#pragma once

#include <string>
#include <vector>

#include "models/rover_model.h"
#include "models/scenario.h"
#include "models/soil_model.h"
#include "models/station_model.h"

namespace dockyard {

/// `overrides` are "key.path=value" as of the option --set, later ones on top of earlier ones; file
/// names in them are taken from the working directory. Throws ConfigError.
Scenario LoadScenario(const std::string& file, const std::vector<std::string>& overrides = {});

/// A campaign: a base scenario and a table of runs (a CSV file, or a list in the file itself). The
/// seed of each run is RunSeed(campaign seed, run). Overrides as above, for keys of the campaign
/// file. Throws ConfigError.
Campaign LoadCampaign(const std::string& file, const std::vector<std::string>& overrides = {});

/// Runs in a campaign's table (CSV), all of it checked but the soils' names, which the campaign's
/// file gives a meaning, and whether the starts lie in its yard. Throws ConfigError.
int CheckCampaignTable(const std::string& file);

/// Everything, defaults included, with absolute paths; LoadScenario and LoadCampaign read it back
/// to the same values, bit for bit, when angles came from degrees in a file.
std::string ResolvedYaml(const Scenario& scenario);
std::string ResolvedYaml(const Campaign& campaign);

/// The models that a scenario names, its tip angle applied and checked against each other.
struct ScenarioModels {
  RoverModel rover;
  StationModel station;
  SoilModel soil;
};
ScenarioModels LoadModels(const Scenario& scenario);

}  // namespace dockyard
