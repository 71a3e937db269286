#include "sim/log/belief_error.h"

#include <cmath>

namespace dockyard {

const std::vector<Column>& BeliefErrorColumns() {
  static const std::vector<Column> columns{
      {"error_x_m", "m", "believed minus true `x_m`; `nan` while `located` is 0"},
      {"error_y_m", "m", "believed minus true `y_m`, likewise"},
      {"error_yaw_deg", "deg", "believed minus true heading, likewise"},
      {"error_z_m", "m", "believed minus true `z_m`, likewise"}};
  return columns;
}

std::vector<double> BeliefErrors(const HistorySample& sample) {
  if (!sample.located) return std::vector<double>(BeliefErrorColumns().size(), std::nan(""));
  const RobotPose &believed = sample.X_DR_believed, &truth = sample.X_DR;
  return {believed.x - truth.x, believed.y - truth.y,
          Degrees(WrapPi(believed.heading - truth.heading)), believed.X.p.z() - truth.X.p.z()};
}

}  // namespace dockyard
