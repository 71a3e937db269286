// The mapping `cameras` of a rover's file.
#pragma once

#include "models/parts/cameras.h"
#include "models/read/yaml_reader.h"

namespace dockyard::axel {

/// Reads `cameras` of the rover's file. The images' size as of LoadRover. Throws ConfigError.
StereoModel ReadStereo(const YamlReader& root, int width, int height);

/// The pair turned and shifted as the mountings of `stereo` say.
StereoRig MountedRig(const StereoRig& rig, const StereoModel& stereo);

}  // namespace dockyard::axel
