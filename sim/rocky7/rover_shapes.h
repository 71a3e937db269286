// Meshes of a rover on wheels, made of the numbers of its file: for pictures alone.
#pragma once

#include <string>
#include <vector>

#include "models/parts/mesh.h"
#include "models/parts/rover_model.h"
#include "sim/vehicles/wheeled_body.h"

namespace dockyard::rocky7 {

/// What a link looks like, and by which name a spectator knows it.
struct LinkLook {
  std::string name;
  std::vector<Visual> visuals;
};

/// By link of the rover's tree.
std::vector<LinkLook> LooksOf(const RoverModel& rover, const WheeledBody& body);

}  // namespace dockyard::rocky7
