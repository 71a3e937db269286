// Rigid transforms in the plane and in space.
//
// X_AB is the pose of frame B in frame A: p_AQ = X_AB * p_BQ, and equal letters touch in products,
// X_AC = X_AB * X_BC. R_AB is its rotation, p_AB its translation.
//
// Frames (right-handed, metres, radians):
//   W  world, z up
//   G  site: the yard's ground frame, z off its plane (up on level ground); soil grid, station and
//      start poses are given in it
//   D  dock: centre of the cone's mouth plane projected to the ground; x out along the cone's axis
//      (towards the rover), z up
//   S  station body
//   R  rover body: middle of the axle, x forward (the way the arm points), y left, z up; body-fixed
//   A  arm: middle of the axle, x to the arm's tip, y left; turns about y against R
//   T  arm tip
//   K  a wheel: its centre, y along the axle to the left; turns about y
//   L  left camera, Q right camera, C any camera: z along the view, x right, y down
//   B  fiducial board: its centre, x right and y down as its viewer sees it, z into the station
// A positive pitch turns about +y, so it is nose-down. Yaw is positive counter-clockwise from
// above.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace dockyard {

inline constexpr double kPi = 3.14159265358979323846;
constexpr double Radians(double degrees) { return degrees * (kPi / 180.0); }
constexpr double Degrees(double radians) { return radians * (180.0 / kPi); }

/// The angle wrapped to (-pi, pi].
double WrapPi(double angle_rad);

/// Of the cross product of two vectors in a plane, the part out of it.
inline double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}
/// The matrix that makes v x w of w.
inline Eigen::Matrix3d CrossMatrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d M;
  M << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return M;
}

/// Planar rigid transform.
struct Pose2 {
  double x = 0.0;        // [m]
  double y = 0.0;        // [m]
  double heading = 0.0;  // [rad], (-pi, pi]

  bool operator==(const Pose2&) const = default;
};

Pose2 operator*(const Pose2& X_AB, const Pose2& X_BC);
Eigen::Vector2d operator*(const Pose2& X_AB, const Eigen::Vector2d& p_BQ);
Pose2 Inverse(const Pose2& X_AB);

/// Spatial rigid transform.
struct Pose3 {
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();

  static Pose3 Translation(double x, double y, double z) {
    return {Eigen::Matrix3d::Identity(), Eigen::Vector3d(x, y, z)};
  }
};

Pose3 operator*(const Pose3& X_AB, const Pose3& X_BC);
Eigen::Vector3d operator*(const Pose3& X_AB, const Eigen::Vector3d& p_BQ);
Pose3 Inverse(const Pose3& X_AB);

/// Elementary rotations [rad].
Eigen::Matrix3d RotX(double angle_rad);
Eigen::Matrix3d RotY(double angle_rad);
Eigen::Matrix3d RotZ(double angle_rad);

/// The smallest rotation that brings the direction of `from` to that of `to`. Lengths do not
/// matter, but must not be zero; opposite directions take any half turn.
Eigen::Matrix3d RotationBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

/// Roll, pitch, yaw about the moving axes z-y'-x'': R = RotZ(yaw) RotY(pitch) RotX(roll).
struct RollPitchYaw {
  double roll = 0.0, pitch = 0.0, yaw = 0.0;  // [rad]
};
RollPitchYaw ToRollPitchYaw(const Eigen::Matrix3d& R);
Eigen::Matrix3d ToRotation(const RollPitchYaw& rpy);

/// Pose in the ground plane: x, y and the heading of the x axis.
Pose2 ToGround(const Pose3& X_AB);
/// Upright pose at height z above the ground plane.
Pose3 FromGround(const Pose2& X_AB, double z_m);

/// Docking coordinates (Tsai et al., Fig. 7 and Eq. 1): the rover's place about its target in polar
/// form, and its heading. h = 0: its x axis points against the target's, wherever it stands;
/// alpha = h: its x axis points at the target.
struct DockingCoords {
  double r = 0.0;      // [m]
  double alpha = 0.0;  // [rad], counter-clockwise from above
  double h = 0.0;      // [rad], counter-clockwise from above
};
DockingCoords ToDockingCoords(const Pose2& X_DR);
Pose2 FromDockingCoords(const DockingCoords& at);

}  // namespace dockyard
