// The way of a point round a centre.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace dockyard {

constexpr double kStraight_rad = 1e-9;  // arcs that turn by less count as straight

/// An angle, its cosine and sine found once.
struct Turn {
  double rad = 0.0, cos = 1.0, sin = 0.0;

  Turn() = default;
  Turn(double angle_rad) : rad(angle_rad), cos(std::cos(angle_rad)), sin(std::sin(angle_rad)) {}
  Turn Back() const {
    Turn back = *this;
    back.rad = -rad;
    back.sin = -sin;
    return back;
  }
  Eigen::Vector2d operator*(const Eigen::Vector2d& v) const {
    return {cos * v.x() - sin * v.y(), sin * v.x() + cos * v.y()};
  }
};

/// A point that goes round a centre by an angle from where it is.
struct CircleWay {
  Eigen::Vector2d centre{0, 0}, from{0, 0};
  Turn turn{};

  double Radius() const { return (from - centre).norm(); }
  Eigen::Vector2d End() const;
  /// Whether the point passes where the direction from the centre leads.
  bool Passes(const Eigen::Vector2d& direction) const;
  /// Least distance [m] from a fixed point.
  double DistanceTo(const Eigen::Vector2d& p) const;
  /// Least distance [m] from a segment; 0 where the way crosses it.
  double DistanceTo(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const;
  /// Greatest distance [m] from a fixed point.
  double FarthestFrom(const Eigen::Vector2d& p) const;
  /// Least value of the product of the place with a unit vector [m].
  double LeastAlong(const Eigen::Vector2d& direction) const;
};

/// Distance of a point from a segment.
double ToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b);

}  // namespace dockyard
