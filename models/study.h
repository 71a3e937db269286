// A study: one scenario run many times, with keys of it or of its models set to several values.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "models/scenario.h"

namespace dockyard {

/// A key of the scenario (changes.station.cone.funnel_friction), or script, and the values that it
/// takes.
struct StudyFactor {
  std::string key;
  std::vector<std::string> labels;  // as shown; for numbers the numbers themselves
  std::vector<YamlNode> values;

  bool numeric() const;
};

/// What a scripted run's motors do for a while.
struct ScriptStep {
  double for_s = 0.0;
  double speed_m_s = 0.0, turn_rad_s = 0.0;  // of the axle's middle; wheels driven to match
  bool free_wheels = false;                  // instead of driven
  double reel_m_s = 0.0;                     // in is positive
  std::optional<double> tension_n;           // the winch's limit; none: the drive's own
};

/// A place in the grid of factors, and at most one key changed from there.
struct StudyPoint {
  std::vector<int> level;  // by factor: which of its values
  int changed = -1;        // index in one_at_a_time, -1: none
  int changed_level = -1;
  Scenario scenario;               // its seed is set per run
  std::vector<ScriptStep> script;  // empty: the scenario's controller drives
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

/// Throws ConfigError, for every point whose scenario or models are wrong too.
Study LoadStudy(const std::string& file, const std::vector<std::string>& overrides = {});

/// What a study can measure: the columns of its runs.csv.
const std::vector<std::string>& StudyMeasures();

}  // namespace dockyard
