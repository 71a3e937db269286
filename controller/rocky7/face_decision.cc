#include "controller/rocky7/face_decision.h"

#include <algorithm>
#include <cmath>

#include "controller/rocky7/paths_to_point.h"
#include "controller/rocky7/touch_place.h"

namespace dockyard::rocky7 {
namespace {

// "Within one meter of goal" the rover stops and plans the two arcs (N, IV-B); it is there within
// this. Assumed, 10-40 cm.
constexpr double kBefore_m = 1.0, kBeforeWithin_m = 0.25;
// How far the tool may be off the normal for the placement to begin: as good as the detections are,
// and less asked for with each pair near by, as every correction stirs the soil. Assumed, 1-2,
// 0.2-0.5 and 3.5-4.5 deg; 5 are the aim, of which the normal's own error takes 1.
constexpr double kGoodOff_rad = Radians(1.2), kEachPair_rad = Radians(0.25),
                 kMostOff_rad = Radians(3.5);
// And where no path is expected to leave less: half of the 5 deg. Assumed, 2-3 deg.
constexpr double kGoodEnough_rad = Radians(2.5);
// In the first pairs near by the rover does not place with more than this, though the mast cannot
// follow the normal from the goal: an arc past the goal may bring the tool nearer to it. Assumed,
// 3.5-4.5 deg, as above, and 5-15 pairs.
constexpr double kMostLeft_rad = Radians(4.0);
constexpr int kNearerPairs = 8;
// What is left to the goal's pose before single corrections. Assumed, 8-20 cm.
constexpr double kCorrectsWithin_m = 0.12;

constexpr const char* kOutOfReach = "the mast does not reach the target from anywhere";

double StepOf(const FaceApproachOptions& options, double left_m) {
  return std::clamp(options.image_share * left_m, options.least_step_m, options.most_step_m);
}

// One arc brings the mast's axis to a place before the face.
FaceDecision DecideFar(const Nominal& nominal, const FaceApproachOptions& options,
                       const PlaceGoal& goal) {
  const auto arc = OneArcTo(goal.p_RM_goal, nominal.mast.p_RM.head<2>());
  if (!arc) return {.why_not = "no arc leads to the target"};
  const Arc whole = NoSharper(*arc, GentleLimits(nominal.plan));
  const double left_m = std::abs(whole.length_m);
  const double step_m = StepOf(options, left_m);
  return {.arcs = {step_m >= left_m ? whole : Part(whole, step_m / left_m)}};
}

FaceDecision DecideNear(const Nominal& nominal, const FaceApproachOptions& options,
                        const FaceBelief& belief, const FaceAt& face, double tool_off_rad,
                        const PlaceGoal& goal, FaceProgress& progress) {
  const double left_m = (goal.p_RM_goal - nominal.mast.p_RM.head<2>()).norm();
  progress.near_pairs += left_m < kCorrectsWithin_m;
  const double enough_rad =
      std::min(kMostOff_rad, kGoodOff_rad + kEachPair_rad * std::max(0, progress.near_pairs - 1));
  // What the mast cannot follow of the normal is left out.
  const FaceAt at_goal = SeenFrom(goal.X_RG, face);
  const double off_rad = std::abs(goal.stance.off_rad);
  const double unreachable_rad =
      options.corrects ? std::min(off_rad, PlaceToTouch(nominal.mast, at_goal).off_rad) : off_rad;
  const bool tries_nearer = options.corrects && progress.near_pairs <= kNearerPairs;
  const double left_rad = enough_rad + unreachable_rad;
  if (tool_off_rad < (tries_nearer ? std::min(left_rad, kMostLeft_rad) : left_rad)) return {};
  const Obstacles obstacles = DiscsOf(belief.obstacles_E);
  std::vector<Arc> path;
  if (options.corrects && left_m < kCorrectsWithin_m) {
    path = ArcsToCorrect(nominal, face, goal, obstacles);
    if (path.empty() && tool_off_rad < kGoodEnough_rad + unreachable_rad) return {};
  }
  if (path.empty()) path = ArcsToGoal(nominal, goal, obstacles);
  if (path.empty()) return {.why_not = "no arcs lead before the face"};
  progress.driven_all = !options.corrects;
  if (progress.driven_all) return {.arcs = path};
  // Parts of arcs forwards; those back are driven whole, as they only make room.
  const double whole_m = Length(path), step_m = StepOf(options, whole_m);
  if (whole_m - step_m < options.least_step_m) return {.arcs = path};
  const double first_m = path.front().length_m;
  return {.arcs = Truncate(path, first_m < 0.0 ? std::max(-first_m, options.least_step_m)
                                               : std::min(whole_m, step_m))};
}

}  // namespace

FaceDecision DecideNext(const Nominal& nominal, const FaceApproachOptions& options,
                        const FaceBelief& belief, const FaceAt& face, double tool_off_rad,
                        FaceProgress& progress) {
  const FaceAt toward = belief.IsNormalSure() ? face : LeaningBack(face);
  const double least_m = LeastStandOff(nominal, toward, belief.obstacles_E);
  const auto goal = GoalFor(nominal, toward, least_m, progress.near ? 0.0 : kBefore_m);
  if (!goal) return {.why_not = kOutOfReach};
  const Eigen::Vector2d p_RM = nominal.mast.p_RM.head<2>();
  if (!progress.near && (goal->p_RM_goal - p_RM).norm() > kBeforeWithin_m &&
      goal->p_RM_goal.x() > p_RM.x()) {
    return DecideFar(nominal, options, *goal);
  }
  progress.near = true;
  if (!belief.normal_E) return {.why_not = "the face's normal is not seen"};
  const auto place = GoalFor(nominal, face, LeastStandOff(nominal, face, belief.obstacles_E));
  if (!place) return {.why_not = kOutOfReach};
  return DecideNear(nominal, options, belief, face, tool_off_rad, *place, progress);
}

}  // namespace dockyard::rocky7
