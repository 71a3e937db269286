// The board's pose from a stereo pair of one's own images, without the simulation:
//   on_images LEFT.png RIGHT.png
// Prints X_RB, the board in the rover's body. Ends with 0, 2 (usage), 3 (no such image) or 4 (no
// pose).
#include <cstdio>
#include <opencv2/imgcodecs.hpp>
#include <optional>

#include "controller/geometry/camera.h"
#include "controller/vision/board/locate.h"

namespace {

using dockyard::Radians;

/// The calibration: Axel's, from models/axel/axel.yaml. Put your own cameras here.
dockyard::StereoRig Rig() {
  dockyard::StereoRig rig;
  rig.left = rig.right = dockyard::EquidistantCamera(1024, 768, Radians(90.0));
  Eigen::Matrix3d R_RC;  // the camera's axes in the body: x to the right, y down, z forward
  R_RC.col(0) = -Eigen::Vector3d::UnitY();
  R_RC.col(1) = -Eigen::Vector3d::UnitZ();
  R_RC.col(2) = Eigen::Vector3d::UnitX();
  rig.X_RL = {R_RC, {0.12, 0.175, 0.22}};  // forward_m, half of baseline_m, height_m
  rig.X_RQ = {R_RC, {0.12, -0.175, 0.22}};
  return rig;
}

/// The board: the station's, from models/axel/station/station.yaml. Put your own here.
dockyard::FiducialBoard Board() {
  dockyard::FiducialBoard board;
  board.width_m = 0.90;
  board.height_m = 0.50;
  board.disc_diameter_m = 0.10;
  board.bar_length_m = 0.064;
  board.bar_width_m = 0.022;
  board.fiducials = {{{-0.36, -0.17}, Radians(0.0)}, {{-0.12, -0.18}, Radians(45.0)},
                     {{0.14, -0.17}, Radians(90.0)}, {{0.37, -0.16}, Radians(-45.0)},
                     {{-0.38, 0.06}, Radians(90.0)}, {{-0.27, 0.18}, Radians(-45.0)},
                     {{0.27, 0.04}, Radians(0.0)},   {{0.37, 0.17}, Radians(45.0)}};
  return board;
}

/// Empty when the file is no image of that size; says so.
std::optional<dockyard::GrayImage> Load(const char* file, const dockyard::Camera& camera) {
  const cv::Mat image = cv::imread(file, cv::IMREAD_GRAYSCALE);
  if (image.cols != camera.width || image.rows != camera.height) {
    std::fprintf(stderr, "%s: expected an image of %d x %d, found %d x %d\n", file, camera.width,
                 camera.height, image.cols, image.rows);
    return std::nullopt;
  }
  return dockyard::GrayImage{image.cols, image.rows, {image.begin<uchar>(), image.end<uchar>()}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: on_images LEFT RIGHT\n");
    return 2;
  }
  const dockyard::StereoRig rig = Rig();
  const auto left = Load(argv[1], rig.left), right = Load(argv[2], rig.right);
  if (!left || !right) return 3;
  dockyard::LocateHints hints;
  hints.up_R = {0, 0, 1};  // against gravity; a tilted rover gives what its inertial unit says
  const auto found = dockyard::LocateBoard({*left, *right}, rig, Board(), hints);
  if (!found.sighting) {
    std::fprintf(stderr, "no pose: %s\n", dockyard::Name(found.sighting.error()));
    return 4;
  }
  const dockyard::DockSighting& sighting = *found.sighting;
  const Eigen::Vector3d sigma_m = sighting.covariance.diagonal().head<3>().cwiseSqrt();
  const Eigen::Vector3d into_R = sighting.X_RB.R.col(2);  // the way the beholder looks at it
  std::printf("p_RB_m %.4f %.4f %.4f\n", sighting.X_RB.p.x(), sighting.X_RB.p.y(),
              sighting.X_RB.p.z());
  std::printf("sigma_m %.4f %.4f %.4f\n", sigma_m.x(), sigma_m.y(), sigma_m.z());
  std::printf("z_B_in_R %.5f %.5f %.5f\n", into_R.x(), into_R.y(), into_R.z());
  std::printf("fiducials %d, reprojection %.2f px, %s\n", sighting.fiducials_used,
              sighting.reprojection_px, sighting.stereo ? "stereo" : "one image");
  return 0;
}
