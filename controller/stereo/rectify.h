// A stereo pair brought to one image plane: equal rows show equal rays, straight lines are
// straight.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"

namespace dockyard {

/// The points p with normal . p = offset_m, normal of length 1.
struct Plane {
  Eigen::Vector3d normal{0, 0, 1};
  double offset_m = 0.0;
};

/// Two equal pinhole cameras side by side. Frame C: the left one, z along the view, x towards the
/// right one, y down.
struct RectifiedPair {
  int width = 0, height = 0;        // [px]
  double focal_px = 0.0;            // along both sides
  Eigen::Vector2d centre_px{0, 0};  // of the view's axis, in both
  double baseline_m = 0.0;
  Pose3 X_RC;  // in the frame of the rig
  /// The right image's centre_px.x less the left one's. A point far away has the disparity
  /// -doffs_px (Middlebury's calibrations name it so).
  double doffs_px = 0.0;

  /// The point in C that both show with this disparity [px], > -doffs_px: u of the left image less
  /// that of the right one.
  Eigen::Vector3d Point(double u, double v, double disparity_px) const {
    const double depth_m = focal_px * baseline_m / (disparity_px + doffs_px);
    return {depth_m * (u - centre_px.x()) / focal_px, depth_m * (v - centre_px.y()) / focal_px,
            depth_m};
  }
};

/// OpenCV's Q of the pair: Q (u, v, disparity, 1) is proportional to (p_C, 1), as its
/// reprojectImageTo3D computes.
Eigen::Matrix4d ReprojectionOf(const RectifiedPair& pair);

struct RectifySettings {
  double focal_px = 0.0;                   // 0: the left camera's, on its axis
  double widest_rad = 57.0 * kPi / 180.0;  // off the axis, along each side; assumed, 45-65
  /// Where a lens has no single centre, the images are brought together for points on this plane,
  /// in the rig's frame; else for points far away.
  std::optional<Plane> ground_R{};
  /// A rig that IsRectified keeps its images as they are, pixel by pixel.
  bool keep_rectified = false;
};

/// Whether the rig's images need no rectification, to 0.01 px: two equal pinholes without
/// distortion, parallel, one row for both, the right one to the right.
bool IsRectified(const StereoRig& rig);

/// The lookup from a pair's images to the rectified ones.
class Rectifier {
 public:
  /// Throws std::invalid_argument for cameras at one place or with views across their baseline.
  explicit Rectifier(const StereoRig& rig, const RectifySettings& settings = {});

  const RectifiedPair& pair() const { return pair_; }
  const StereoRig& rig() const { return rig_; }
  /// Whether the images stay as they are.
  bool IsKept() const { return kept_; }
  /// Bilinear. Black where the cameras see nothing.
  StereoImages Rectified(const StereoImages& images) const;
  /// Whether a pixel of the left or right rectified image, and those margin_px about it, come of
  /// the camera's image.
  bool IsSeen(int u, int v, bool right, int margin_px = 0) const;
  /// Pixel of the left or right camera that a pixel of its rectified image shows; none off it.
  std::optional<Eigen::Vector2d> Source(const Eigen::Vector2d& pixel, bool right) const;

 private:
  struct Map {
    std::vector<float> u, v;  // by pixel; -1: none
  };
  Map MapOf(bool right) const;
  void FindBounds();
  void KeepImages();

  StereoRig rig_;
  RectifySettings settings_;
  RectifiedPair pair_;
  bool kept_ = false;  // the images stay as they are
  Map left_, right_;
};

}  // namespace dockyard
