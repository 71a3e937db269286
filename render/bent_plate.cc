#include "render/bent_plate.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard {
namespace {

/// Half the angle of an arc whose half length is 1 and whose rise is `rise`: 1 - cos over the
/// angle.
double HalfAngle(double rise) {
  double angle = 2.0 * rise;
  constexpr int kRounds = 6;  // of Newton's method; four reach rounding for rises up to 0.3
  for (int i = 0; i < kRounds; ++i) {
    const double sine = std::sin(0.5 * angle);
    const double off = 2.0 * sine * sine / angle - rise;
    angle -= off / (std::sin(angle) / angle - 2.0 * sine * sine / (angle * angle));
  }
  return angle;
}

}  // namespace

BentPlate::BentPlate(const BoardView& view)
    : across_(std::cos(view.bow_rad), -std::sin(view.bow_rad)),
      along_(-across_.y(), across_.x()),
      middle_m_(std::min(0.0, -view.flatness_m)),
      side_(view.flatness_m > 0.0 ? 1.0 : -1.0) {
  DOCKYARD_CHECK(view.flatness_m != 0.0);
  const double half_m = 0.5 * (std::abs(across_.x()) * view.board.width_m +
                               std::abs(across_.y()) * view.board.height_m);
  half_rad_ = HalfAngle(std::abs(view.flatness_m) / half_m);
  radius_m_ = half_m / half_rad_;
}

Eigen::Vector3d BentPlate::At(const Eigen::Vector2d& p_print) const {
  const double angle = AngleAt(p_print), sine = std::sin(0.5 * angle);
  const Eigen::Vector2d p = radius_m_ * std::sin(angle) * across_ + along_.dot(p_print) * along_;
  return {p.x(), p.y(), middle_m_ + side_ * 2.0 * radius_m_ * sine * sine};
}

Eigen::Vector3d BentPlate::Normal(const Eigen::Vector2d& p_print) const {
  const double angle = AngleAt(p_print);
  const Eigen::Vector2d n = side_ * std::sin(angle) * across_;
  return {n.x(), n.y(), -std::cos(angle)};
}

Eigen::Vector2d BentPlate::Meet(const Eigen::Vector3d& from_B,
                                const Eigen::Vector3d& along_B) const {
  // In the plane across the axis: u, and z from the middle line.
  const Eigen::Vector2d from(across_.dot(from_B.head<2>()), from_B.z() - middle_m_);
  const Eigen::Vector2d ray(across_.dot(along_B.head<2>()), along_B.z());
  const Eigen::Vector2d axis(0.0, side_ * radius_m_);
  const double a = ray.squaredNorm(), b = ray.dot(from - axis);
  const double c = from.squaredNorm() - 2.0 * from.dot(axis);
  const double inside = b * b - a * c;
  if (inside <= 0.0) {
    const double angle = AngleOf(from - b / a * ray - axis);
    return OnPrint(angle, from_B - b / a * along_B);
  }
  const double q = b < 0.0 ? std::sqrt(inside) - b : -std::sqrt(inside) - b;
  double t = c / q, other = q / a;
  double angle = AngleOf(from + t * ray - axis), its = AngleOf(from + other * ray - axis);
  const bool both = std::max(std::abs(angle), std::abs(its)) <= half_rad_;
  const bool nearer = other > 0.0 && (other < t || t <= 0.0);
  if (both ? nearer : std::abs(its) < std::abs(angle)) {
    t = other;
    angle = its;
  }
  return OnPrint(angle, from_B + t * along_B);
}

double BentPlate::AngleOf(const Eigen::Vector2d& from_axis) const {
  return std::atan2(from_axis.x(), -side_ * from_axis.y());
}

Eigen::Vector2d BentPlate::OnPrint(double angle, const Eigen::Vector3d& p_B) const {
  return radius_m_ * angle * across_ + along_.dot(p_B.head<2>()) * along_;
}

}  // namespace dockyard
