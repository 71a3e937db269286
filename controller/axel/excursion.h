// A rover that starts seated: out of the cone, as far as its mission says, and back to where it may
// see the board.
#pragma once

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/options.h"
#include "controller/axel/senses.h"
#include "controller/io/commands.h"

namespace dockyard::axel {

/// How the ground falls from the station along the cone's axis [rad], by the elevation against the
/// level of an arm in the socket, which lies along it.
double FallBySeatedArm(const Nominal& nominal, double elevation_rad);

/// Tension of the spool that pays out on ground that falls by this much away from the station [N].
/// On ground that rises it is that of any reverse.
double OutwardTension(const AxelOptions& options, double fall_rad);

/// Way from the seat until the tip is clear of the mouth [m].
double UndockedWay(const Nominal& nominal, const ExcursionOptions& options);

/// Way out [m] of a rover whose spool paid out and whose wheels rolled back by these. Wheels slip
/// and a slack tether is longer than the way, so that the lesser counts.
double WayOut(double paid_out_m, double rolled_back_m);

/// Nominal way of a return by dead reckoning [m]; 0: the board is near enough as it is.
double WayBack(double way_out_m, const ExcursionOptions& options);

/// Out in reverse: the arm stays ahead, and the tether steadies it.
class Excursion {
 public:
  enum class Status { kUnderWay, kOut, kLate };

  Excursion(const Nominal& nominal, const AxelOptions& options)
      : nominal_(nominal), options_(options) {}

  /// The mission says that the rover starts seated, so it knows where it is, and its arm how the
  /// ground falls.
  void Begin(Senses* senses);
  /// Whether it is so far out of the seat, or does not get there.
  Status Step(double distance_m, Tick in_phase, Senses* senses, Commands* commands) const;
  /// Plans the return; 0: none is needed.
  void PlanReturn(const Senses& senses);
  double back_m() const { return back_m_; }

 private:
  double OutOf(const Senses& senses) const;

  Nominal nominal_;
  AxelOptions options_;
  Moment seated_;
  double tension_n_ = 0.0;  // of the spool on the way out
  double back_m_ = 0.0;
};

}  // namespace dockyard::axel
