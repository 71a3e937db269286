// models/raposa/pyramid/pyramid.yaml and the URDF that it names -> PyramidModel.
#pragma once

#include <string>

#include "models/raposa/pyramid_model.h"
#include "models/read/as_built.h"
#include "models/read/keys.h"
#include "models/read/mesh_loader.h"

namespace dockyard::raposa {

/// Names every key of the file.
void VisitPyramidKeys(Keys& keys);

/// The URDF must have one link, 'pyramid', in the frame P. `changes` are keys on top of the file's.
/// Throws ConfigError.
PyramidModel LoadPyramid(const std::string& file, const ModelChanges& changes = {},
                         MeshStore* meshes = nullptr);

}  // namespace dockyard::raposa
