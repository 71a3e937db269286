#include "controller/motion/blocker.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"
#include "controller/motion/arc_distance.h"
#include "controller/motion/circle_way.h"
#include "controller/motion/polygon.h"
#include "controller/motion/steering.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

constexpr int kDiscsAlong = 3;  // from a polygon's middle to each corner
constexpr int kSteerings = 4;   // looks while a wheel is steered between two arcs

// Of the discs about places from the middle to the corners the largest ones, none with its centre
// in another.
std::vector<Disc> InscribedDiscs(const Polygon& polygon) {
  std::vector<Disc> offers, chosen;
  const Vector2d middle = MeanCorner(polygon);
  for (const Vector2d& corner : polygon) {
    for (int i = 0; i <= kDiscsAlong; ++i) {
      const Vector2d p = middle + (corner - middle) * i / kDiscsAlong;
      const double depth_m = DepthIn(polygon, p);
      if (depth_m >= 0.0) offers.push_back({p, depth_m});
    }
  }
  std::sort(offers.begin(), offers.end(),
            [](const Disc& a, const Disc& b) { return a.radius_m > b.radius_m; });
  for (const Disc& offer : offers) {
    const bool is_within = std::any_of(chosen.begin(), chosen.end(), [&](const Disc& disc) {
      return (offer.centre - disc.centre).norm() <= disc.radius_m;
    });
    if (!is_within) chosen.push_back(offer);
  }
  return chosen;
}

// Where on an arc from R's start the rover's point p_RP is nearest to p_RQ, as a share of the arc.
double ShareNearest(const Arc& arc, const Vector2d& p_RP, const Vector2d& p_RQ) {
  double share = 0.0;
  if (std::abs(arc.turn_rad) < kStraight_rad) {
    if (arc.length_m != 0.0) share = (p_RQ - p_RP).x() / arc.length_m;
  } else {
    const Vector2d centre(0.0, arc.length_m / arc.turn_rad);
    const Vector2d from = p_RP - centre, to = p_RQ - centre;
    const double past_middle =
        WrapPi(std::atan2(Cross(from, to), from.dot(to)) - 0.5 * arc.turn_rad);
    share = 0.5 + past_middle / arc.turn_rad;
  }
  return std::clamp(share, 0.0, 1.0);
}

double ReachOf(const Polygon& polygon) {
  double reach_m = 0.0;
  for (const Vector2d& corner : polygon) reach_m = std::max(reach_m, corner.norm());
  return reach_m;
}

}  // namespace

Cover::Cover(const RoverPlan& rover) : body_(rover.body), wheel_(WheelOutline(rover)) {
  for (const WheelPlan& wheel : rover.wheels) {
    if (wheel.steer_limit_rad == 0.0) {
      body_.push_back(Moved({wheel.p_RW.x(), wheel.p_RW.y(), 0.0}, wheel_));
    } else {
      wheels_.push_back(wheel);
    }
  }
  for (const Polygon& part : body_) body_reach_m_ = std::max(body_reach_m_, ReachOf(part));
  wheel_reach_m_ = ReachOf(wheel_);
  reach_m_ = body_reach_m_;
  if (!body_.empty()) middle_ = MeanCorner(body_.front());
  for (const WheelPlan& wheel : wheels_) {
    reach_m_ = std::max(reach_m_, wheel.p_RW.norm() + wheel_reach_m_);
  }
}

Pose2 Cover::PoseOf(const Blocker& blocker, const std::vector<Arc>& path) const {
  Pose2 X_AB;
  for (std::size_t i = 0; i < blocker.arc; ++i) X_AB = Advance(X_AB, path[i]);
  return PoseFrom(X_AB, blocker, path);
}

Pose2 Cover::PoseFrom(const Pose2& X_AB, const Blocker& blocker,
                      const std::vector<Arc>& path) const {
  const Pose2 X_AR = Advance(X_AB, Part(path[blocker.arc], blocker.share));
  if (!blocker.wheel) return X_AR;
  const WheelPlan& wheel = wheels_[*blocker.wheel];
  double steer = OnArc(wheel, path[blocker.arc]).steer_rad;
  if (blocker.steered > 0.0) {
    steer += blocker.steered * (OnArc(wheel, path[blocker.arc + 1]).steer_rad - steer);
  }
  return X_AR * Pose2{wheel.p_RW.x(), wheel.p_RW.y(), steer};
}

