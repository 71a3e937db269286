// From flat views to the lens's picture: each pixel averages the flat view over its exact
// footprint. Plain arithmetic, no GL. Tan plane: (x, y) = ray.xy / ray.z in the camera frame.
#pragma once

#include <vector>

#include "controller/geometry/camera.h"
#include "render/stereo_renderer.h"

namespace dockyard {

/// Part of the tan plane.
struct TanRect {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;

  bool Contains(const Eigen::Vector2d& tan, double margin) const {
    return tan.x() >= left + margin && tan.x() <= right - margin && tan.y() >= top + margin &&
           tan.y() <= bottom - margin;
  }
};

/// A rendered part of the tan plane: rows from the top, pixels evenly spread.
struct FlatView {
  TanRect rect;
  int width = 0, height = 0;
  std::vector<float> values;
};

/// Tan-plane points of a lens's pixels, tabulated from Camera::Ray: against the radius for a
/// Kannala-Brandt lens, corner by corner for the others, which costs 0.1 s: keep it for the run.
class TanScale {
 public:
  /// Throws std::invalid_argument when the camera's numbers are no camera, or a pixel sees more
  /// than 60 deg off the axis, where one flat view no longer serves.
  explicit TanScale(const Camera& camera);
  /// Tan-plane point of a pixel; error below 1e-8.
  Eigen::Vector2d operator()(const Eigen::Vector2d& pixel) const;
  /// Of a whole row of pixel corners (x - 0.5, y - 0.5), x = 0 ... width.
  void CornerRow(int y, std::vector<Eigen::Vector2f>& row) const;

  const Camera& camera() const { return camera_; }

 private:
  void TabulateRadius(const KannalaBrandt& lens);
  void TabulateCorners();

  Camera camera_;
  double per_rho2_ = 0.0;
  std::vector<double> table_;             // tan(theta) / rho
  std::vector<Eigen::Vector2f> corners_;  // row by row
};

/// The smallest rectangle that holds every pixel's footprint, grown by 2 % and 4 px.
TanRect ImageRect(const Camera& camera, const TanScale& scale);

/// close may be null; it is used where it holds the whole footprint.
RadianceImage WarpToFisheye(const Camera& camera, const TanScale& scale, const FlatView& wide,
                            const FlatView* close);

}  // namespace dockyard
