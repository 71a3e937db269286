// Stereo pairs and single cameras as they are built, and their sensors.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "models/parts/camera_model.h"
#include "models/parts/cameras.h"
#include "render/colour_sensor.h"
#include "render/stereo_renderer.h"
#include "sim/base/random.h"

namespace dockyard {

/// The nominal rig with the manufacturing errors of this run (1 sigma each from the robot's file).
/// The controller keeps the nominal rig. `stream`: of the run's seed, another for each pair.
StereoRig BuiltRig(const StereoModel& stereo, const Seed& run_seed,
                   const std::string& stream = "calibration");

/// What the lenses of the left and the right camera do beyond their model, in this run.
std::array<LensRipple, 2> BuiltRipples(const StereoModel& stereo, const Seed& run_seed,
                                       const std::string& stream = "calibration");

/// The pair's sensor, for image number index of a run.
SensorOptions CameraSensor(const StereoModel& stereo, const Seed& run_seed, int index);

/// A single camera with the manufacturing errors of this run.
struct BuiltOne {
  Camera camera;
  Pose3 X_LC;           // in its link
  LensRipple ripple{};  // beyond the lens's model
};
BuiltOne BuiltCamera(const CameraModel& model, const Seed& run_seed, const std::string& stream);

/// Its sensor for image number index. `stream`: of the run's seed, another for each camera.
SensorOptions CameraSensor(const CameraModel& model, const Seed& run_seed, int index,
                           const std::string& stream);
/// That of a colour camera, which sets its own white balance.
ColourSensorOptions ColourSensorOf(const CameraModel& model);

/// `kept` where the image before sets the exposure, else null.
KeptExposure* ExposureBefore(const SensorModel& model, KeptExposure& kept);

/// Throws ConfigError when an image of this camera reaches further from the lens's axis than the
/// renderer draws (docs/reference/images.md). The message begins with `place`.
void CheckImageCanBeDrawn(const Camera& camera, const std::string& place);
/// The same of both cameras.
void CheckImagesCanBeDrawn(const StereoRig& rig, const std::string& place);

}  // namespace dockyard
