// Where about the target the instrument meets the surface along its normal.
#pragma once

#include "controller/rocky7/face_at.h"

namespace dockyard::rocky7 {

/// A place of the surface and the normal there, along the surface from the face's point.
FaceAt AlongSurface(const FaceAt& face, const Eigen::Vector3d& along_R);

struct TouchPlace {
  FaceAt face;
  double off_rad = kPi;  // of the tool off the normal there; pi where the mast does not reach it
};

/// The place within a centimetre of the target that misses the aims least: by its distance from the
/// target against 2 cm, and by how far the tool is off the normal there against 5 deg. The tool's
/// direction follows from the place; on a rounded rock the normal turns with it. The target itself
/// where no such place is better.
TouchPlace PlaceToTouch(const NominalMast& mast, const FaceAt& face);

}  // namespace dockyard::rocky7
