// Markers of a run's log in CDR: lines and triangles that ROS tools draw.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "controller/io/sensors.h"
#include "sim/log/stage.h"
#include "sim/mcap/cdr.h"

namespace dockyard {

/// Type of a line in visualization_msgs/Marker.
inline constexpr std::int32_t kLineStrip = 4;

/// visualization_msgs/Marker of triangles in the world, three corners each.
void PutTriangles(CdrWriter& out, Tick tick, const std::string& name, int id,
                  const std::vector<Eigen::Vector3d>& corners_W, const Eigen::Vector3d& rgb);
/// visualization_msgs/MarkerArray of one marker: the solids' triangles.
std::string SolidsMessage(Tick tick, const StageSolids& solids);
/// visualization_msgs/MarkerArray: a strip of lines for each.
std::string LinesMessage(Tick tick, const std::vector<StageLine>& lines);

}  // namespace dockyard
