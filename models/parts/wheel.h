// A wheel as the soil meets it.
#pragma once

namespace dockyard {

/// A wheel as the soil meets it: a rim with straight radial paddles across its whole width.
struct WheelModel {
  double rim_radius_m = 0.0;
  double width_m = 0.0;
  int paddle_count = 0;          // 0: a smooth wheel
  double paddle_height_m = 0.0;  // beyond the rim
  double paddle_thickness_m = 0.0;
  double phase_rad = 0.0;  // first paddle from the wheel frame's x axis, about +y
};

/// How far paddles stand out of the rim [m]; 0 for a smooth wheel.
inline double PaddleReach(const WheelModel& wheel) {
  return wheel.paddle_count > 0 ? wheel.paddle_height_m : 0.0;
}
/// From the axle to the paddles' tips [m]: the rolling radius on hard ground.
inline double RollingRadius(const WheelModel& wheel) {
  return wheel.rim_radius_m + PaddleReach(wheel);
}

}  // namespace dockyard
