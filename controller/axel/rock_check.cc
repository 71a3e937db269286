#include "controller/axel/rock_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "controller/motion/arc_distance.h"

namespace dockyard::axel {
namespace {

// A rock that is too near at the start must not come nearer than this much more [m].
constexpr double kNearer_m = 0.01;

double KeptDistance(double wanted_m, double at_start_m) {
  return std::min(wanted_m, std::max(0.0, at_start_m - kNearer_m));
}

}  // namespace

bool BodyNearRock(const PlanGeometry& geometry, const Pose2& X_DR, const RockLimits& limits) {
  const double half_m = 0.5 * geometry.track_m - limits.half_wheel_m;
  const auto near = [&](const MappedRock& rock) {
    const Eigen::Vector2d p_RQ = Inverse(X_DR) * Eigen::Vector2d(rock.x_m, rock.y_m);
    return rock.height_m > limits.body_clears_m &&
           std::abs(p_RQ.x()) < rock.radius_m + limits.half_body_m &&
           std::abs(p_RQ.y()) < rock.radius_m + half_m;
  };
  const std::vector<MappedRock>& rocks = geometry.rock_map.rocks;
  return std::any_of(rocks.begin(), rocks.end(), near);
}

RockCheck::RockCheck(const PlanGeometry& geometry, const Pose2& X_DR_start,
                     const RockLimits& limits)
    : arm_m_(geometry.arm_m),
      wheel_radius_m_(geometry.wheel_radius_m),
      half_track_m_(0.5 * geometry.track_m),
      mouth_height_m_(geometry.mouth_height_m),
      limits_(limits) {
  const double margin_m = limits.beside_m + limits.sigmas * geometry.rock_map.sigma_m;
  const Arc still{};
  for (const MappedRock& rock : geometry.rock_map.rocks) {
    Kept kept{.rock = rock};
    const double wanted_m = rock.radius_m + margin_m;
    if (rock.height_m > limits.wheel_climbs_m) {
      kept.wheel_m =
          KeptDistance(wanted_m + limits.half_wheel_m, WheelDistance(X_DR_start, still, rock));
    }
    if (rock.height_m > limits.body_clears_m) {
      // A wheel that rolls over its middle lifts the body off it.
      const bool climbed = rock.height_m <= limits.wheel_climbs_m;
      kept.body_m =
          KeptDistance(climbed ? margin_m : wanted_m, BodyDistance(X_DR_start, still, rock));
    }
    if (rock.height_m > limits.arm_clears_m) {
      kept.arm_m = KeptDistance(wanted_m, ArmDistance(X_DR_start, still, rock));
    }
    kept.tether = rock.height_m > limits.tether_at_tip_m - limits.tether_m &&
                  TetherDepth(X_DR_start, rock) <= 0.0;
    if (kept.wheel_m > 0.0 || kept.body_m > 0.0 || kept.arm_m > 0.0 || kept.tether)
      rocks_.push_back(kept);
  }
}

double RockCheck::WheelDistance(const Pose2& X_DR, const Arc& arc, const MappedRock& rock) const {
  // Of the wheel's disc, the chord at the rock's height is the longest part that can meet it.
  const double height_m = std::min(rock.height_m, wheel_radius_m_);
  const double half_m = std::sqrt(height_m * (2.0 * wheel_radius_m_ - height_m));
  const Eigen::Vector2d p_DQ(rock.x_m, rock.y_m), left(0.0, half_track_m_), ahead(half_m, 0.0);
  return std::min(SweptDistance(X_DR, arc, left - ahead, left + ahead, p_DQ),
                  SweptDistance(X_DR, arc, -left - ahead, ahead - left, p_DQ));
}

double RockCheck::BodyDistance(const Pose2& X_DR, const Arc& arc, const MappedRock& rock) const {
  const Eigen::Vector2d p_DQ(rock.x_m, rock.y_m), left(0.0, half_track_m_ - limits_.half_wheel_m);
  return SweptDistance(X_DR, arc, left, -left, p_DQ);
}

double RockCheck::ArmDistance(const Pose2& X_DR, const Arc& arc, const MappedRock& rock) const {
  const Eigen::Vector2d p_DQ(rock.x_m, rock.y_m), tip(arm_m_, 0.0);
  return SweptDistance(X_DR, arc, {0.0, 0.0}, tip, p_DQ);
}

// How far the tether, straight from the tip to the mouth, goes into the disc where the rock is
// higher than it; at most 0 if it does not.
double RockCheck::TetherDepth(const Pose2& X_DR, const MappedRock& rock) const {
  const Eigen::Vector2d p_DQ(rock.x_m, rock.y_m);
  const Eigen::Vector2d tip = X_DR * Eigen::Vector2d(arm_m_, 0.0), way = -tip;
  const double squared = way.squaredNorm();
  const double share = squared > 0.0 ? std::clamp((p_DQ - tip).dot(way) / squared, 0.0, 1.0) : 0.0;
  const double height_m =
      limits_.tether_at_tip_m + share * (mouth_height_m_ - limits_.tether_at_tip_m);
  if (rock.height_m <= height_m - limits_.tether_m) return 0.0;
  return rock.radius_m + limits_.tether_m - (p_DQ - tip - share * way).norm();
}

double RockCheck::Cost(const Pose2& X_DR, const Arc& arc) const {
  double cost = 0.0;
  const double reach_m = std::abs(arc.length_m) + arm_m_ + half_track_m_ + wheel_radius_m_;
  for (const Kept& kept : rocks_) {
    std::optional<double> depth_m;
    const auto Cross = [&](double by_m) { depth_m = std::max(depth_m.value_or(0.0), by_m); };
    const double away_m = std::hypot(kept.rock.x_m - X_DR.x, kept.rock.y_m - X_DR.y) - reach_m;
    if (away_m < kept.wheel_m) {
      const double near_m = kept.wheel_m - WheelDistance(X_DR, arc, kept.rock);
      if (near_m > 0.0) Cross(near_m);
    }
    if (away_m < kept.body_m) {
      const double near_m = kept.body_m - BodyDistance(X_DR, arc, kept.rock);
      if (near_m > 0.0) Cross(near_m);
    }
    if (away_m < kept.arm_m) {
      const double near_m = kept.arm_m - ArmDistance(X_DR, arc, kept.rock);
      if (near_m > 0.0) Cross(near_m);
    }
    if (kept.tether) {
      for (double share = limits_.tether_step; share < 1.0 + 1e-9; share += limits_.tether_step) {
        const double near_m = TetherDepth(Advance(X_DR, Part(arc, share)), kept.rock);
        if (near_m > 0.0) Cross(near_m);
      }
    }
    if (depth_m) cost += kRockCost_m * (1.0 + *depth_m);
  }
  return cost;
}

double RockCheck::Cost(const Pose2& X_DR, const std::vector<Arc>& arcs) const {
  double cost = 0.0;
  Pose2 at = X_DR;
  for (const Arc& arc : arcs) {
    cost += Cost(at, arc);
    at = Advance(at, arc);
  }
  return cost;
}

}  // namespace dockyard::axel
