// The outcome of a run, judged from the truth alone. docs/reference/outcomes.md explains all.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "controller/io/belief.h"
#include "controller/io/commands.h"
#include "models/axel/axel_model.h"
#include "models/axel/station_model.h"
#include "render/lens_ripple.h"
#include "sim/axel/world.h"
#include "sim/log/judged_limit.h"

namespace dockyard::axel {

/// How a run ends. The order is the order of the table in docs/reference/outcomes.md.
enum class Outcome {
  kDocked,
  kPartlySeated,
  kNotGone,
  kStationPushed,
  kStationOverload,
  kNoDetection,
  kWrongCorrespondence,
  kPoseRejected,
  kMissedCone,
  kFaceCatch,
  kJammed,
  kRecoveryLimit,
  kGaveUp,
  kTetherOverload,
  kTippedOver,
  kFalseDocked,
  kTimeout,
};
const char* Name(Outcome outcome);  // "docked", "no_detection", ...
/// All of them with their meanings, in order.
const std::vector<OutcomeName>& OutcomeNames();

/// Every threshold of the judgement, in one place.
struct OutcomeLimits {
  double entered_depth_m = 0.20;   // deep enough to be held
  double seated_within_m = 0.005;  // of the socket's floor
  double rest_travel_m = 1e-3;     // of the tip in the mouth frame, within ...
  double rest_time_s = 1.0;        // ... this time
  double taut_n = 5.0;             // tension that counts as taut
  // Replaced by what the mating parts let through: LimitsOf.
  double shake_turn_rad = Radians(4.5);
  double shake_travel_m = 0.01;
  double tipped_rad = Radians(60.0);  // roll of the axle
  double station_shift_m = 0.05;      // pushed further, the mother is not where she was
  double overload_n = 1000.0;         // assumed working load of the tether, range 500-2000
  double overload_time_s = 0.1;
  double catch_force_n = 10.0;  // on the annular face
  double catch_depth_m = 0.02;  // tip's front no deeper than this
  double catch_time_s = 3.0;
  double jam_speed_m_s = 2e-3;  // slower than this under pull is no progress
  double jam_tension_n = 60.0;
  double jam_time_s = 8.0;
  double excursion_m = 0.0;      // told way out; 0: none
  double excursion_share = 0.9;  // of it counts as gone: a drum is built to 5 %; 0.85-0.95
  double stay_m = 0.15;          // a rover that has moved no more stands; assumed, 0.1-0.3
  double stay_time_s = 60.0;     // the note tells of a stand so long; assumed, 30-120
  double mark_gate_px = 3.0;     // a detection nearer than this to its true place is right
  int few_marks = 4;             // fewer detections than this in both images: not detected
};

/// The limits for these mating parts, which set how far the shake turns a seated rover.
OutcomeLimits LimitsOf(const RoverModel& rover, const StationModel& station);

/// How one sighting of the board went, by the truth.
enum class SightingQuality { kGood, kUndetected, kWrongCorrespondence, kRejected };

/// Compares a sighting with the true pixels of the board's fiducials in both built cameras, whose
/// lenses have these ripples.
SightingQuality JudgeSighting(const SightingReport& report, const Pose3& X_RB_true,
                              const StereoRig& built, const FiducialBoard& board,
                              const OutcomeLimits& limits,
                              const std::array<LensRipple, 2>& ripples = {});

/// The shake after a claim: what it did to the rover.
struct ShakeResult {
  bool done = false;
  double turn_rad = 0.0;       // largest change of heading against the station
  double travel_m = 0.0;       // largest travel of the tip in the mouth frame
  double least_depth_m = 0.0;  // of the tip
  double station_m = 0.0;      // farthest that the mouth was from where it stood before the shake
};

/// Watches a run and names its outcome: of the conditions that still hold at the end, the one that
/// began first.
class OutcomeJudge {
 public:
  OutcomeJudge(const StationModel& station, const OutcomeLimits& limits);

  /// Called every control period.
  void Observe(const Truth& truth);
  /// Called for every sighting that the controller took.
  void ObserveSighting(double time_s, SightingQuality quality);

  /// Whether the run cannot continue: axle on end, tether overloaded.
  bool fatal() const;
  /// How often the arm went from ahead of the axle to behind it.
  int flips() const { return flips_; }
  /// Largest distance of the axle from where it started [m].
  double farthest_m() const { return farthest_m_; }
  /// Whether the tip is seated, at rest and taut now, by the truth.
  bool entered_at_rest() const;

  struct Verdicted {
    Outcome outcome = Outcome::kTimeout;
    std::string note;  // a sentence on the truth
  };
  Verdicted Conclude(Verdict claimed, int recoveries, const ShakeResult& shake) const;
  /// What the run is held against, at its end.
  std::vector<JudgedLimit> Limits(const ShakeResult& shake) const;

 private:
  Verdicted ConcludeGivenUp(int recoveries) const;
  /// How long the rover has stood where it is at the end, and what of it lies on rocks; empty if it
  /// has not stood long.
  std::string StandNote() const;
  /// Of an arm that the shake holds.
  Verdicted ConcludeHeld(const ShakeResult& shake) const;

  struct Condition {
    std::optional<double> since_s;
    /// Starts or keeps the clock while the condition holds, clears it when it does not.
    void Update(bool holds, double time_s);
    bool Held(double now_s, double for_s) const { return since_s && now_s - *since_s >= for_s; }
  };

  StationModel station_;
  OutcomeLimits limits_;
  Truth last_{};
  Condition rest_, tipped_, behind_, overload_, face_, jam_, missed_, blind_, confused_, rejected_;
  bool fatal_ = false;
  std::optional<bool> arm_behind_;
  int flips_ = 0;
  double tilt_peak_rad_ = 0.0;  // of the axle
  std::optional<Eigen::Vector3d> p_WR_first_;
  double farthest_m_ = 0.0;
  Eigen::Vector3d p_MT_rest_ = Eigen::Vector3d::Zero();  // where the tip rests
  // Where the rover has stayed, and what rocks have borne of it since, in the mean.
  struct Stand {
    Eigen::Vector3d p_WR = Eigen::Vector3d::Zero();
    double since_s = 0.0, rock_force_sum_n = 0.0;
    long samples = 0;
  };
  std::optional<Stand> stand_;
};

}  // namespace dockyard::axel
