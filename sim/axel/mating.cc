#include "sim/axel/mating.h"

namespace dockyard::axel {
namespace {

constexpr double kFloorThickness_m = 0.03;  // only its front is ever met
// A contact belongs to the face when it is this near the mouth's plane and faces outwards.
constexpr double kFaceDepth_m = 4e-3;
constexpr double kFaceNormal = 0.9;

// The cone's frame C: the mouth's, with z along the cone's axis.
const Pose3& X_MC() {
  static const Pose3 X{RotY(0.5 * kPi), Eigen::Vector3d::Zero()};
  return X;
}

}  // namespace

Mating::Mating(const ConeModel& cone, const std::vector<Collision>& arm_parts) {
  const double mouth = cone.mouth_radius_m, throat = cone.throat_radius_m;
  const double outer = cone.face_outer_radius_m, end = cone.socket_end_m;
  bore_.AddWall(
      {{0.0, outer}, {0.0, mouth}, {-cone.funnel_length_m, throat}, {-end, throat}, {-end, outer}});
  if (cone.stop_depth_m > 0.0) {
    const double front = -cone.stop_depth_m, back = front - kFloorThickness_m;
    bore_.AddWall({{back, 0.0}, {back, throat}, {front, throat}, {front, 0.0}});
  }
  bore_.AddWallEdge(0.0, mouth);
  bore_.AddWallEdge(-cone.funnel_length_m, throat);
  bore_.AddWallEdge(0.0, outer);
  for (const Collision& part : arm_parts) bore_.AddPart(part);
}

void Mating::Find(const Pose3& X_MA, double within_m, std::vector<BoreContact>& contacts) const {
  bore_.Find(X_MC(), X_MA, within_m, contacts);
}

bool IsOnFace(const BoreContact& contact) {
  return contact.p.x() > -kFaceDepth_m && contact.normal.x() > kFaceNormal;
}

}  // namespace dockyard::axel
