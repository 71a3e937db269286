// A study: one scenario run many times, with keys of it or of its models set to several values.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/scenario/scenario.h"

namespace dockyard {

/// A dotted key of the scenario (start.r_m, changes.soil.cohesion_pa, script) and the values that
/// it takes.
struct StudyFactor {
  std::string key;
  std::vector<std::string> labels;  // as shown; for numbers the numbers themselves
  std::vector<YamlNode> values;

  bool numeric() const;
};

/// A place in the grid of factors, and at most one key changed from there.
struct StudyPoint {
  std::vector<int> level;  // by factor: which of its values
  int changed = -1;        // index in one_at_a_time, -1: none
  int changed_level = -1;
  Scenario scenario;  // its seed is set per run
};

struct Study {
  std::string name;
  std::uint64_t seed = 1;
  int repeats = 1;                         // runs at each point
  std::vector<StudyFactor> factors;        // the grid
  std::vector<StudyFactor> one_at_a_time;  // each set alone, at every point of the grid
  std::string x, curves, panels;           // factors for the plot; may be empty
  std::vector<std::string> measures;       // columns to plot
  std::vector<StudyPoint> points;

  int grid_size() const;
};

/// The part of the systems that a study's reader needs.
struct StudySystems {
  std::vector<KnownSystem> known;
  /// The measures of a system's runs, by the system's name: a study can plot these.
  std::function<std::vector<std::string>(const std::string& system)> measures;
  /// Throws ConfigError for a scenario with faults that only its system sees. Called once for each
  /// set of models. Empty: nothing is checked.
  std::function<void(const Scenario&)> check;
};

/// `overrides` are as of LoadScenario, for keys of the study's file. Throws ConfigError, for every
/// point whose scenario or models are wrong too.
Study LoadStudy(const std::string& file, const std::vector<std::string>& overrides,
                const StudySystems& systems);

}  // namespace dockyard
