// An image of a face that is kept, so that the face is found again in later ones.
#pragma once

#include <Eigen/Core>

#include "controller/geometry/image.h"

namespace dockyard {

/// The left rectified image of a face, and the face's plane in the camera's frame C.
struct FacePatch {
  GrayImage left;
  double focal_px = 0.0;
  Eigen::Vector2d centre_px{0, 0};
  GrayImage on_face{};                 // not 0 where a pixel of left shows the face; empty: all do
  Eigen::Vector3d p_C{0, 0, 1};        // the point
  Eigen::Vector3d normal_C{0, 0, -1};  // of the face
};

}  // namespace dockyard
