// Arcs driven as they were planned: each motor by a profile of its own to where the plan says, and
// nothing looks whether the rover goes there (Tsai et al., IV-A and V-F).
#pragma once

#include <array>
#include <vector>

#include "controller/axel/nominal/nominal.h"
#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "controller/motion/arcs.h"

namespace dockyard::axel {

struct OpenLoopOptions {
  double speed_m_s = 0.0;           // of the faster wheel's rim
  double wheel_accel_rad_s2 = 0.0;  // of the faster wheel
  double patience = 1.5;            // times the profile's duration
  Tick lag = 1'000;                 // and this, before a drive that is held back is left
};

/// An arc as three turns of motors that begin and end together.
struct ArcMoves {
  double left_rad = 0.0, right_rad = 0.0, spool_rad = 0.0;
  double seconds = 0.0;  // of the faster wheel's trapezoid, or triangle
};
/// shorten_m: by how much the exposed tether shortens over the arc.
ArcMoves MovesOf(const Nominal& nominal, const OpenLoopOptions& options, const Arc& arc,
                 double shorten_m);

/// Drives one arc after the other.
class OpenLoopArcs {
 public:
  /// shorten_m: one for each arc.
  OpenLoopArcs(const Nominal& nominal, const OpenLoopOptions& options, std::vector<Arc> arcs,
               std::vector<double> shorten_m);

  /// Sets the commands of wheels and spool; true once all arcs are over.
  bool Drive(const SensorFrame& sensed, Commands* commands);

 private:
  void Begin(const SensorFrame& sensed);
  bool WheelsThere(const SensorFrame& sensed) const;

  Nominal nominal_;
  OpenLoopOptions options_;
  std::vector<Arc> arcs_;
  std::vector<double> shorten_m_;
  std::size_t current_ = 0;
  bool begun_ = false;
  Tick until_ = 0, latest_ = 0;
  std::array<MotorCommand, kMotorCount> move_{};
};

}  // namespace dockyard::axel
