#include "sim/plant/built_cameras.h"

#include <cmath>
#include <cstdio>

#include "controller/base/split_mix.h"
#include "models/read/config_error.h"
#include "render/fisheye_warp.h"
#include "render/video_fields.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

Camera BuiltLens(const Camera& camera, const LensErrors& errors, RandomStream& random) {
  const double scale = 1.0 + errors.focal_sigma * random.Normal();
  const double du = errors.centre_sigma_px * random.Normal();
  const double dv = errors.centre_sigma_px * random.Normal();
  return Adjusted(camera, scale, {du, dv});
}

/// Drawn after all the rest, so that a run keeps its other errors whatever this one is.
Camera BentCamera(const Camera& camera, const LensErrors& errors, RandomStream& random) {
  return Bent(camera, errors.radial_sigma_px * random.Normal());
}

/// A steeper ripple would bring two pixels the same ray, or nearly: this one's slope is below 1/2.
void CheckRipple(const Camera& camera, double rms_px) {
  constexpr double kMostOfHalfDiagonal = 0.005;
  const double most_px = kMostOfHalfDiagonal * 0.5 * std::hypot(camera.width, camera.height);
  if (rms_px <= most_px) return;
  char text[160];
  std::snprintf(text, sizeof text,
                "as_built.ripple_px: expected at most %.2f px, a 400th of the diagonal of %d x %d "
                "pixels, found %.2f",
                most_px, camera.width, camera.height, rms_px);
  throw ConfigError(text);
}

/// A ripple of 2 to 3 rings over half the image's diagonal, and three waves of 1 to 2.5 turns in
/// it: residuals of parametric models have such patterns (Schoeps et al., Why Having 10,000
/// Parameters in Your Camera Model Is Better Than Twelve, CVPR 2020, figure 1); the numbers are
/// assumed. The stream is its own, so that a run keeps its other errors.
LensRipple DrawnRipple(const Camera& camera, double rms_px, const Seed& run_seed,
                       const std::string& stream) {
  if (rms_px == 0.0) return {};
  CheckRipple(camera, rms_px);
  RandomStream random(StreamKey(run_seed, stream + " ripple"));
  LensRipple ripple;
  ripple.ring_px = 1.0;
  ripple.ring_turns = random.Uniform(2.0, 3.0);
  ripple.ring_phase_rad = random.Uniform(0.0, 2.0 * kPi);
  for (LensRipple::Wave& wave : ripple.waves) {
    const double towards = random.Uniform(0.0, 2.0 * kPi);
    const double shifted = random.Uniform(0.0, 2.0 * kPi);
    wave.turns = random.Uniform(1.0, 2.5) * Eigen::Vector2d(std::cos(towards), std::sin(towards));
    wave.shift_px = {std::cos(shifted), std::sin(shifted)};
    wave.phase_rad = random.Uniform(0.0, 2.0 * kPi);
  }
  return ScaledTo(ripple, camera.width, camera.height, rms_px);
}

Pose3 Turned(Pose3 X_RC, double about_x, double about_y, double about_z) {
  X_RC.R = X_RC.R * RotY(about_y) * RotX(about_x) * RotZ(about_z);
  return X_RC;
}

static_assert(kFieldPeriod_s == kFieldApart_s);

SensorOptions SensorOf(const SensorModel& model, int index, std::uint64_t noise_stream,
                       std::uint64_t pattern_stream) {
  const ExposureModel& exposure = model.exposure;
  constexpr double kTurns[3] = {0.0, -1.0, 1.0};
  const bool bracketed = exposure.rule == ExposureRule::kBracketed;
  return {.full_well_e = model.full_well_e,
          .read_noise_e = model.read_noise_e,
          .response_sigma = model.response_sigma,
          .bits = model.bits,
          .vignetting_exponent = model.vignetting_exponent,
          .blur_sigma_px = model.blur_sigma_px,
          .focus = {.focal_length_m = model.focus.focal_length_m,
                    .f_number = model.focus.f_number,
                    .distance_m = model.focus.distance_m,
                    .pixel_pitch_m = model.focus.pixel_pitch_m},
          .video = {.noise_share = model.video.noise_share,
                    .line_jitter_px = model.video.line_jitter_px,
                    .interlaced = model.video.fields == VideoFields::kInterlaced},
          .defects = {.hot_share = model.defects.hot_share,
                      .hot_dark_e = model.defects.hot_rate_e_per_s * model.shutter_s,
                      .hot_offset_e = model.defects.hot_offset_e,
                      .dead_share = model.defects.dead_share},
          .exposure_percent = exposure.percent,
          .target_level = exposure.level,
          .fixed_exposure_e = exposure.fixed_e,
          .exposure_stops = bracketed ? exposure.bracket_stops * kTurns[index % 3] : 0.0,
          .noise_key = SplitMix(noise_stream, static_cast<std::uint64_t>(index)),
          .pattern_key = pattern_stream};
}

}  // namespace

