// The record of one run: its result row, its history for plots, its log.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "controller/io/belief.h"
#include "sim/log/column.h"
#include "sim/log/judged_limit.h"
#include "sim/log/named_sensor.h"

namespace dockyard {

/// One row of results.csv. RowColumns names the labels and measures.
struct RunResult {
  int run = 0;
  std::uint64_t seed = 0;
  std::string system, controller;
  std::vector<std::string> labels;  // as the campaign's table has them
  bool success = false;             // whether the outcome is a success of this system
  std::string success_word;         // outcome that its task asks for: "docked"; empty: lost run
  std::string outcome = kCrashed;
  double sim_time_s = 0.0;
  int images = 0;                // images that the controller was given, all cameras together
  std::vector<double> measures;  // empty for a run that was lost
  std::uint64_t state_hash = 0;  // written as 16 hex digits
  bool former = false;           // read from RowColumns::former: word and margins are not known
};

/// Timing, which differs from machine to machine.
struct RunTiming {
  double cpu_time_s = 0.0, wall_time_s = 0.0;
  double controller_cpu_s = 0.0, controller_wall_s = 0.0;  // of a program; 0 without one
};

/// One sample of the truth and of the controller's beliefs, every 0.1 s and at the end, for plots.
struct HistorySample {
  double time_s = 0.0;
  RobotPose X_DR;                // truth
  std::vector<double> channels;  // truth, by StatedColumns::channels
  std::vector<double> sensed;    // by RunRecord::sensors, as the controller got them last
  std::string phase;             // belief
  bool located = false;
  RobotPose X_DR_believed;
  int sighting_count = 0, plan_count = 0;
  std::vector<double> beliefs;  // by StatedColumns::beliefs
  std::vector<double> values;   // belief, by RunRecord::value_names; shorter before a name came
};

/// A sighting of the target: the robot's true pose and the controller's measurement.
struct SightingSample {
  double time_s = 0.0;
  RobotPose X_DR;  // truth
  SightingReport report;
  RobotPose X_DR_measured;  // from the report; meaningful when accepted
};

struct PlanSample {
  double time_s = 0.0;
  std::vector<PlannedArc> arcs;
};

struct RunRecord {
  RunResult result;
  RunTiming timing;
  RowColumns columns;                            // of the result
  std::vector<Column> channels, belief_columns;  // of the history's samples
  std::vector<NamedSensor> sensors;
  std::vector<std::string> value_names;  // of values that the system does not name
  std::vector<HistorySample> history;
  std::vector<SightingSample> sightings;
  std::vector<PlanSample> plans;
  std::string failure_note;         // a sentence on the truth, for people
  std::vector<JudgedLimit> limits;  // of the judge
  std::string messages;             // a controller program's output on its standard error
};

}  // namespace dockyard
