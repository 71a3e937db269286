// Markers of a run's log in CDR: lines and triangles that ROS tools draw.
#pragma once

#include <string>
#include <vector>

#include "controller/io/sensors.h"
#include "sim/log/stage.h"
#include "sim/mcap/cdr.h"

namespace dockyard {

/// visualization_msgs/Marker of triangles in the world, three corners each.
void PutTriangles(CdrWriter& out, Tick tick, const std::string& name, int id,
                  const std::vector<Eigen::Vector3d>& corners_W, const Eigen::Vector3d& rgb);
/// visualization_msgs/MarkerArray of one marker: the solids' triangles.
std::string SolidsMessage(Tick tick, const StageSolids& solids);
/// visualization_msgs/MarkerArray: a strip of lines for each.
std::string LinesMessage(Tick tick, const std::vector<StageLine>& lines);

}  // namespace dockyard