StereoRig BuiltRig(const StereoModel& stereo, const Seed& run_seed, const std::string& stream) {
  RandomStream random(StreamKey(run_seed, stream));
  StereoRig built = stereo.nominal;
  const double s = stereo.rotation_sigma_rad;
  built.left = BuiltLens(built.left, stereo.lens, random);
  built.right = BuiltLens(built.right, stereo.lens, random);
  // A camera's y axis points down: a turn about it is the camera's yaw.
  const double yaw = stereo.relative_yaw_sigma_rad * random.Normal();
  const double left_x = s * random.Normal(), left_z = s * random.Normal();
  const double right_x = s * random.Normal(), right_z = s * random.Normal();
  built.left = BentCamera(built.left, stereo.lens, random);
  built.right = BentCamera(built.right, stereo.lens, random);
  built.X_RL = Turned(built.X_RL, left_x, -0.5 * yaw, left_z);
  built.X_RQ = Turned(built.X_RQ, right_x, 0.5 * yaw, right_z);
  return built;
}

std::array<LensRipple, 2> BuiltRipples(const StereoModel& stereo, const Seed& run_seed,
                                       const std::string& stream) {
  const double rms_px = stereo.lens.ripple_px;
  return {DrawnRipple(stereo.nominal.left, rms_px, run_seed, stream + " left"),
          DrawnRipple(stereo.nominal.right, rms_px, run_seed, stream + " right")};
}

SensorOptions CameraSensor(const StereoModel& stereo, const Seed& run_seed, int index) {
  return SensorOf(stereo.sensor, index, StreamKey(run_seed, "camera"),
                  StreamKey(run_seed, "response"));
}

BuiltOne BuiltCamera(const CameraModel& model, const Seed& run_seed, const std::string& stream) {
  RandomStream random(StreamKey(run_seed, stream + " calibration"));
  const CameraErrors& errors = model.errors;
  BuiltOne built{BuiltLens(model.nominal, errors.lens, random), model.X_LC};
  double off[6];
  for (double& number : off) number = random.Normal();
  built.camera = BentCamera(built.camera, errors.lens, random);
  const double s = errors.rotation_sigma_rad;
  built.X_LC = Turned(built.X_LC, s * off[0], s * off[1], s * off[2]);
  built.X_LC.p += errors.place_sigma_m * Eigen::Vector3d(off[3], off[4], off[5]);
  built.ripple = DrawnRipple(model.nominal, errors.lens.ripple_px, run_seed, stream);
  return built;
}

SensorOptions CameraSensor(const CameraModel& model, const Seed& run_seed, int index,
                           const std::string& stream) {
  return SensorOf(model.sensor, index, StreamKey(run_seed, stream + " noise"),
                  StreamKey(run_seed, stream + " response"));
}

ColourSensorOptions ColourSensorOf(const CameraModel& model) {
  const SensorModel& sensor = model.sensor;
  ColourSensorOptions options;
  options.blur_sigma_px = sensor.blur_sigma_px;
  options.full_well_e = sensor.full_well_e;
  options.read_noise_e = sensor.read_noise_e;
  if (sensor.exposure.rule == ExposureRule::kFixed) {
    options.fixed_exposure_e = sensor.exposure.fixed_e;
  }
  return options;
}

KeptExposure* ExposureBefore(const SensorModel& model, KeptExposure& kept) {
  return model.exposure.by == ExposureBy::kBefore ? &kept : nullptr;
}

void CheckImageCanBeDrawn(const Camera& camera, const std::string& place) {
  for (const double u : {-0.5, camera.width - 0.5}) {
    for (const double v : {-0.5, camera.height - 0.5}) {
      const Eigen::Vector3d ray = camera.Direction({u, v});
      const double angle = std::atan2(std::hypot(ray.x(), ray.y()), ray.z());
      if (angle <= kWidestDrawn_rad) continue;
      char text[160];
      std::snprintf(text, sizeof text,
                    ": expected all pixels within %.0f deg of the lens's axis, at %d x %d a "
                    "corner is %.0f deg off it",
                    Degrees(kWidestDrawn_rad), camera.width, camera.height, Degrees(angle));
      throw ConfigError(place + text);
    }
  }
}

void CheckImagesCanBeDrawn(const StereoRig& rig, const std::string& place) {
  CheckImageCanBeDrawn(rig.left, place);
  CheckImageCanBeDrawn(rig.right, place);
}

}  // namespace dockyard
