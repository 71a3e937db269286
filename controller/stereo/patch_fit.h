// A patch laid on a picture by an affine map, to a fraction of a pixel.
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <optional>

namespace dockyard {

struct PatchFitSettings {
  int rounds = 20;
  double still_px = 0.02;  // then it has converged
  double stretch = 0.15;   // of each part of the map but the shift, 1 sigma; assumed, 0.1-0.25
  double alike_px = 9.0;   // pixels that err together, as smoothed ones do; assumed, 5-15
  // How a surface that bends away from the plane by one sigma moves the patch's edge in the image;
  // 0: it is plane.
  Eigen::Vector2d edge_px{0, 0};
  double most_shift_px = 3.0;  // from where it began; further it has gone astray. Assumed, 2-4 px
};

/// x = A p + t + (c0 X^2 + 2 c1 X Y + c2 Y^2) edge_px: p from the patch's middle pixel, (X, Y) the
/// same over half its side, x in the image.
struct PatchFit {
  Eigen::Matrix2d A = Eigen::Matrix2d::Identity();
  Eigen::Vector2d t{0, 0};
  Eigen::Vector3d bend{0, 0, 0};  // c, in sigmas
  double left = 0.0;              // root mean square of what is left, weighted, grey
};

/// Least squares over shift, affine map, gain and offset of the greys, by Gauss and Newton; the map
/// is held near the identity. An error in the range or in the plane that the patch was warped by
/// is taken up by the map, and moves the middle no more; nor does the bend of a rounded face, which
/// moves greys along one line only, that of the parallax. Pixels whose greys have changed by more
/// than the noise count less, as where a shadow's edge has moved over the face. None where it does
/// not converge or too little counts. Without contrast it stays where it began: FindPatch() refuses
/// such patches before.
/// @param patch    CV_32F, of odd sides
/// @param on_face  CV_8U, as large: 0 where a pixel does not count
/// @param picture  CV_32F
/// @param at       where the patch's middle is, to a pixel
std::optional<PatchFit> FitPatch(const cv::Mat& patch, const cv::Mat& on_face,
                                 const cv::Mat& picture, const Eigen::Vector2d& at,
                                 const PatchFitSettings& settings = {});

}  // namespace dockyard
