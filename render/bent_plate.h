// A board's plate that is bent about a cylinder: places on it by its flat print, and where a ray
// meets it. No GL.
#pragma once

#include <Eigen/Core>

#include "render/scene.h"

namespace dockyard {

/// Frame B of the board; a place of the print is where it would lie on a flat board. The plate
/// bends without stretch: lengths along it are those of the print. Its lowest line keeps the
/// board's plane: the edges of one that bulges to its viewer, the middle of a hollow one.
class BentPlate {
 public:
  /// Of a board whose flatness_m is not 0.
  explicit BentPlate(const BoardView& view);

  Eigen::Vector3d At(const Eigen::Vector2d& p_print) const;
  /// Unit, to the viewer's side.
  Eigen::Vector3d Normal(const Eigen::Vector2d& p_print) const;
  /// The place of the print that a ray meets. Beyond the edges the cylinder goes on; a ray that
  /// passes it by gets the place that it comes nearest to.
  Eigen::Vector2d Meet(const Eigen::Vector3d& from_B, const Eigen::Vector3d& along_B) const;
  double radius_m() const { return radius_m_; }

 private:
  double AngleAt(const Eigen::Vector2d& p_print) const { return across_.dot(p_print) / radius_m_; }
  double AngleOf(const Eigen::Vector2d& from_axis) const;
  Eigen::Vector2d OnPrint(double angle, const Eigen::Vector3d& p_B) const;

  Eigen::Vector2d across_, along_;  // unit, in B: in which it bends, and the cylinder's axis
  double radius_m_ = 0.0, half_rad_ = 0.0;
  double middle_m_ = 0.0;  // z of its middle line
  double side_ = 1.0;      // of the axis in z: 1 behind the board
};

}  // namespace dockyard
