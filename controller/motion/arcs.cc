#include "controller/motion/arcs.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard {
namespace {

// Below this a curvature is a straight line: 1 km radius bends 10 m of path by 5 cm.
constexpr double kStraight = 1e-9;
constexpr double kTiny = 1e-12;

bool IsFinite(const std::vector<Arc>& arcs) {
  return std::all_of(arcs.begin(), arcs.end(), [](const Arc& arc) {
    return std::isfinite(arc.length_m) && std::isfinite(arc.turn_rad);
  });
}

// Chord over arc length of an arc that turns by this much.
double ChordRatio(double turn_rad) {
  const double half = 0.5 * turn_rad;
  return std::abs(half) < 1e-6 ? 1.0 - half * half / 6.0 : std::sin(half) / half;
}

// Second curvature of Eq. (7): k2 = (c2 k1 + c3) / (c0 k1 - c1). None for a turn in place.
std::optional<double> SecondCurvature(const Pose2& goal, double k1) {
  const double s = std::sin(goal.heading), half = std::sin(0.5 * goal.heading);
  const double c0 = 0.5 * (goal.x * goal.x + goal.y * goal.y);
  const double c1 = goal.y;
  const double c2 = goal.x * s - goal.y * std::cos(goal.heading);
  const double c3 = -2.0 * half * half;  // cos - 1 without cancellation
  const double numerator = c2 * k1 + c3, denominator = c0 * k1 - c1;
  if (std::abs(denominator) < kTiny) return std::nullopt;
  return numerator / denominator;
}

// Heading where the arcs meet, Eq. (12) multiplied through by both curvatures.
double MeetingHeading(const Pose2& goal, double k1, double k2) {
  const double a = k1 * (k2 * goal.x - std::sin(goal.heading));
  const double b = k1 * (k2 * goal.y + std::cos(goal.heading)) - k2;
  const double sign = k2 > k1 ? 1.0 : -1.0;
  return std::atan2(a * sign, -b * sign);
}

// Length of the first arc; a straight first part is what the second arc's chord leaves over.
double FirstLength(const Pose2& goal, double k1, double k2, double turn1) {
  if (std::abs(k1) > kStraight) return turn1 / k1;
  return std::abs(k2) > kStraight ? goal.x - std::sin(goal.heading) / k2 : goal.x;
}

double SecondLength(const Pose2& goal, double k2, const Arc& first, double turn2) {
  if (std::abs(k2) > kStraight) return turn2 / k2;
  const Pose2 meeting = Advance({}, first);
  const double dx = goal.x - meeting.x, dy = goal.y - meeting.y;
  return dx * std::cos(goal.heading) + dy * std::sin(goal.heading);
}

bool Fits(const std::vector<Arc>& arcs, double max_curvature, int direction) {
  return std::all_of(arcs.begin(), arcs.end(), [&](const Arc& arc) {
    return arc.length_m * direction >= 0.0 &&
           std::abs(arc.turn_rad) <= max_curvature * std::abs(arc.length_m) + 1e-9;
  });
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

std::optional<std::vector<Arc>> TwoArcsTo(const Pose2& X_RG, double first_curvature) {
  const bool straight_ahead = std::abs(X_RG.y) < kTiny && std::abs(X_RG.heading) < kTiny;
  if (straight_ahead) return std::vector<Arc>{{X_RG.x, 0.0}};
  const std::optional<double> k2 = SecondCurvature(X_RG, first_curvature);
  if (!k2 || std::abs(*k2 - first_curvature) < kTiny) return std::nullopt;
  Arc first, second;
  first.turn_rad =
      std::abs(first_curvature) > kStraight ? MeetingHeading(X_RG, first_curvature, *k2) : 0.0;
  second.turn_rad = WrapPi(X_RG.heading - first.turn_rad);
  first.length_m = FirstLength(X_RG, first_curvature, *k2, first.turn_rad);
  second.length_m = SecondLength(X_RG, *k2, first, second.turn_rad);
  std::vector<Arc> arcs{first, second};
  if (!IsFinite(arcs)) return std::nullopt;
  // Near its poles Eq. (7) loses digits; a pair that misses by more than 1 um is not offered.
  const Pose2 end = Advance({}, arcs);
  if (std::hypot(end.x - X_RG.x, end.y - X_RG.y) > 1e-6) return std::nullopt;
  return arcs;
}

double TwoArcCost(const std::vector<Arc>& arcs) {
  DOCKYARD_CHECK(arcs.size() == 1 || arcs.size() == 2);
  const double first = std::abs(arcs[0].length_m);
  const double second = arcs.size() == 2 ? std::abs(arcs[1].length_m) : 0.0;
  return first + second + std::abs(first - second);
}

std::vector<double> CurvatureFan(double max_curvature, int per_side) {
  std::vector<double> fan{0.0};
  for (int i = 1; i <= per_side; ++i) {
    // Denser near straight, where the paths are long and their ends far apart.
    const double share = static_cast<double>(i) / per_side;
    fan.push_back(max_curvature * share * share);
    fan.push_back(-max_curvature * share * share);
  }
  return fan;
}

std::optional<std::vector<Arc>> CheapestTwoArcs(const Pose2& X_RG, double max_curvature,
                                                int direction) {
  std::optional<std::vector<Arc>> best;
  double best_curvature = 0.0;
  const auto consider = [&](double k1) {
    const auto arcs = TwoArcsTo(X_RG, k1);
    if (!arcs || !Fits(*arcs, max_curvature, direction)) return;
    if (best && TwoArcCost(*arcs) >= TwoArcCost(*best)) return;
    best = arcs;
    best_curvature = k1;
  };
  constexpr int kPerSide = 200;
  for (const double k1 : CurvatureFan(max_curvature, kPerSide)) consider(k1);
  // The fan's widest gap is 2/n of the sharpest; three zooms of ten leave a 1e-5 of it.
  double gap = 2.0 * max_curvature / kPerSide;
  for (int zoom = 0; best && zoom < 3; ++zoom, gap *= 0.1) {
    const double middle = best_curvature;
    for (int i = -10; i <= 10; ++i) consider(middle + 0.1 * i * gap);
  }
  return best;
}

}  // namespace dockyard
