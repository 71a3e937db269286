// A rover in plan, as the planning of its paths needs it. Frame R: the rover's reference point, x
// forward, y left. The centre of every turn lies on R's y axis: the axle of the fixed wheels, or
// half-way between the axles of a tandem pair.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/plan_shapes.h"

namespace dockyard {

struct WheelPlan {
  std::string name;
  Eigen::Vector2d p_RW{0, 0};
  double steer_limit_rad = 0.0;  // either way; 0: the wheel is fixed
};

/// What a camera sees of the ground: a part of a ring.
struct ViewPlan {
  Eigen::Vector2d p_RC{0, 0};
  double azimuth_rad = 0.0;     // of its middle, from R's x axis
  double half_width_rad = 0.0;  // at most pi/2
  double near_m = 0.0, far_m = 0.0;
};

struct RoverPlan {
  std::string name;
  std::vector<WheelPlan> wheels;
  double wheel_radius_m = 0.0, wheel_width_m = 0.0;
  std::vector<Polygon> body;   // in R, without the wheels, what is stowed included
  Eigen::Vector2d p_RP{0, 0};  // the point that is brought to a goal
  std::optional<ViewPlan> view{};
  double speed_m_s = 0.0, steer_rate_rad_s = 0.0;  // of the fastest wheel's rim; of steering
};

/// x of the line on which the centres of turns lie, in the frame of the wheels' places: the mean of
/// the fixed wheels, which slip least so. None where all wheels are steered: any line will do.
std::optional<double> TurningLine_m(const std::vector<WheelPlan>& wheels);

}  // namespace dockyard
