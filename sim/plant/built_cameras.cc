#include "sim/plant/built_cameras.h"

#include <cmath>
#include <cstdio>

#include "controller/base/split_mix.h"
#include "models/read/config_error.h"
#include "render/fisheye_warp.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

Camera BuiltCamera(const Camera& camera, const StereoModel& stereo, RandomStream& random) {
  const double scale = 1.0 + stereo.focal_sigma * random.Normal();
  const double du = stereo.centre_sigma_px * random.Normal();
  const double dv = stereo.centre_sigma_px * random.Normal();
  return Adjusted(camera, scale, {du, dv});
}

/// Drawn after all the rest, so that a run keeps its other errors whatever this one is.
Camera BentCamera(const Camera& camera, const StereoModel& stereo, RandomStream& random) {
  return Bent(camera, stereo.radial_sigma_px * random.Normal());
}

Pose3 Turned(Pose3 X_RC, double about_x, double about_y, double about_z) {
  X_RC.R = X_RC.R * RotY(about_y) * RotX(about_x) * RotZ(about_z);
  return X_RC;
}

}  // namespace

StereoRig BuiltRig(const StereoModel& stereo, const Seed& run_seed, const std::string& stream) {
  RandomStream random(StreamKey(run_seed, stream));
  StereoRig built = stereo.nominal;
  const double s = stereo.rotation_sigma_rad;
  built.left = BuiltCamera(built.left, stereo, random);
  built.right = BuiltCamera(built.right, stereo, random);
  // A camera's y axis points down: a turn about it is the camera's yaw.
  const double yaw = stereo.relative_yaw_sigma_rad * random.Normal();
  const double left_x = s * random.Normal(), left_z = s * random.Normal();
  const double right_x = s * random.Normal(), right_z = s * random.Normal();
  built.left = BentCamera(built.left, stereo, random);
  built.right = BentCamera(built.right, stereo, random);
  built.X_RL = Turned(built.X_RL, left_x, -0.5 * yaw, left_z);
  built.X_RQ = Turned(built.X_RQ, right_x, 0.5 * yaw, right_z);
  return built;
}

SensorOptions CameraSensor(const StereoModel& stereo, const Seed& run_seed, int index) {
  const ExposureModel& exposure = stereo.exposure;
  constexpr double kTurns[3] = {0.0, -1.0, 1.0};
  const bool bracketed = exposure.rule == ExposureRule::kBracketed;
  return {.full_well_e = stereo.full_well_e,
          .read_noise_e = stereo.read_noise_e,
          .response_sigma = stereo.response_sigma,
          .bits = stereo.bits,
          .vignetting_exponent = stereo.vignetting_exponent,
          .blur_sigma_px = stereo.blur_sigma_px,
          .focus = {.focal_length_m = stereo.focus.focal_length_m,
                    .f_number = stereo.focus.f_number,
                    .distance_m = stereo.focus.distance_m,
                    .pixel_pitch_m = stereo.focus.pixel_pitch_m},
          .exposure_percent = exposure.percent,
          .target_level = exposure.level,
          .fixed_exposure_e = exposure.fixed_e,
          .exposure_stops = bracketed ? exposure.bracket_stops * kTurns[index % 3] : 0.0,
          .noise_key = SplitMix(StreamKey(run_seed, "camera"), static_cast<std::uint64_t>(index)),
          .pattern_key = StreamKey(run_seed, "response")};
}

void CheckImagesCanBeDrawn(const StereoRig& rig, const std::string& place) {
  for (const Camera* camera : {&rig.left, &rig.right}) {
    for (const double u : {-0.5, camera->width - 0.5}) {
      for (const double v : {-0.5, camera->height - 0.5}) {
        const Eigen::Vector3d ray = camera->Direction({u, v});
        const double angle = std::atan2(std::hypot(ray.x(), ray.y()), ray.z());
        if (angle <= kWidestDrawn_rad) continue;
        char text[160];
        std::snprintf(text, sizeof text,
                      ": expected all pixels within %.0f deg of the lens's axis, at %d x %d a "
                      "corner is %.0f deg off it",
                      Degrees(kWidestDrawn_rad), camera->width, camera->height, Degrees(angle));
        throw ConfigError(place + text);
      }
    }
  }
}

}  // namespace dockyard
