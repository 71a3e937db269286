// The ground in a run's log: all heights once, then those that changed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "controller/io/sensors.h"
#include "sim/log/stage.h"

namespace dockyard {

class GroundLog {
 public:
  static constexpr double kStep_m = 1e-4;  // heights are whole numbers of it, 3.2 m at most

  /// Takes in the heights. False: nothing has changed, or there is no ground.
  bool Update(const StageGround& ground);

  /// dockyard_msgs/Ground of what the last update changed. Without `cells` all heights stand in
  /// it, row by row.
  std::string Message(Tick tick) const;
  /// visualization_msgs/MarkerArray: triangles 0.1 m wide, for each square metre that changed.
  std::string Markers(Tick tick) const;

 private:
  Eigen::Vector3d PointW(int ix, int iy) const;

  StageGround grid_;  // its heights are not used
  std::vector<std::int16_t> heights_;
  std::vector<double> heights_m_;     // as they were taken in
  bool all_ = true;                   // of the last update
  std::vector<std::uint32_t> cells_;  // that it changed
};

}  // namespace dockyard
