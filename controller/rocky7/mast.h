// The mast's geometry: shoulder roll about the body's z, shoulder and elbow pitch. Angles and frame
// K as NominalMast has them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "controller/geometry/pose.h"
#include "controller/rocky7/nominal/nominal.h"

namespace dockyard::rocky7 {

using MastAngles = std::array<double, kMastMotorCount>;  // in the order of MastMotor

/// X_RK, the second link in R. Its x axis is the tool's.
Pose3 SecondLink(const NominalMast& mast, const MastAngles& angles);
/// Middle of the instrument's face, in R.
Eigen::Vector3d FaceCentre(const NominalMast& mast, const MastAngles& angles);

/// Angles that bring the face's middle onto a point of R, with the elbow up. The tool's direction
/// follows. None out of reach, beyond the joints' limits, and above the shoulder, where every roll
/// would do.
std::optional<MastAngles> AnglesTo(const NominalMast& mast, const Eigen::Vector3d& p_RF);

/// Angles that bring the point to the middle between the two cameras' axes, with the first link
/// leaning forward by lean_rad from its nominal watch angle. The nearest within the joints' limits.
MastAngles AnglesToWatch(const NominalMast& mast, const Eigen::Vector3d& p_RT,
                         double lean_rad = 0.0);

/// How the rover must stand so that the tool meets a point with a given elevation.
struct Stance {
  double stand_off_m = 0.0;   // from the mast's axis to the point, in R's plan
  double tool_up_rad = 0.0;   // elevation of the tool's axis there
  double first_up_rad = 0.0;  // and of the first link
  double off_rad = 0.0;       // the tool's elevation less the one that was asked for
};

/// sin(first) = (up - l2 sin(tool)) / l1, stand-off = l1 cos(first) + l2 cos(tool). Where the tool
/// cannot have that elevation, the nearest one that it can have; none where it can have none.
/// @param up_m               of the point over the shoulder
/// @param least_stand_off_m  nearer the rover's wheels would touch what is there
std::optional<Stance> StanceFor(const NominalMast& mast, double up_m, double tool_up_rad,
                                double least_stand_off_m);

/// The angle between two directions of any length.
double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

}  // namespace dockyard::rocky7
