// A stereo pair's mapping in a robot's file.
#pragma once

#include <string>

#include "models/parts/cameras.h"
#include "models/read/keys.h"

namespace dockyard {

/// Pixels of an image.
struct PixelSize {
  int width = 0, height = 0;
};

/// A pair's mapping: its rig's file, or else the numbers of a rig side by side.
struct StereoFile {
  StereoModel stereo;  // without its nominal rig
  std::string rig;     // empty: none
  PixelSize size;      // 0: the usual one
  double field_of_view_rad = 0.0, baseline_m = 0.0, forward_m = 0.0, height_m = 0.0;
  double pitch_rad = 0.0;
};
/// Names the mapping under `key`.
void VisitStereo(Keys& keys, const char* key, StereoFile& file);
/// `size` 0: that of the rig's file, of the mapping, or else `usual`. Throws ConfigError.
StereoModel StereoOf(const StereoFile& file, const PixelSize& size, const PixelSize& usual);

/// The pair turned and shifted as the mountings of `stereo` say.
StereoRig MountedRig(const StereoRig& rig, const StereoModel& stereo);

}  // namespace dockyard
