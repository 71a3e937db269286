#include "controller/motion/arcs.h"

#include <cmath>

namespace dockyard {
namespace {

constexpr double kTiny = 1e-12;

// Chord over arc length of an arc that turns by this much.
double ChordRatio(double turn_rad) {
  const double half = 0.5 * turn_rad;
  return std::abs(half) < 1e-6 ? 1.0 - half * half / 6.0 : std::sin(half) / half;
}

}  // namespace

Pose2 Advance(const Pose2& X_AR, const Arc& arc) {
  const double chord = arc.length_m * ChordRatio(arc.turn_rad);
  const double half = 0.5 * arc.turn_rad;
  return X_AR * Pose2{chord * std::cos(half), chord * std::sin(half), WrapPi(arc.turn_rad)};
}

Pose2 Advance(const Pose2& X_AR, const std::vector<Arc>& arcs) {
  Pose2 pose = X_AR;
  for (const Arc& arc : arcs) pose = Advance(pose, arc);
  return pose;
}

Arc Part(const Arc& arc, double share) { return {arc.length_m * share, arc.turn_rad * share}; }

std::vector<Arc> Truncate(const std::vector<Arc>& arcs, double length_m) {
  std::vector<Arc> first;
  double left = length_m;
  for (const Arc& arc : arcs) {
    const double length = std::abs(arc.length_m);
    if (length >= left) {
      if (left > 0.0) first.push_back(Part(arc, left / length));
      return first;
    }
    first.push_back(arc);
    left -= length;
  }
  return first;
}

double Length(const std::vector<Arc>& arcs) {
  double sum = 0.0;
  for (const Arc& arc : arcs) sum += std::abs(arc.length_m);
  return sum;
}

double Turning(const std::vector<Arc>& arcs) {
  double sum = 0.0;
  for (const Arc& arc : arcs) sum += std::abs(arc.turn_rad);
  return sum;
}

std::optional<Arc> OneArcTo(const Eigen::Vector2d& p_RG, const Eigen::Vector2d& p_RP) {
  double dy = p_RG.y() - p_RP.y(), sum_x = p_RG.x() + p_RP.x();
  if (std::hypot(dy, sum_x) < kTiny || (p_RG - p_RP).norm() < kTiny) return std::nullopt;
  if (sum_x < 0.0) dy = -dy, sum_x = -sum_x;  // the same circle, run backwards
  const double turn = 2.0 * std::atan2(dy, sum_x);
  const double c = std::cos(turn), s = std::sin(turn);
  // Eq. (2): the radius from whichever of the two forms divides by the larger number.
  const double along = p_RG.x() - c * p_RP.x() + s * p_RP.y();
  const double across = p_RG.y() - s * p_RP.x() - c * p_RP.y();
  if (std::abs(turn) < 1e-9) return Arc{along, turn};
  const double radius = std::abs(s) > std::abs(1.0 - c) ? along / s : across / (1.0 - c);
  return Arc{radius * turn, turn};
}

}  // namespace dockyard
