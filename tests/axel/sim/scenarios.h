// Scenarios of Axel for tests: the typical docking with keys on top.
#pragma once

#include <string>
#include <vector>

#include "sim/app/systems.h"
#include "sim/axel/build_run.h"
#include "sim/run/loop.h"
#include "sim/scenario/load_scenario.h"
#include "support/source_tree.h"

namespace dockyard::axel {

inline Scenario TypicalScenario(const std::vector<std::string>& overrides = {}) {
  return LoadScenario(SourceFile("scenarios/axel_typical.yaml"), overrides,
                      KnownSystems(Systems()));
}

inline BuiltRun Build(const Scenario& scenario) { return BuildRun(scenario, LoadModels(scenario)); }

inline CampaignRun RunOf(const Scenario& scenario) {
  CampaignRun run;
  run.scenario = scenario;
  return run;
}

/// The typical docking in closed loop, with keys on top.
inline RunRecord SimulateTypical(const std::vector<std::string>& overrides,
                                 const RunOptions& options = {}) {
  const std::vector<System> systems = Systems();
  return Simulate(systems.front(), RunOf(TypicalScenario(overrides)), options);
}

/// A measure of a run by its name.
inline double MeasureOf(const RunRecord& record, const std::string& name) {
  for (std::size_t i = 0; i < record.columns.measures.size(); ++i) {
    if (record.columns.measures[i].name == name) return record.result.measures[i];
  }
  return std::nan("");
}

}  // namespace dockyard::axel
