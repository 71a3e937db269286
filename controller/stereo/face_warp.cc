#include "controller/stereo/face_warp.h"

#include <Eigen/Dense>
#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "controller/stereo/gray_mat.h"

namespace dockyard {
namespace {

// The change of a face's normal for each metre along it, 1 sigma: stereo measured 5 to 12 on three
// rounded boulders from within 1 m. And the cosine from the normal to the line of sight, at least:
// nearer to the limb a patch is no quadric. Assumed, 3-12 and 0.2-0.5.
constexpr double kBend_per_m = 6.0, kLeastFacing = 0.4;

// Across a face's edge greys mix by smoothing, and disparities by the matcher's blocks: a square of
// this side must be on the face. Assumed, 3-7 px.
constexpr int kEdge_px = 5;

// Pixels of the older image for those of the new one: p_N = (R + t n^T / d) p_C on n . p_C = d.
Eigen::Matrix3d OlderFromNew(const FacePatch& patch, const Pose3& X_NC) {
  const double offset_m = patch.normal_C.dot(patch.p_C);
  const Eigen::Matrix3d M = X_NC.R + X_NC.p * patch.normal_C.transpose() / offset_m;
  Eigen::Matrix3d K = Eigen::Matrix3d::Identity();
  K(0, 0) = K(1, 1) = patch.focal_px;
  K.topRightCorner<2, 1>() = patch.centre_px;
  return K * M.inverse() * K.inverse();
}

Eigen::Vector2d PixelOf(const FacePatch& patch, const Eigen::Vector3d& p_C) {
  return patch.centre_px + patch.focal_px * p_C.head<2>() / p_C.z();
}

// The shift of a point in the new image, for each metre that it is over the plane: from where its
// pixel's point on the plane would be.
Eigen::Vector2d ParallaxPerMetre(const FacePatch& patch, const Pose3& X_NC) {
  constexpr double kOver_m = 0.005;
  const Eigen::Vector3d over_C = patch.p_C + kOver_m * patch.normal_C;
  const Eigen::Vector3d on_plane_C =
      patch.normal_C.dot(patch.p_C) / patch.normal_C.dot(over_C) * over_C;
  return (PixelOf(patch, X_NC * over_C) - PixelOf(patch, X_NC * on_plane_C)) / kOver_m;
}

}  // namespace

std::optional<WarpedGreys> WarpedPatch(const FacePatch& patch, const Pose3& X_NC,
                                       const Eigen::Vector2i& middle, int half) {
  const int side = 2 * half + 1;
  Eigen::Matrix3d shift = Eigen::Matrix3d::Identity();
  shift(0, 2) = middle.x() - half;
  shift(1, 2) = middle.y() - half;
  const Eigen::Matrix3d H = OlderFromNew(patch, X_NC) * shift;
  for (const double u : {0.0, side - 1.0}) {
    for (const double v : {0.0, side - 1.0}) {
      const Eigen::Vector3d older = H * Eigen::Vector3d(u, v, 1.0);
      if (older.z() <= 0.0) return std::nullopt;
      const Eigen::Vector2d pixel = older.head<2>() / older.z();
      if (pixel.minCoeff() < 0.0 || pixel.x() > patch.left.width - 1.0 ||
          pixel.y() > patch.left.height - 1.0) {
        return std::nullopt;
      }
    }
  }
  cv::Mat map(3, 3, CV_64F);
  WarpedGreys seen;
  for (int i = 0; i < 9; ++i) map.at<double>(i / 3, i % 3) = H(i / 3, i % 3);
  cv::warpPerspective(MatOn(patch.left), seen.greys, map, {side, side},
                      cv::INTER_CUBIC | cv::WARP_INVERSE_MAP);
  if (patch.on_face.pixels.empty()) {
    seen.on_face = cv::Mat(side, side, CV_8U, cv::Scalar(255));
  } else {
    cv::warpPerspective(MatOn(patch.on_face), seen.on_face, map, {side, side},
                        cv::INTER_NEAREST | cv::WARP_INVERSE_MAP);
    // Beyond the border nothing is known, which erode() takes for the face.
    cv::erode(seen.on_face, seen.on_face,
              cv::getStructuringElement(cv::MORPH_ELLIPSE, {kEdge_px, kEdge_px}));
  }
  return seen;
}

Eigen::Vector2d BendAtEdge(const FacePatch& patch, const Pose3& X_NC, int half) {
  const Eigen::Vector3d p_N = X_NC * patch.p_C;
  const double facing = -(X_NC.R * patch.normal_C).dot(p_N.normalized());
  const double edge_m = half * p_N.z() / patch.focal_px / std::max(kLeastFacing, facing);
  return 0.5 * kBend_per_m * edge_m * edge_m * ParallaxPerMetre(patch, X_NC);
}

}  // namespace dockyard
