// Numbers that both the rover's YAML and its URDF hold.
#pragma once

#include "models/axel/axel_model.h"
#include "models/read/read_stereo.h"
#include "models/read/yaml_reader.h"

namespace dockyard::axel {

/// The URDF holds some numbers for other tools that the YAML holds for the soil and the cone. They
/// must agree to 1 mm: a collision cylinder named "tip" and each wheel's largest collision
/// cylinder. `root`: the rover's file. Throws ConfigError.
void RequireAgreement(const YamlReader& root, const RoverModel& rover);

/// Lets the links of a rover whose numbers were changed follow them: wheels grow with their radius
/// and width, the arm's parts stand further out by what it is longer. Masses stay, moments of
/// inertia too. `drawn`: the rover that the URDF was drawn for. Throws ConfigError for a shape that
/// cannot follow.
void FitLinks(const YamlReader& root, const RoverModel& drawn, RoverModel& rover);

/// Lets the drawn heads of the cameras follow them: the collisions "left_head" and "right_head" of
/// the body, both halves of its visual "camera_heads", left at y > 0, and of "camera_posts", whose
/// feet keep their height. Where a pair has a rig's file they stay. `drawn`: the cameras that the
/// URDF was drawn for.
void FitCameraHeads(const StereoFile& drawn, const StereoFile& cameras, LinkModel& body);

}  // namespace dockyard::axel
