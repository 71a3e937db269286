// Radial distortion by a quotient of two polynomials with tangential terms: OpenCV's of eight
// coefficients, on the plane at depth 1. RationalPinhole and Omni share it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace dockyard {

struct RationalDistortion {
  std::array<double, 6> k{};  // k1..k6 [-]
  double p1 = 0.0, p2 = 0.0;  // [-]

  /// Distorted point and, in M, its derivative by the undistorted one.
  Eigen::Vector2d Distort(const Eigen::Vector2d& m, Eigen::Matrix2d& M) const;
  /// Whether the image is unfolded from the axis out to m, and not folded at m, where the
  /// derivative is M. The radial part is proven: its slope, a quotient of polynomials, has no zero
  /// and no pole up to there.
  bool Holds(const Eigen::Vector2d& m, const Eigen::Matrix2d& M) const;
  /// The point that Distort brings to `wanted`, within the part that Holds; none: there is none.
  /// Then `edge`, if given, is a point near the end of that part.
  std::optional<Eigen::Vector2d> Undistort(const Eigen::Vector2d& wanted,
                                           Eigen::Vector2d* edge = nullptr) const;

 private:
  bool UnfoldedOutTo(double r2) const;
  std::optional<Eigen::Vector2d> Newton(Eigen::Vector2d m, const Eigen::Vector2d& wanted) const;
  double RadialStart(double wanted) const;
};

}  // namespace dockyard
