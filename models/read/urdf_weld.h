// Links on fixed joints become part of the link that carries them.
#pragma once

#include <string>
#include <vector>

#include "models/read/urdf.h"

namespace dockyard {

/// The link that carries `link` over fixed joints alone: itself when it is the root or hangs on a
/// moving joint. The model must be a tree, as LoadUrdf gives it.
std::string CarrierOf(const UrdfModel& model, const std::string& link);
/// The link's own frame F in its carrier's frame C.
Pose3 FrameInCarrier(const UrdfModel& model, const std::string& link);

/// The same robot without fixed joints. Every link on one, or on a chain of them, is welded into
/// its carrier: masses added, one centre of mass, inertia about it (parallel axes), visuals and
/// collisions placed in the carrier's frame after its own. Joints that move are placed in the
/// frames of the links that are left. A link without mass adds none. Links that carry nothing and
/// joints between such links keep every bit. Link frames, [kg, m, kg m^2].
UrdfModel WeldFixedLinks(const UrdfModel& model);

/// The link of a welded model, which must have a mass and three moments: it moves. Throws
/// ConfigError with its line where it has none.
const LinkModel& RequireInertial(const UrdfModel& welded, const std::string& link);

/// Throws ConfigError for a joint that damps, rubs or follows another: a motor's friction is in the
/// robot's YAML file.
void RequirePlain(const UrdfJoint& joint);

/// Throws ConfigError, with its line, for the first joint of a welded model that is none of these,
/// or that is one and not plain;
/// `simulated` names the simulated ones: "a body, two wheels and an arm".
void RequireJoints(const UrdfModel& welded, const std::vector<std::string>& joints,
                   const std::string& simulated);

}  // namespace dockyard
