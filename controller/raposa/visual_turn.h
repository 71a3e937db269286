// State 7: a slow turn that keeps its eyes on the ellipse and ends by a predictor (F, C.3 and D).
#pragma once

#include <optional>

#include "controller/motion/path_follower.h"
#include "controller/raposa/nominal/ferreira_options.h"

namespace dockyard::raposa {

class VisualTurn {
 public:
  /// @param turn_rad    the first turn of the plan, to the left
  /// @param bearing_rad of the guide at its begin, to the right
  /// @param range_m     of the guide from the turning centre
  VisualTurn(double turn_rad, double bearing_rad, double range_m, double lever_m,
             const FerreiraMotion& options);

  /// What a new frame shows of the guide.
  struct Look {
    double bearing_rad = 0.0;
    double edge_rad = 0.0;  // bearing at which its ellipse meets the view's edge, > 0
  };
  /// The turning rate; none when the turn is over: the angle is reached, or the ellipse would be
  /// out of view in the next frame. "The predictor uses the difference between the present and the
  /// previous frame to predict where the robot will be in the next one." Lost: it stops.
  std::optional<Twist> Step(const std::optional<Look>& look);
  /// Turned so far, to the left, with the motion that is still to come.
  double turned_rad() const { return turned_rad_; }

 private:
  double turn_rad_, from_rad_, range_m_, lever_m_, rate_rad_s_;
  std::optional<double> last_rad_;  // bearing in the last frame
  double turned_rad_ = 0.0;
};

/// The bearing at which an ellipse of that radius leaves the round view, at its height.
double EdgeBearing(double half_view_rad, double focal_px, double down_px, double radius_px);

}  // namespace dockyard::raposa
