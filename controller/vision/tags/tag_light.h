// Internal to the tags room. Uneven light on a tag, such as the edge of a shade: brightness on a
// square grid of nodes, bilinear between them.
#pragma once

#include <Eigen/Core>
#include <array>

namespace dockyard {

/// Nodes from edge to edge of the printed pattern.
class LightGrid {
 public:
  static constexpr int kMostASide = 8;
  static constexpr int kMostNodes = kMostASide * kMostASide;
  using Levels = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostNodes, 1>;

  /// @param across     squares of the pattern, TagCells::across
  /// @param across_px  its length in the image
  LightGrid(int across, double across_px);

  int a_side() const { return a_side_; }
  int nodes() const { return a_side_ * a_side_; }

  /// The nodes about a point, and how much each of them counts. Beyond the grid its rim counts.
  struct Place {
    std::array<int, 4> nodes{};
    Eigen::Vector4d weights = Eigen::Vector4d::Zero();
    double Of(const Levels& levels) const;
  };
  /// @param cell  from the tag's middle, in squares
  Place At(const Eigen::Vector2d& cell) const;

 private:
  int across_ = 1, a_side_ = 2;
};

}  // namespace dockyard
