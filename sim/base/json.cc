#include "sim/base/json.h"

namespace dockyard {

Json ToJson(const Pose2& pose) {
  return {{"x_m", pose.x}, {"y_m", pose.y}, {"heading_rad", pose.heading}};
}

Json ToJson(const Pose3& pose) {
  Json rotation = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) rotation.push_back(pose.R(row, column));
  }
  return {{"R", rotation}, {"p_m", {pose.p.x(), pose.p.y(), pose.p.z()}}};
}

Pose3 Pose3FromJson(const Json& json) {
  Pose3 pose;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      pose.R(row, column) = json.at("R").at(static_cast<std::size_t>(3 * row + column));
    }
  }
  for (int i = 0; i < 3; ++i) pose.p(i) = json.at("p_m").at(static_cast<std::size_t>(i));
  return pose;
}

Json ToJson(const Eigen::Vector2d& value) { return Json::array({value.x(), value.y()}); }

}  // namespace dockyard
