// Small values as JSON, for the log's text parts. Numbers keep their bits.
#pragma once

#include <nlohmann/json.hpp>

#include "controller/geometry/pose.h"

namespace dockyard {

using Json = nlohmann::ordered_json;

Json ToJson(const Pose2& pose);             // {x_m, y_m, heading_rad}
Json ToJson(const Pose3& pose);             // {R: 9 numbers row by row, p_m: 3 numbers}
Pose3 Pose3FromJson(const Json& json);      // throws nlohmann::json::exception
Json ToJson(const Eigen::Vector2d& value);  // [x, y]

}  // namespace dockyard
