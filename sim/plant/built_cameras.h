// A stereo pair as it is built, and its sensor.
#pragma once

#include <cstdint>
#include <string>

#include "models/parts/cameras.h"
#include "render/stereo_renderer.h"
#include "sim/base/random.h"

namespace dockyard {

/// The nominal rig with the manufacturing errors of this run (1 sigma each from the robot's file).
/// The controller keeps the nominal rig. `stream`: of the run's seed, another for each pair.
StereoRig BuiltRig(const StereoModel& stereo, const Seed& run_seed,
                   const std::string& stream = "calibration");

/// The pair's sensor, for image number index of a run.
SensorOptions CameraSensor(const StereoModel& stereo, const Seed& run_seed, int index);

/// Throws ConfigError when an image of these cameras reaches further from a lens's axis than the
/// renderer draws (docs/reference/images.md). The message begins with `place`.
void CheckImagesCanBeDrawn(const StereoRig& rig, const std::string& place);

}  // namespace dockyard
