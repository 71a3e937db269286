// A stereo pair's mapping in a robot's file.
#pragma once

#include <string>

#include "models/parts/cameras.h"
#include "models/read/yaml_reader.h"

namespace dockyard {

/// Pixels of an image.
struct PictureSize {
  int width = 0, height = 0;
};

/// Reads the mapping under `key`. `size` 0: that of `cameras.file`, or else `usual`. Throws
/// ConfigError.
StereoModel ReadStereo(const YamlReader& root, const PictureSize& size, const PictureSize& usual,
                       const std::string& key = "cameras");

/// The pair turned and shifted as the mountings of `stereo` say.
StereoRig MountedRig(const StereoRig& rig, const StereoModel& stereo);

}  // namespace dockyard
