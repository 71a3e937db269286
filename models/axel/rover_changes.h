// What is built otherwise, on the tree of a rover's file.
#pragma once

#include "models/axel/axel_model.h"
#include "models/read/yaml_tree.h"

namespace dockyard::axel {

/// Writes the numbers that a file may leave out, so that what is built can deviate from them too.
void WriteLeftOut(const RoverModel& told, YamlNode& tree);

/// The tree of a rover that was read, with all keys of each wheel's motor written out.
YamlNode WithSideMotors(YamlNode tree);

/// As PutBuilt, on a tree that was read. The keys of one wheel's motor deviate from those of the
/// wheels' motor as built.
void PutBuiltRover(YamlNode& tree, const YamlNode& built);

}  // namespace dockyard::axel
