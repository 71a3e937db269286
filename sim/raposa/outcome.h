// The outcome of a run, judged from the truth alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/io/commands.h"
#include "sim/log/judged_limit.h"
#include "sim/raposa/world.h"

namespace dockyard::raposa {

enum class Outcome {
  kDocked,
  kFalseDocked,
  kTippedPyramid,
  kPushedAway,
  kJammed,
  kMissedSocket,
  kSearchLimit,
  kGaveUp,
  kTimeout,
};
const char* Name(Outcome outcome);  // "docked", "false_docked", ...
/// All of them with their meanings, in order.
const std::vector<OutcomeName>& OutcomeNames();

/// Every threshold of the judgement, in one place. The reference's, where it has one.
struct OutcomeLimits {
  double seated_within_m = 0.005;     // guide's middle from its seat, before and during the trial
  double trial_way_m = 0.3;           // driven away ...
  double trial_turn_rad = 0.349066;   // ... and turned by, 20 deg
  double closed_m = 0.012;            // a door further open holds no guide; assumed, 10-15 mm
  double tipped_rad = Radians(30.0);  // of the pyramid; assumed, 20-45 deg
  double pushed_m = 0.05;             // of the pyramid from its place; assumed, 0.03-0.1 m
  double in_funnel_m = 0.046;         // the guide's middle nearer to its seat is in the funnel
  double jam_travel_m = 0.002;        // within ...
  double jam_time_s = 5.0;            // ... this time is no way; assumed, 1-5 mm and 3-10 s
};

/// What a trial did to a robot that claims to be docked: driven away and turned.
struct Trial {
  bool done = false;
  double worst_m = 0.0;  // largest distance of the guide from its seat
};

/// Watches a run and names its outcome.
class OutcomeJudge {
 public:
  explicit OutcomeJudge(const OutcomeLimits& limits) : limits_(limits) {}

  /// Called every control period.
  void Observe(const Truth& truth);
  /// Whether the run cannot go on: the pyramid lies on its side.
  bool fatal() const { return tipped_since_s_ && last_.time_s - *tipped_since_s_ > 2.0; }
  /// Whether doors and guide are where a docked robot has them.
  bool holds() const;

  struct Verdicted {
    Outcome outcome = Outcome::kTimeout;
    std::string note;  // a sentence on the truth
  };
  /// @param searches  whether the controller says by its states that it searches
  Verdicted Conclude(Verdict claimed, const Trial& trial, bool searches = true) const;

  /// What the run is held against, at its end: a claim by guide and doors, another run by what
  /// happened to the pyramid.
  std::vector<JudgedLimit> Limits(Verdict claimed, const Trial& trial) const;

 private:
  OutcomeLimits limits_;
  Truth last_{};
  std::optional<double> tipped_since_s_, touched_since_s_;
  struct Stay {
    Eigen::Vector3d p = Eigen::Vector3d::Zero();
    double since_s = 0.0;
  };
  std::optional<Stay> stay_;  // of the guide in the funnel
};

}  // namespace dockyard::raposa
