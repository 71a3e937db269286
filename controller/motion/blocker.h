// Where an obstacle blocks a path, so that paths near by are known to be blocked there, too,
// without a look at the rest of them.
#pragma once

#include <optional>
#include <vector>

#include "controller/geometry/rover_plan.h"
#include "controller/motion/arcs.h"
#include "controller/motion/free_path.h"

namespace dockyard {

/// A disc within an obstacle that is grown by a margin, and a part of the rover at a place on a
/// path.
struct Blocker {
  Disc disc{};
  std::size_t arc = 0;
  double share = 0.0;                  // of the arc, up to the place
  std::optional<std::size_t> wheel{};  // a steered one; none: what moves with R
  double steered = 0.0;                // share of the steering to the next arc that is done
};

/// The rover in two parts: what moves with R, and each wheel that is steered.
class Cover {
 public:
  explicit Cover(const RoverPlan& rover);

  /// Of the blocker's part at its place on a path: R's or the wheel's pose.
  Pose2 PoseOf(const Blocker& blocker, const std::vector<Arc>& path) const;
  /// How far the part at X_AP must be moved, at least, to be free of the disc [m]; 0 where it is.
  double Overlap(const Blocker& blocker, const Pose2& X_AP) const;
  /// From the part's frame to its farthest point [m].
  double Reach(const Blocker& blocker) const;

  /// The deepest overlap among the places where the body's middle or a wheel is nearest to a disc,
  /// and so many even ones on each arc. None is found where the path is free, and where it is
  /// blocked by little.
  std::optional<Blocker> Find(const std::vector<Arc>& path, const std::vector<Disc>& discs,
                              int even) const;
  /// The same among a grid's discs.
  std::optional<Blocker> Find(const std::vector<Arc>& path, const DiscGrid& discs, int even) const {
    return Find(path, discs.Near(path, reach_m_), even);
  }

 private:
  /// A disc that the rover may come near on an arc.
  struct Pass {
    Disc disc;
    std::size_t arc = 0;
    Pose2 X_AB;                  // R as the arc begins
    Eigen::Vector2d p_RD{0, 0};  // likewise
  };
  // X_AB: R as the blocker's arc begins.
  Pose2 PoseFrom(const Pose2& X_AB, const Blocker& blocker, const std::vector<Arc>& path) const;
  std::vector<Pass> Passes(const std::vector<Arc>& path, const std::vector<Disc>& discs) const;

  std::vector<Polygon> body_;  // and fixed wheels
  std::vector<WheelPlan> wheels_;
  Polygon wheel_;
  Eigen::Vector2d middle_{0, 0};  // of the body's first part
  double body_reach_m_ = 0.0, wheel_reach_m_ = 0.0, reach_m_ = 0.0;
};

/// Discs that lie within the obstacles grown by the margin: all discs, and some of each polygon.
std::vector<Disc> DiscsWithin(const Obstacles& obstacles, double margin_m);

/// What blocks paths of one rover among obstacles.
class BlockerSearch {
 public:
  BlockerSearch(const RoverPlan& rover, const PathDemands& demands);

  const Cover& cover() const { return cover_; }
  /// As Cover::Find.
  std::optional<Blocker> Find(const std::vector<Arc>& path, int even) const {
    return grid_ ? cover_.Find(path, *grid_, even) : cover_.Find(path, discs_, even);
  }

 private:
  Cover cover_;
  std::vector<Disc> discs_;
  std::optional<DiscGrid> grid_;  // of the same discs, where the demands have one
};

}  // namespace dockyard
