#include "models/axel/mating_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace dockyard::axel {

double SeatDepth(const ConeModel& cone) {
  constexpr double kReeledIn_m = 0.25;
  return cone.stop_depth_m > 0.0 ? cone.stop_depth_m : kReeledIn_m;
}

double SeatedPlay(const RoverModel& rover, const ConeModel& cone) {
  const double throat_from_axle_m = rover.arm_length_m - SeatDepth(cone) + cone.funnel_length_m;
  const double disc_gap_m = cone.throat_radius_m - rover.tip.radius_m;
  double play_rad = std::numeric_limits<double>::infinity();
  // A part from rear to front along the arm meets the socket at its rear or at the throat's edge.
  const auto Meet = [&](double rear_m, double front_m, double radius_m) {
    const double at_m = std::max(rear_m, throat_from_axle_m);
    if (at_m >= front_m) return;
    const double gap_m = disc_gap_m + cone.throat_radius_m - radius_m;
    play_rad = std::min(play_rad, std::atan2(gap_m, rover.arm_length_m - at_m));
  };
  const CollarModel& collar = rover.collar;
  if (collar.radius_m > 0.0) {
    const double shoulder_m = collar.front_m - collar.lead_in_m;
    Meet(shoulder_m - collar.length_m, shoulder_m, collar.radius_m);
  }
  for (const Collision& part : rover.arm.collisions) {
    const auto* shaft = std::get_if<CylinderShape>(&part.shape);
    if (shaft == nullptr || part.name == "tip" || part.name == "collar") continue;
    const double middle_m = part.X_LG.p.x();
    Meet(middle_m - 0.5 * shaft->length_m, middle_m + 0.5 * shaft->length_m, shaft->radius_m);
  }
  return play_rad;
}

double MeanAxleHeight(const RoverModel& rover) {
  // Measured as Axel is reeled in: 8 to 2 mm below the rim's radius on loose sand, 11 to 25 mm
  // above it on compact gravel, with paddles of 35 mm. The middle is a quarter of a paddle above
  // the rim.
  constexpr double kPaddleShare = 0.25;
  return rover.left_wheel_soil.rim_radius_m + kPaddleShare * PaddleReach(rover.left_wheel_soil);
}

double FittingMouthHeight(const RoverModel& rover, double axle_m, const ConeModel& cone,
                          double tip_angle_rad) {
  return axle_m + (rover.arm_length_m - SeatDepth(cone)) * std::sin(tip_angle_rad);
}

double SeatedElevation(const RoverModel& rover, double axle_m, const StationModel& station) {
  const double tip_m =
      station.mouth_height_m + SeatDepth(station.cone) * std::sin(station.tip_angle_rad);
  const double sine = std::clamp((tip_m - axle_m) / rover.arm_length_m, -1.0, 1.0);
  return std::asin(sine) - station.tip_angle_rad;
}

}  // namespace dockyard::axel
