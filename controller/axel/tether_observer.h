// Compares the drum with the wheels and the inertial unit. A taut tether is taken up as the arm's
// tip comes nearer. Where the drum takes up more, the station slides. Where the wheels roll and the
// tether keeps its length, they dig.
#pragma once

#include <Eigen/Core>

#include "controller/axel/senses.h"
#include "controller/axel/tether_length.h"

namespace dockyard::axel {

/// What drum, wheels and inertial unit have counted.
struct TetherCount {
  double reeled_m = 0.0;       // tether taken up since power-on
  Eigen::Vector2d p_OT{0, 0};  // the arm's tip, by wheels and inertial unit
  Pose2 X_OR{};                // O: where they were switched on
};
TetherCount TetherCountOf(const Senses& senses, double arm_m);

/// Tether that was taken up beyond what the tip can have come nearer [m]: it came nearer by no more
/// than it moved, wherever the station is. For a tether that is taut at both times, and wheels that
/// do not slip forwards.
double TakenBeyond(const TetherCount& since, const TetherCount& now);

/// While the spool pulls a rover with free wheels: whether it pulls the station along instead.
class SlideWatch {
 public:
  SlideWatch(double arm_m, const SlideOptions& options) : arm_m_(arm_m), options_(options) {}

  void Begin(const Senses& senses);
  /// The spool stalls: the tether is as taut as it gets.
  void Stalled(const Senses& senses);
  /// The wheels have another command. Those that push slip, and hide how far the station slides
  /// meanwhile, so that each stage counts for itself.
  void NextStage(const Senses& senses);
  bool Slides(const Senses& senses) const;

 private:
  double arm_m_;
  SlideOptions options_;
  bool taut_ = false;      // it has stalled once
  double begun_m_ = 0.0;   // taken up when it began
  TetherCount stage_;      // when the stage began
  double beyond_m_ = 0.0;  // in the stages before
};

/// By how much the exposed tether grew if the wheels did not slip since then [m].
double GrowthByWheels(const TetherGeometry& geometry, const Pose2& X_DR_since,
                      const TetherCount& since, const TetherCount& now, double elevation_rad);

/// While a leg is driven: whether the wheels dig. They roll, and the drum does not bear it out.
class DigWatch {
 public:
  DigWatch(const TetherGeometry& geometry, const DigOptions& options)
      : geometry_(geometry), options_(options) {}

  /// Each period, with a taut tether. True: the wheels dig.
  bool Digs(const Senses& senses);

 private:
  TetherGeometry geometry_;
  DigOptions options_;
  struct Begin {
    TetherCount count;
    Pose2 X_DR;
  };
  std::optional<Begin> begin_;
};

}  // namespace dockyard::axel
