// One planning of a path, from its task to the path of least cost among all candidates: Nesnas,
// Maimone and Das (ICRA 2000), section III.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/motion/free_path.h"
#include "controller/motion/steering.h"

namespace dockyard {

/// Frame A: R before it moves.
struct PathTask {
  RoverPlan rover{};                // without a body and wheels: a point
  Eigen::Vector2d p_RP{0, 0};       // the point to bring to the goal
  Eigen::Vector2d p_AG{0, 0};       // the goal
  std::optional<double> heading{};  // of R at the goal [rad]; none: any, and one arc
  ArcLimits limits{};
  PathDemands demands{};
  int arcs = 2;  // 2 or 3, to a heading
};

/// A path that was thought of.
struct Candidate {
  std::vector<Arc> arcs;
  double cost_m = 0.0;     // by Eq. (14); of one arc and of three their length
  bool keeps = true;       // the limits
  double missing_m = 0.0;  // of the demands

  bool IsUsable() const { return keeps && missing_m == 0.0; }
};

struct PlannedPath {
  std::vector<Candidate> candidates;  // of one and of two arcs; not of three
  std::optional<Candidate> best;
};

PlannedPath PlanPath(const PathTask& task);

/// Lengths, turns and the cost in a line.
std::string Words(const PlannedPath& plan);

/// R's pose at the goal, Eq. (13). The task must have a heading.
Pose2 GoalPose(const PathTask& task);

/// R's poses along a path, at most step_m and step_rad apart, its ends and joints among them.
std::vector<Pose2> PosesAlong(const std::vector<Arc>& path, double step_m, double step_rad);

}  // namespace dockyard
