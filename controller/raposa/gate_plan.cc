#include "controller/raposa/gate_plan.h"

#include <algorithm>
#include <cmath>

namespace dockyard::raposa {
namespace {

constexpr double kRoomMargin_m = 0.02;  // so that a turn after it is clear; assumed, 0.01-0.05
constexpr double kStop_s = 0.6;         // of each start and stop, as reckoned; assumed, 0.4-1

/// Of all told parts, from the guide's front to the rearmost box.
Eigen::Vector2d PyramidMiddle(const Nominal& nominal) {
  double rear_m = -nominal.marks.behind_m;
  for (const GreyBox& box : nominal.grey_boxes) rear_m = std::min(rear_m, box.low.x());
  return {0.5 * (0.5 * nominal.marks.guide_length_m + rear_m), 0.0};
}

/// Of a point from a straight way.
double DistanceOf(const Eigen::Vector2d& middle, const Eigen::Vector2d& a,
                  const Eigen::Vector2d& b) {
  const Eigen::Vector2d way = b - a;
  const double length2 = way.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((middle - a).dot(way) / length2, 0.0, 1.0) : 0.0;
  return (a + share * way - middle).norm();
}

/// A way that only leads away from the pyramid is clear wherever it begins.
bool Clear(const Eigen::Vector2d& middle, const Eigen::Vector2d& a, const Eigen::Vector2d& b,
           const DockyardOptions& options) {
  const double least = std::min(options.keep_out_m, (a - middle).norm());
  return DistanceOf(middle, a, b) >= least - 1e-9;
}

double TurnTime(double turn_rad, const DockyardOptions& options) {
  return std::abs(turn_rad) < options.turn_tolerance_rad
             ? 0.0
             : std::abs(turn_rad) / options.turn_rad_s + kStop_s;
}

/// Through these points; each leg forwards or backwards, by all choices.
GatePlan Through(const Pose2& X_DN, const std::vector<Eigen::Vector2d>& points,
                 const DockyardOptions& options) {
  GatePlan best;
  best.time_s = 1e9;
  const std::size_t choices = std::size_t{1} << points.size();
  for (std::size_t choice = 0; choice < choices; ++choice) {
    GatePlan plan;
    double heading = X_DN.heading;
    Eigen::Vector2d at(X_DN.x, X_DN.y);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d way = points[i] - at;
      const bool back = (choice >> i & 1U) != 0;
      const double to = WrapPi(std::atan2(way.y(), way.x()) + (back ? kPi : 0.0));
      plan.time_s +=
          TurnTime(WrapPi(to - heading), options) + way.norm() / options.travel_m_s + kStop_s;
      plan.legs.push_back({to, back ? -way.norm() : way.norm(), points[i]});
      heading = to;
      at = points[i];
    }
    plan.time_s += TurnTime(WrapPi(kPi - heading), options);
    if (plan.time_s < best.time_s) best = plan;
  }
  return best;
}

}  // namespace

GatePlan PlanToGate(const Pose2& X_DN, const Nominal& nominal, const DockyardOptions& options) {
  const Eigen::Vector2d middle = PyramidMiddle(nominal);
  Eigen::Vector2d at(X_DN.x, X_DN.y);
  Pose2 from = X_DN;
  std::optional<Leg> away;
  const Eigen::Vector2d off = at - middle;
  if (off.norm() < options.turn_room_m) {
    // Straight on or back, whichever leads away, until there is room: |off + way along| = room.
    const Eigen::Vector2d along(std::cos(X_DN.heading), std::sin(X_DN.heading));
    const double room_m = options.turn_room_m + kRoomMargin_m, ahead_m = off.dot(along);
    const double reach_m = std::sqrt(ahead_m * ahead_m + room_m * room_m - off.squaredNorm());
    const double way_m = ahead_m < 0.0 ? -ahead_m - reach_m : -ahead_m + reach_m;
    at += way_m * along;
    away = Leg{X_DN.heading, way_m, at};
    from = {at.x(), at.y(), X_DN.heading};
  }
  GatePlan best;
  best.time_s = 1e9;
  const auto consider = [&](std::vector<Eigen::Vector2d> points) {
    Eigen::Vector2d last = at;
    for (const Eigen::Vector2d& point : points) {
      if (!Clear(middle, last, point, options)) return;
      last = point;
    }
    // The robot still has to come in from the gate.
    GatePlan plan = Through(from, points, options);
    plan.time_s += (last.x() - options.gate_m) / options.travel_m_s;
    if (plan.time_s < best.time_s) best = plan;
  };
  const double angle = std::atan2(at.y(), at.x());
  for (const double gate_m :
       {options.gate_m, 0.5 * (options.gate_m + options.far_gate_m), options.far_gate_m}) {
    const Eigen::Vector2d gate(gate_m, 0.0);
    consider({gate});
    for (const double share : {0.3, 0.5, 0.7}) {
      const Eigen::Vector2d round =
          options.round_m * Eigen::Vector2d(std::cos(share * angle), std::sin(share * angle));
      consider({round, gate});
    }
    const Eigen::Vector2d first =
        options.round_m * Eigen::Vector2d(std::cos(0.7 * angle), std::sin(0.7 * angle));
    const Eigen::Vector2d second =
        options.round_m * Eigen::Vector2d(std::cos(0.35 * angle), std::sin(0.35 * angle));
    consider({first, second, gate});
  }
  if (away) best.legs.insert(best.legs.begin(), *away);
  return best;
}

Leg AcrossSight(const Pose2& X_DN, double length_m, const DockyardOptions& options) {
  const Eigen::Vector2d at(X_DN.x, X_DN.y);
  const Eigen::Vector2d sight = -at.normalized();
  Eigen::Vector2d across(-sight.y(), sight.x());
  if (across.dot(Eigen::Vector2d(options.gate_m, 0.0) - at) < 0.0) across = -across;
  const double forwards = std::atan2(across.y(), across.x());
  const bool back = std::abs(WrapPi(forwards - X_DN.heading)) > kPi / 2;
  return {back ? WrapPi(forwards + kPi) : forwards, back ? -length_m : length_m,
          at + length_m * across};
}

bool InCone(const Pose2& X_DN, const DockyardOptions& options) {
  const double ahead_m = X_DN.x - options.cone_from_m;
  // Before it has turned the other way it goes on by its heading.
  const double y_m = X_DN.y + options.cone_turn_m * std::sin(X_DN.heading);
  return ahead_m > 0.0 && std::abs(y_m) < options.cone_half_m + options.cone_slope * ahead_m &&
         std::abs(WrapPi(X_DN.heading - kPi)) < options.cone_heading_rad;
}

}  // namespace dockyard::raposa
