// Images of the board by casting rays, for tests only: independent of the renderer, exact in
// geometry, simple in light. Frame D is the dock's, as in controller/geometry/pose.h.
#pragma once

#include <cstdint>
#include <optional>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"

namespace dockyard {

/// The assumed board of these tests: 0.9 m x 0.5 m, two of each rotation, no symmetry.
FiducialBoard TestBoard();
/// Cameras 0.35 m apart, 0.22 m above the axle, looking ahead; 90 deg equidistant lenses.
StereoRig TestRig(int width, int height);
/// The board in the dock: its middle 0.62 m above the ground, leaning 5 deg forward.
Pose3 TestBoardInDock();
/// The rover on flat ground, its axle 0.25 m up, nose-down by the pitch.
Pose3 RoverAt(const DockingCoords& at, double pitch_rad);
/// The rig as built: turned, refocused and shifted against the calibration (1 sigma: 0.16 deg of
/// relative yaw, 0.05 deg of roll and pitch of each camera, 0.2 % of focal length, 1 px of centre).
StereoRig Miscalibrated(const StereoRig& rig, std::uint64_t key);

/// The scene and its light.
struct SyntheticScene {
  FiducialBoard board = TestBoard();
  bool has_board = true;
  bool has_station = true;  // the mouth in the plate, the module behind it
  Pose3 X_DB = TestBoardInDock();
  Pose3 X_DR;
  double white_dn = 170.0;  // the plate in full light
  // Light on the board: full, times (1 - speckle) in random patches, times shade beyond an edge.
  double speckle = 0.0;
  struct ShadowEdge {
    Eigen::Vector2d through_B{0.0, 0.0};  // a point of the edge on the board [m]
    double normal_rad = 0.0;              // towards the shade, from x right to y down
    double shade = 0.25;                  // light left
    double penumbra_m = 0.005;
  };
  std::optional<ShadowEdge> shadow;
  int clutter_discs = 0;      // dark discs lying about in the image
  int clutter_fiducials = 0;  // real fiducials of random size and rotation lying about
  // Grey paper over the board: the marks under it are missing.
  struct Cover {
    Eigen::Vector2d middle_B{0.0, 0.0}, size_m{0.0, 0.0};
  };
  std::optional<Cover> cover;
  double blur_px = 0.6;
  double noise_dn = 2.0;
  int samples = 4;  // per pixel and axis on the board
  std::uint64_t seed = 1;
};

GrayImage SyntheticView(const SyntheticScene& scene, const Camera& camera, const Pose3& X_RC);
StereoImages SyntheticPair(const SyntheticScene& scene, const StereoRig& rig);

}  // namespace dockyard
