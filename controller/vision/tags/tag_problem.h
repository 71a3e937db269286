// Internal to the tags room. The equations of FitTag: grey levels of a blurred pattern in uneven
// light, with their derivatives.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "controller/geometry/board.h"
#include "controller/vision/tags/tag_light.h"
#include "controller/vision/tags/tag_plane.h"

namespace dockyard {

/// One pixel: its place on the plane, its light and its grey level.
struct GreySample {
  Eigen::Vector2d point;
  LightGrid::Place light;
  double grey = 0.0;
};

/// Root mean square of the light's changes from node to node, as a share of it.
double Unevenness(const LightGrid& grid, const LightGrid::Levels& light);

/// The unknowns. Grey = L - blackness (contrast L - (1, x, y) veil): white is as bright as the
/// light L there, black a part of it and a veil. x and y count from the tag's middle in half sides.
struct TagEstimate {
  TagCorners corners;    // on the plane
  double blur_px = 0.0;  // standard deviation of the blur
  double contrast = 0.0;
  Eigen::Vector3d veil = Eigen::Vector3d::Zero();  // [grey levels]
  LightGrid::Levels light{};                       // [grey levels]

  /// White over black in the mean light [grey levels].
  double Step() const { return contrast * light.mean() - veil[0]; }
};

constexpr int kTagShared = 13;  // corners 8, blur 1, contrast 1, veil 3; then the light
constexpr int kMostTagUnknowns = kTagShared + LightGrid::kMostNodes;
using TagStep = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostTagUnknowns, 1>;
TagEstimate Moved(const TagEstimate& at, const TagStep& step);

struct TagEquations {
  using Square =
      Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMostTagUnknowns, kMostTagUnknowns>;
  Square A;   // its lower triangle
  TagStep b;  // A step = -b
};

class TagProblem {
 public:
  /// All must outlive it.
  TagProblem(const TagCells& cells, const LightGrid& grid, const std::vector<GreySample>& samples);
  /// Standard deviation of a grey level, and from how many of them on an error counts less (Huber).
  void SetNoise(double grey) { noise_ = grey; }
  /// Changes of the light from node to node, as a share of it, 1 sigma.
  void SetUnevenness(double share) { uneven_ = share; }
  /// Huber's loss on all errors over the noise, and how little light and veil are expected to vary;
  /// infinite for an impossible estimate.
  double Cost(const TagEstimate& at) const { return Cost(at, nullptr); }
  double Cost(const TagEstimate& at, TagEquations* equations) const;
  /// Errors of all samples [grey levels]; none for an impossible estimate.
  std::vector<double> Errors(const TagEstimate& at) const;

 private:
  double Expected(const TagEstimate& at, TagEquations* equations) const;

  const TagCells& cells_;
  const LightGrid& grid_;
  const std::vector<GreySample>& samples_;
  double noise_ = 1.0, uneven_ = 1.0;
};

}  // namespace dockyard
