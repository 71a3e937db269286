// Where the rover must stand to place the instrument on a face, and arcs that lead there. Nesnas,
// Maimone and Das (ICRA 2000), sections III-C and IV-B.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "controller/motion/arcs.h"
#include "controller/motion/clearance.h"
#include "controller/rocky7/face_at.h"
#include "controller/rocky7/mast.h"

namespace dockyard::rocky7 {

/// The stand-off from the mast's axis at which the wheels keep off what stands out; the rover comes
/// along the inward normal.
double LeastStandOff(const Nominal& nominal, const FaceAt& face,
                     const std::vector<Eigen::Vector2d>& stands_out_R);

struct PlaceGoal {
  Pose2 X_RG;                       // of R at the goal: its heading is the inward normal's
  Eigen::Vector2d p_RM_goal{0, 0};  // the mast's axis there
  Stance stance;
};
/// None where the tool does not reach the point at any tilt.
/// @param short_m  so much further from the point
std::optional<PlaceGoal> GoalFor(const Nominal& nominal, const FaceAt& face,
                                 double least_stand_off_m, double short_m = 0.0);

/// Without what lies within the rover's own outline, its wheels steered either way.
std::vector<Eigen::Vector2d> NotOurselves(const Nominal& nominal,
                                          const std::vector<Eigen::Vector2d>& places_R);

/// What stands out, as discs.
Obstacles DiscsOf(const std::vector<Eigen::Vector2d>& stands_out_R);

/// Two arcs to the goal's pose, else three, clear of the obstacles; none where there are none.
std::vector<Arc> ArcsToGoal(const Nominal& nominal, const PlaceGoal& goal,
                            const Obstacles& obstacles);

/// Few arcs after which the tool is little off the normal, as the mast's roll takes up what the
/// heading is off. None where nothing is better than to stand still.
std::vector<Arc> ArcsToCorrect(const Nominal& nominal, const FaceAt& face, const PlaceGoal& goal,
                               const Obstacles& obstacles);

}  // namespace dockyard::rocky7
