// The printed squares of a tag: the exact share of a pixel that is ink. No GL.
#pragma once

#include <Eigen/Core>
#include <array>

#include "controller/geometry/board.h"

namespace dockyard {

class TagInk {
 public:
  explicit TagInk(const SquareTag& tag);
  /// Share of a footprint, a quadrangle on the board with the corners in their order round it, that
  /// is ink: areas of polygons.
  double Share(const std::array<Eigen::Vector2f, 4>& footprint_B) const;
  const Eigen::Vector2d& p_BT() const { return p_BT_; }
  /// Half a diagonal of all that is printed.
  double radius_m() const { return radius_m_; }

 private:
  TagCells cells_;
  Eigen::Vector2d p_BT_;
  Eigen::Matrix2d cells_from_board_;
  double radius_m_ = 0.0;
};

}  // namespace dockyard
