#include "models/read/camera_pose.h"

#include <Eigen/SVD>
#include <cmath>
#include <cstdio>

#include "models/read/config_error.h"
#include "models/read/number_grid.h"

namespace dockyard {
namespace {

constexpr const char* kAngles[] = {"yaw_deg", "pitch_deg", "roll_deg"};

std::string Short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

Eigen::Matrix3d ReadMatrix(const YamlReader& in) {
  const NumberGrid grid = ReadGrid(in.Child("rotation"), in.PathOf("rotation"));
  grid.RequireShape(3, 3);
  return NearestRotation(grid.matrix<3, 3>(), grid.Place());
}

Eigen::Matrix3d ReadQuaternion(const YamlReader& in) {
  const NumberGrid grid = ReadGrid(in.Child("rotation_wxyz"), in.PathOf("rotation_wxyz"));
  grid.RequireCount(4);
  const Eigen::Vector4d q(grid.values[0], grid.values[1], grid.values[2], grid.values[3]);
  constexpr double kMostOff = 0.01;
  if (!(std::abs(q.norm() - 1.0) <= kMostOff)) {
    throw ConfigError(grid.Place() +
                      ": expected a quaternion w x y z of length 1 within 0.01, found length " +
                      Short(q.norm()));
  }
  return Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized().toRotationMatrix();
}

/// The key in which the file gives the turn as a rotation; null: by angles, or not at all.
const char* RotationKey(const YamlReader& in) {
  const char* found = nullptr;
  for (const char* key : {"rotation", "rotation_wxyz"}) {
    if (!in.Has(key)) continue;
    if (found) in.Refuse(key, "one of rotation and rotation_wxyz", "both");
    found = key;
  }
  if (!found) return nullptr;
  for (const char* angle : kAngles) {
    if (in.Has(angle)) in.Refuse(angle, "no angle next to " + std::string(found));
  }
  return found;
}

/// @param R_unturned  the rotation where all angles are 0
Eigen::Matrix3d ReadTurn(const YamlReader& in, const Eigen::Matrix3d& R_unturned) {
  if (const char* key = RotationKey(in)) {
    return std::string(key) == "rotation" ? ReadMatrix(in) : ReadQuaternion(in);
  }
  const double yaw = in.DegreesOr("yaw_deg", 0.0, Between(-180, 180));
  const double pitch = in.DegreesOr("pitch_deg", 0.0, Between(-90, 90));
  const double roll = in.DegreesOr("roll_deg", 0.0, Between(-180, 180));
  return RotZ(yaw) * RotY(pitch) * RotX(roll) * R_unturned;
}

}  // namespace

const std::vector<std::string>& PoseKeys() {
  static const std::vector<std::string> keys{"position_m", "yaw_deg",  "pitch_deg",
                                             "roll_deg",   "rotation", "rotation_wxyz"};
  return keys;
}

Pose3 ReadBodyPose(const YamlReader& in) {
  return {ReadTurn(in, Eigen::Matrix3d::Identity()), in.Vector3("position_m", Between(-100, 100))};
}

Pose3 ReadCameraPose(const YamlReader& in) {
  Eigen::Matrix3d R_level;  // x forward, y left, z up -> z along the view, x right, y down
  R_level.col(0) = -Eigen::Vector3d::UnitY();
  R_level.col(1) = -Eigen::Vector3d::UnitZ();
  R_level.col(2) = Eigen::Vector3d::UnitX();
  const Eigen::Matrix3d R = ReadTurn(in, R_level);
  return {R, in.Vector3("position_m", Between(-100, 100))};
}

Eigen::Matrix3d NearestRotation(const Eigen::Matrix3d& read, const std::string& place) {
  constexpr double kMostOff = 0.005;  // three digits give 0.001
  const double off = (read.transpose() * read - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(off <= kMostOff)) {
    throw ConfigError(place +
                      ": expected a rotation: columns of length 1 at right angles within 0.005, "
                      "found one off by " +
                      Short(off));
  }
  if (read.determinant() < 0.0) {
    throw ConfigError(place +
                      ": expected a rotation, found a mirrored one of determinant -1: one axis has "
                      "the wrong sign");
  }
  if (off < 1e-15) return read;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(read, Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

}  // namespace dockyard