double Cover::Overlap(const Blocker& blocker, const Pose2& X_AP) const {
  const Disc& disc = blocker.disc;
  const Vector2d p = Turn(X_AP.heading).Back() * (disc.centre - Vector2d(X_AP.x, X_AP.y));
  const double near_m = Reach(blocker) + disc.radius_m;
  if (p.squaredNorm() > near_m * near_m) return 0.0;
  if (blocker.wheel) return std::max(0.0, disc.radius_m + DepthIn(wheel_, p));
  double most = 0.0;
  for (const Polygon& part : body_) most = std::max(most, disc.radius_m + DepthIn(part, p));
  return most;
}

double Cover::Reach(const Blocker& blocker) const {
  return blocker.wheel ? wheel_reach_m_ : body_reach_m_;
}

std::optional<Blocker> Cover::Find(const std::vector<Arc>& path, const std::vector<Disc>& discs,
                                   int even) const {
  const std::vector<Pass> passes = Passes(path, discs);
  std::optional<Blocker> deepest;
  double most = 0.0;
  const auto Look = [&](const Pass& pass, const Blocker& blocker) {
    const double overlap_m = Overlap(blocker, PoseFrom(pass.X_AB, blocker, path));
    if (overlap_m <= most) return;
    most = overlap_m;
    deepest = blocker;
  };
  const auto LookAlong = [&](const std::optional<std::size_t>& wheel, const Vector2d& p_RP) {
    for (const Pass& pass : passes) {
      const double share = ShareNearest(path[pass.arc], p_RP, pass.p_RD);
      Look(pass, {pass.disc, pass.arc, share, wheel});
      for (int i = 0; i < even; ++i) Look(pass, {pass.disc, pass.arc, i / (even - 1.0), wheel});
    }
  };
  LookAlong(std::nullopt, middle_);
  for (std::size_t wheel = 0; wheel < wheels_.size() && !deepest; ++wheel) {
    LookAlong(wheel, wheels_[wheel].p_RW);
    for (const Pass& pass : passes) {
      for (int i = 1; i < kSteerings && pass.arc + 1 < path.size(); ++i) {
        Look(pass, {pass.disc, pass.arc, 1.0, wheel, static_cast<double>(i) / kSteerings});
      }
    }
  }
  return deepest;
}

std::vector<Cover::Pass> Cover::Passes(const std::vector<Arc>& path,
                                       const std::vector<Disc>& discs) const {
  std::vector<Pass> passes;
  Pose2 X_AR;
  for (std::size_t arc = 0; arc < path.size(); ++arc) {
    const SweptArc swept(X_AR, path[arc]);
    for (const Disc& disc : discs) {
      const Vector2d p_RD = swept.InR(disc.centre);
      const double near_m = reach_m_ + disc.radius_m;
      if (p_RD.norm() > std::abs(path[arc].length_m) + near_m) continue;
      if (swept.OfPart({0, 0}, {0, 0}, p_RD) > near_m) continue;
      passes.push_back({disc, arc, X_AR, p_RD});
    }
    X_AR = Advance(X_AR, path[arc]);
  }
  return passes;
}

std::vector<Disc> DiscsWithin(const Obstacles& obstacles, double margin_m) {
  std::vector<Disc> within;
  for (const Disc& disc : obstacles.discs) {
    within.push_back({disc.centre, disc.radius_m + margin_m});
  }
  for (const Polygon& polygon : obstacles.polygons) {
    std::vector<Disc> discs = InscribedDiscs(polygon);
    for (Disc& disc : discs) disc.radius_m += margin_m;
    within.insert(within.end(), discs.begin(), discs.end());
  }
  return within;
}

BlockerSearch::BlockerSearch(const RoverPlan& rover, const PathDemands& demands)
    : cover_(rover), discs_(DiscsWithin(demands.obstacles, demands.margin_m)) {
  if (demands.grid) grid_.emplace(discs_);
}

}  // namespace dockyard
