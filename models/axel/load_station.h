// models/<station>/<station>.yaml and the URDF that it names -> StationModel.
#pragma once

#include <string>

#include "models/axel/station_model.h"
#include "models/read/as_built.h"
#include "models/read/keys.h"
#include "models/read/mesh_loader.h"

namespace dockyard::axel {

/// Names every key of a file with the board inline.
void VisitStationKeys(Keys& keys);

/// The URDF must have the root link stand (feet and legs; no mass, the module's counts for all),
/// the link module and between them the joint tilt_joint (revolute about +y) at the centre of the
/// cone's mouth, straight above the stand's origin. Throws ConfigError, also when a fiducial
/// overlaps the mouth's face, another fiducial or the board's edge. `changes` are keys on top of
/// the file's. `docked_by`: the rover for whose axle `mouth_height_m: from_axle` sets the mouth;
/// without one the URDF's height stands.
StationModel LoadStation(const std::string& file, const ModelChanges& changes = {},
                         MeshStore* meshes = nullptr, const RoverModel* docked_by = nullptr);

}  // namespace dockyard::axel
