// One square tag in an image.
#pragma once

#include <Eigen/Core>
#include <array>

namespace dockyard {

struct FoundTag {
  int id = 0;
  int hamming = 0;  // squares that were read wrong and corrected
  // How far the squares' grey levels lie from the threshold between black and white, their mean, 0
  // to 128: clear tags have over 50.
  double decision_margin = 0.0;
  // Top left, top right, bottom right, bottom left of the tag as printed (CornersOf).
  std::array<Eigen::Vector2d, 4> corners{};
  double sigma_px = 0.0;  // predicted error of a corner, one axis, 1 sigma
  bool fitted = false;    // whether the pattern was fitted to the image: FindTags
};

}  // namespace dockyard
