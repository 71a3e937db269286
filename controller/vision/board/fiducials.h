// Fiducials in one image (Tsai et al., III-A.2): adaptive threshold, blobs, filters, local
// refinement, ellipse; then the bar's rotation in one of four classes.
#pragma once

#include <array>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"
#include "controller/vision/ellipse.h"

namespace dockyard {

struct DetectedFiducial {
  Ellipse rim;             // in the image
  double sigma_px = 0.12;  // predicted error of its centre, one axis, from size, contrast and noise
  double match = 0.0;      // correlation of the image with the printed pattern, up to 1
  // The same inside the disc, bar turned by pi i / 16; zero on a board of plain discs.
  std::array<float, 16> bar_match{};
  bool clear = false;  // whether its bar shows; else it is a disc too small to tell
  // Filled in by AssignRotations:
  int rotation_class = -1;       // 0: 0, 1: 45, 2: 90, 3: -45 deg; see RotationClass
  double rotation_margin = 0.0;  // by how much its correlation beats the next class, 0..2
};

/// The class of a bar's direction (FiducialBoard's convention).
int RotationClass(double rotation_rad);

/// All candidates for fiducials in the image, in any rotation, best match first. The image's size
/// is that of its pixels; an empty one gives none.
std::vector<DetectedFiducial> DetectFiducials(const GrayImage& image, const FiducialBoard& board);

/// Finds each rotation on the board from the one in the image, given which way is up. When the
/// board is seen from above and aside at once, the rim's ellipse alone leaves a turn open; the
/// image of the plumb line fixes it.
void AssignRotations(std::vector<DetectedFiducial>& fiducials, const Camera& camera,
                     const Eigen::Vector3d& up_C);

}  // namespace dockyard
