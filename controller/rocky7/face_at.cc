#include "controller/rocky7/face_at.h"

namespace dockyard::rocky7 {

FaceAt SeenFrom(const Pose2& X_RN, const FaceAt& face) {
  FaceAt there = face;
  there.p_RT.head<2>() = Inverse(X_RN) * Eigen::Vector2d(face.p_RT.head<2>());
  const Eigen::Matrix3d turn = RotZ(-X_RN.heading);
  there.normal_R = turn * face.normal_R;
  there.bend_R = turn * face.bend_R * turn.transpose();
  return there;
}

double ToolOff(const NominalMast& mast, const FaceAt& face) {
  const auto angles = AnglesTo(mast, face.p_RT);
  if (!angles) return kPi;
  return AngleBetween(SecondLink(mast, *angles).R.col(0), -face.normal_R);
}

}  // namespace dockyard::rocky7
