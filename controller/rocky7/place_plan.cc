#include "controller/rocky7/place_plan.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/motion/free_path.h"
#include "controller/rocky7/paths_to_point.h"
#include "controller/rocky7/touch_place.h"

namespace dockyard::rocky7 {
namespace {

// Wheels and body keep off what stands out by this at the goal, and on the way. Assumed, 4-8 and
// 1-4 cm.
constexpr double kOffAtGoal_m = 0.05, kOffOnWay_m = 0.02;
constexpr double kCellDisc_m = 0.028;  // about a cell of 4 cm: half its diagonal
// Corrections: single arcs to either side up to this, in such steps. Assumed, 0.1-0.3 m, 3-10 mm.
constexpr double kCorrection_m = 0.2, kCorrectionStep_m = 0.005;
constexpr int kCorrectionCurvatures = 8;  // to either side
// A normal steeper than this belongs to a top. Assumed, 65-80 deg.
constexpr double kTop_rad = Radians(72.0);
// A metre of path must make the tool better by this: it ends off by 8 cm (kSlipSigma, odometry.h),
// and a centimetre turns the tool by 0.6 deg at a reach of 0.94 m. Assumed, 3-8 deg.
constexpr double kPerMetre_rad = Radians(5.0);
// The same for each arc, as its start and its stop move the rover by half a centimetre. Assumed,
// 0.1-0.6 deg.
constexpr double kPerArc_rad = Radians(0.3);
// The heading may be off the normal's azimuth by this after a correction. Assumed, 15-40 deg.
constexpr double kMostAside_rad = Radians(25.0);
// A pair this much longer than the way is a detour: three arcs are shorter. Assumed, 1.5-4.
constexpr double kDetour = 2.0;

// Which way the rover comes: along the inward normal; to a top, whose normal has no azimuth to
// speak of, along the line of sight.
Eigen::Vector2d Ahead(const FaceAt& face) {
  const Eigen::Vector2d inward = -face.normal_R.head<2>();
  if (inward.norm() > std::cos(kTop_rad) * face.normal_R.norm()) return inward.normalized();
  return face.p_RT.head<2>().normalized();
}

double AzimuthOf(const FaceAt& face) {
  const Eigen::Vector2d ahead = Ahead(face);
  return std::atan2(ahead.y(), ahead.x());
}

// The front edge and half the width, from R.
std::pair<double, double> FrontOf(const RoverPlan& plan) {
  double front_m = 0.0, half_width_m = 0.0;
  for (const WheelPlan& wheel : plan.wheels) {
    front_m = std::max(front_m, wheel.p_RW.x() + plan.wheel_radius_m);
    half_width_m = std::max(half_width_m, std::abs(wheel.p_RW.y()) + 0.5 * plan.wheel_width_m);
  }
  for (const Polygon& part : plan.body) {
    for (const Eigen::Vector2d& corner : part) front_m = std::max(front_m, corner.x());
  }
  return {front_m, half_width_m};
}

bool IsClear(const Nominal& nominal, const std::vector<Arc>& path, const Obstacles& obstacles) {
  return Clearance(nominal.plan, path, obstacles, kOffOnWay_m) >= kOffOnWay_m;
}

}  // namespace

double LeastStandOff(const Nominal& nominal, const FaceAt& face,
                     const std::vector<Eigen::Vector2d>& stands_out_R) {
  const auto [front_m, half_width_m] = FrontOf(nominal.plan);
  const Eigen::Vector2d ahead = Ahead(face);
  double nearest_m = 0.0;  // along the way, from the target; below 0 before it
  for (const Eigen::Vector2d& place : stands_out_R) {
    const Eigen::Vector2d from = place - face.p_RT.head<2>();
    const double aside_m = std::abs(ahead.x() * from.y() - ahead.y() * from.x());
    if (aside_m > half_width_m + kOffAtGoal_m) continue;
    nearest_m = std::min(nearest_m, from.dot(ahead) - kCellDisc_m);
  }
  return front_m - nominal.mast.p_RM.x() + kOffAtGoal_m - nearest_m;
}

std::optional<PlaceGoal> GoalFor(const Nominal& nominal, const FaceAt& face,
                                 double least_stand_off_m, double short_m) {
  const double normal_up_rad = std::atan2(face.normal_R.z(), face.normal_R.head<2>().norm());
  const auto stance = StanceFor(nominal.mast, face.p_RT.z() - nominal.mast.p_RM.z(), -normal_up_rad,
                                least_stand_off_m);
  if (!stance) return std::nullopt;
  PlaceGoal goal;
  goal.stance = *stance;
  goal.p_RM_goal = face.p_RT.head<2>() - (stance->stand_off_m + short_m) * Ahead(face);
  const double azimuth_rad = AzimuthOf(face);
  const Pose2 turn{0.0, 0.0, azimuth_rad};
  const Eigen::Vector2d p_RG = goal.p_RM_goal - turn * Eigen::Vector2d(nominal.mast.p_RM.head<2>());
  goal.X_RG = {p_RG.x(), p_RG.y(), azimuth_rad};
  return goal;
}

std::vector<Eigen::Vector2d> NotOurselves(const Nominal& nominal,
                                          const std::vector<Eigen::Vector2d>& places_R) {
  const auto [front_m, half_width_m] = FrontOf(nominal.plan);
  std::vector<Eigen::Vector2d> others;
  for (const Eigen::Vector2d& place : places_R) {
    const bool ours =
        place.x() < front_m + kCellDisc_m && std::abs(place.y()) < half_width_m + kCellDisc_m;
    if (!ours) others.push_back(place);
  }
  return others;
}

Obstacles DiscsOf(const std::vector<Eigen::Vector2d>& stands_out_R) {
  Obstacles obstacles;
  for (const Eigen::Vector2d& place : stands_out_R) {
    obstacles.discs.push_back({place, kCellDisc_m});
  }
  return obstacles;
}

std::vector<Arc> ArcsToGoal(const Nominal& nominal, const PlaceGoal& goal,
                            const Obstacles& obstacles) {
  const ArcLimits limits = GentleLimits(nominal.plan);
  const PathDemands demands{.obstacles = obstacles, .margin_m = kOffOnWay_m};
  std::vector<Arc> path;
  if (const auto pair = CheapestFreePair(nominal.plan, goal.X_RG, limits, demands)) {
    path.assign(pair->begin(), pair->end());
    const double way_m = std::hypot(goal.X_RG.x, goal.X_RG.y);
    if (Length(path) <= kDetour * way_m) return path;
  }
  if (const auto triple = ShortestFreeTriple(nominal.plan, goal.X_RG, limits, demands)) {
    path.assign(triple->begin(), triple->end());
  }
  return path;
}

std::vector<Arc> ArcsToCorrect(const Nominal& nominal, const FaceAt& face, const PlaceGoal& goal,
                               const Obstacles& obstacles) {
  const ArcLimits limits = GentleLimits(nominal.plan);
  const auto aside = [&](const std::vector<Arc>& path) {
    return std::abs(WrapPi(Advance({}, path).heading - goal.X_RG.heading));
  };
  const auto off = [&](const std::vector<Arc>& path) {
    return PlaceToTouch(nominal.mast, SeenFrom(Advance({}, path), face)).off_rad;
  };
  // Standing still costs what the tool is off; a way must be worth the soil that it stirs.
  std::vector<Arc> best;
  double best_cost = off({});
  const auto consider = [&](const std::vector<Arc>& path) {
    const double arcs = static_cast<double>(path.size());
    const double cost = off(path) + kPerMetre_rad * Length(path) + kPerArc_rad * arcs;
    if (path.empty() || cost >= best_cost || aside(path) > kMostAside_rad) return;
    if (!IsClear(nominal, path, obstacles)) return;
    best = path;
    best_cost = cost;
  };
  const int steps = static_cast<int>(std::lround(kCorrection_m / kCorrectionStep_m));
  for (int i = -steps; i <= steps; ++i) {
    for (int k = -kCorrectionCurvatures; k <= kCorrectionCurvatures && i != 0; ++k) {
      const double length_m = i * kCorrectionStep_m;
      const double curvature = k / (kCorrectionCurvatures * limits.least_radius_m);
      consider({{length_m, length_m * curvature}});
    }
  }
  consider(ArcsToPoint(goal.p_RM_goal, nominal.mast.p_RM.head<2>(), limits));
  consider(ArcsToGoal(nominal, goal, obstacles));
  return best;
}

}  // namespace dockyard::rocky7
