// A dock's file -> DockModel.
#pragma once

#include <string>

#include "models/custom/dock_model.h"
#include "models/read/as_built.h"
#include "models/read/keys.h"
#include "models/read/mesh_loader.h"

namespace dockyard::custom {

/// `changes` are keys on top of the file's. Throws ConfigError.
DockModel LoadDock(const std::string& file, const ModelChanges& changes = {},
                   MeshStore* meshes = nullptr);
/// Names every key of a dock's file.
void VisitDockKeys(Keys& keys);
/// Whether the root has a dock's keys.
bool IsDockFile(const YamlNode& root);

}  // namespace dockyard::custom
