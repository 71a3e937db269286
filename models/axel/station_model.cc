#include "models/axel/station_model.h"

#include "models/parts/mounting.h"

namespace dockyard::axel {

Pose3 MouthInStation(const StationModel& station) {
  // Tipped forward: the axis, going out along +x, points down, a positive turn about y.
  return {RotY(station.tip_angle_rad), Eigen::Vector3d(0.0, 0.0, station.mouth_height_m)};
}

Pose3 BoardInStation(const StationModel& station) {
  Pose3 X_MB;
  // The viewer stands on +x and faces -x, so his right is +y.
  X_MB.R.col(0) = Eigen::Vector3d::UnitY();
  X_MB.R.col(1) = -Eigen::Vector3d::UnitZ();
  X_MB.R.col(2) = -Eigen::Vector3d::UnitX();
  X_MB.p = Eigen::Vector3d(0.0, 0.0, station.board_height_above_axis_m);
  return MouthInStation(station) * Mounted(X_MB, station.board_mounting, X_MB.p);
}

BoardCutout CutoutOf(const StationModel& station) {
  return {.p_B = Eigen::Vector2d(0.0, station.board_height_above_axis_m),
          .radius_m = station.cone.face_outer_radius_m};
}

Pose3 BoardInDock(const StationModel& station) { return BoardInStation(station); }

}  // namespace dockyard::axel
