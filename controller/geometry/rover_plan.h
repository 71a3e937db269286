// A rover in plan, as the planning of its paths needs it. Frame R: the rover's reference point, x
// forward, y left. The centre of every turn lies on R's y axis: the axle of the fixed wheels, or
// half-way between the axles of a tandem pair.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

namespace dockyard {

/// Corners of an area in order, either way round; the last one is joined to the first.
using Polygon = std::vector<Eigen::Vector2d>;

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
};

}  // namespace dockyard
