// Internal to the tags room. The equations of FitTag: grey levels of a blurred pattern in uneven
// light, with their derivatives.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/vision/tags/tag_plane.h"

namespace dockyard {

/// One pixel: its place on the plane and its grey level.
struct GreySample {
  Eigen::Vector2d point;
  double grey = 0.0;
};

/// The unknowns. Grey = (1, x, y) white + blackness (1, x, y) dark, x and y from the tag's middle
/// in half sides.
struct TagEstimate {
  TagCorners corners;    // on the plane
  double blur_px = 0.0;  // standard deviation of the blur
  Eigen::Vector3d white = Eigen::Vector3d::Zero(), dark = Eigen::Vector3d::Zero();
};

constexpr int kTagUnknowns = 15;  // corners 8, blur 1, white 3, dark 3
using TagStep = Eigen::Matrix<double, kTagUnknowns, 1>;
TagEstimate Moved(const TagEstimate& at, const TagStep& step);

struct TagEquations {
  Eigen::Matrix<double, kTagUnknowns, kTagUnknowns> A;
  TagStep b;  // A step = -b
};

class TagProblem {
 public:
  /// Both must outlive it.
  TagProblem(const TagCells& cells, const std::vector<GreySample>& samples);
  /// Standard deviation of a grey level, and from how many of them on an error counts less (Huber).
  void SetNoise(double grey) { noise_ = grey; }
  /// Huber's loss on all errors over the noise; infinite for an impossible estimate.
  double Cost(const TagEstimate& at) const { return Cost(at, nullptr); }
  double Cost(const TagEstimate& at, TagEquations* equations) const;
  /// Errors of all samples [grey levels]; none for an impossible estimate.
  std::vector<double> Errors(const TagEstimate& at) const;

 private:
  const TagCells& cells_;
  const std::vector<GreySample>& samples_;
  double noise_ = 1.0;
};

}  // namespace dockyard
