// The motor schemas (F, D): speeds, arm and lamps from what the image shows.
#pragma once

#include "controller/motion/path_follower.h"
#include "controller/raposa/marks.h"
#include "controller/raposa/nominal/ferreira_options.h"

namespace dockyard::raposa {

/// State 1. K_lin sqrt(A), with A the ellipse's area at 1 m over its area now, is K_lin times the
/// distance; constant beyond slow_below_m. Turning rate -K_ang x_deviation.
Twist Approach(const MarksSeen& seen, const FerreiraMotion& options);
/// State 6: slowly on. Steered as state 1 while the ellipse is seen, if steer_final is set.
Twist FinalApproach(const MarksSeen& seen, const FerreiraMotion& options);
/// State 3, inferred: centre the ellipse and creep towards it.
Twist CreepToOrange(const MarksSeen& seen, const FerreiraMotion& options);

/// Whether state 1 is near its end: arm and lamps begin.
bool NearGuide(const MarksSeen& seen, const FerreiraMotion& options);
/// Arm angle for the guide's height in the image, tip down: -K_arm y_deviation with y upwards. A
/// guide low in the image has the tip pressed down: that lifts the front and lowers the back.
double ArmFor(const MarksSeen& seen, const FerreiraMotion& options);

/// State 4, inferred: a slow turn to and fro that carries the rectangle over the view, so that a
/// guide beside it comes into view.
class TurnAboutBlue {
 public:
  void Begin() { side_ = 0.0; }
  /// @param blue_px       the rectangle's middle, right of the image's
  /// @param half_view_px  of the view
  double Step(double blue_px, double half_view_px, const FerreiraMotion& options);

 private:
  double side_ = 0.0;  // of the turn, 1 to the left; 0: not begun
};

}  // namespace dockyard::raposa
