// What is kept of one run: its result row, its history for plots, its log.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "controller/io/belief.h"
#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "models/station_model.h"

namespace dockyard {

/// The tip counts as home from this deep on: of the 0.25 m commanded (Tsai et al., II).
inline constexpr double kDockedDepth_m = 0.20;

/// How a run ended. The order is the order of the table in docs/outcomes.md.
enum class Outcome {
  kDocked,
  kNoDetection,
  kWrongCorrespondence,
  kPoseRejected,
  kMissedCone,
  kFaceCatch,
  kJammed,
  kRecoveryLimit,
  kTetherOverload,
  kTippedOver,
  kFalseDocked,
  kTimeout,
  kCrashed,
};
const char* Name(Outcome outcome);  // "docked", "no_detection", ...
std::optional<Outcome> OutcomeFromName(const std::string& name);

/// One row of results.csv, in this order.
struct RunResult {
  int run = 0;
  std::uint64_t seed = 0;
  std::string controller, region;
  int day = 0;
  std::string soil, light;
  double r_m = 0.0, alpha_deg = 0.0, heading_deg = 0.0;
  bool docked = false;
  Outcome outcome = Outcome::kCrashed;
  double sim_time_s = 0.0;
  int image_pairs = 0, recoveries = 0;
  double tip_depth_m = 0.0, lateral_error_m = 0.0, yaw_error_deg = 0.0, station_shift_m = 0.0;
  double cone_force_peak_n = 0.0;
  double spool_current_mean_a = 0.0, spool_current_peak_a = 0.0;
  double wheel_current_mean_a = 0.0, wheel_current_peak_a = 0.0;
  std::uint64_t state_hash = 0;  // written as 16 hex digits
};

/// What differs from machine to machine.
struct RunTiming {
  double cpu_time_s = 0.0, wall_time_s = 0.0;
};

/// One sample of the truth and of what the controller believed, every 0.1 s, for plots.
struct HistorySample {
  double time_s = 0.0;
  Pose2 X_DR;  // truth
  double z_m = 0.0, roll_rad = 0.0, pitch_rad = 0.0;
  double arm_rad = 0.0, tip_depth_m = 0.0, tip_lateral_m = 0.0;
  double tension_n = 0.0, cone_force_n = 0.0, station_shift_m = 0.0;
  double left_current_a = 0.0, right_current_a = 0.0, spool_current_a = 0.0;
  double left_sinkage_m = 0.0, right_sinkage_m = 0.0;
  std::string phase;  // belief
  bool located = false;
  Pose2 X_DR_believed;
  int sighting_count = 0, plan_count = 0, recoveries = 0;
};

/// A look at the board: where the rover truly stood and what it made of it.
struct SightingSample {
  double time_s = 0.0;
  Pose2 X_DR;  // truth
  SightingReport report;
  Pose2 X_DR_measured;  // from the report, ground plane; meaningful when accepted
};

struct PlanSample {
  double time_s = 0.0;
  std::vector<PlannedArc> arcs;
};

struct RunRecord {
  RunResult result;
  RunTiming timing;
  std::vector<HistorySample> history;
  std::vector<SightingSample> sightings;
  std::vector<PlanSample> plans;
  ConeModel cone;               // of the station that was simulated
  double tension_peak_n = 0.0;  // of the tether at the arm's tip
  std::string failure_note;     // a sentence for people: what the truth showed
};

}  // namespace dockyard
