#include "sim/plant/camera_view.h"

#include "controller/base/check.h"
#include "controller/base/split_mix.h"
#include "render/rolling_shutter.h"
#include "render/video_fields.h"

namespace dockyard {

CameraMotion CameraOnLink(const Pose3& X_LC, const Pose3& X_WL, const Eigen::Vector3d& v_WL_W,
                          const Eigen::Vector3d& w_WL_W) {
  const Pose3 X_WC = X_WL * X_LC;
  return {X_WC, v_WL_W + w_WL_W.cross(X_WC.p - X_WL.p), w_WL_W};
}

SimulatedCamera::SimulatedCamera(const CameraModel& model, const Seed& run_seed, int number)
    : model_(model),
      seed_(run_seed),
      number_(number),
      stream_("camera " + model.name),
      built_(BuiltCamera(model, run_seed, stream_)) {}

double SimulatedCamera::MotionIn_px(const CameraMotion& motion, double nearest_m,
                                    double seconds) const {
  return MotionInExposure_px(built_.camera, motion.w_WC_W.norm(), motion.v_WC_W.norm(), nearest_m,
                             seconds);
}

CameraImage SimulatedCamera::Take(StereoRenderer& renderer, const SceneAt& scene,
                                  const ColourTable* colours, const CameraMotion& motion, Tick now,
                                  const Conditions& conditions) {
  CameraImage image{number_, GrayImage{}, now, model_.sensor.shutter_s};
  if (!model_.colour) {
    image.pixels = TakeGrey(renderer, scene, motion, conditions);
  } else {
    DOCKYARD_CHECK(colours != nullptr);
    image.pixels = TakeColour(renderer, scene(0.0), *colours, motion, now, conditions);
  }
  ++taken_;
  last_ = now;
  return image;
}

GrayImage SimulatedCamera::TakeGrey(StereoRenderer& renderer, const SceneAt& scene,
                                    const CameraMotion& motion, const Conditions& conditions) {
  SensorOptions sensor = CameraSensor(model_, seed_, taken_, stream_);
  sensor.exposure_stops += conditions.exposure_stops;
  if (conditions.faults) conditions.faults(sensor);
  const double shutter_s = model_.sensor.shutter_s, readout_s = model_.sensor.readout_s;
  const double nearest_m = conditions.nearest_m;
  const double rows_px = MotionIn_px(motion, nearest_m, readout_s);
  const bool needs_depth = sensor.focus.distance_m > 0.0 || RowsDiffer(rows_px);
  const auto view = [&](double seconds, bool with_depth) {
    return renderer.RenderGrey(scene(seconds), built_.camera,
                               MovedOn(motion.X_WC, motion.v_WC_W, motion.w_WC_W, seconds),
                               with_depth || needs_depth, built_.ripple);
  };
  const auto moved_in = [&](double seconds) {
    return MotionOverExposure(motion.X_WC.R, motion.v_WC_W, motion.w_WC_W, seconds);
  };
  const auto light = [&](double middle_s) {
    return OverExposure(
        MotionIn_px(motion, nearest_m, shutter_s), built_.camera, moved_in(shutter_s),
        [&](double share, bool depth) { return view(middle_s + share * shutter_s, depth); });
  };
  const auto rows = [&](double middle_s) {
    return OverReadout(rows_px, built_.camera, moved_in(readout_s), OneInReadout([&](double share) {
                         return light(middle_s + share * readout_s);
                       }));
  };
  return ExposeVideo(OneAt(rows), MotionIn_px(motion, nearest_m, kFieldApart_s), built_.camera,
                     sensor, kept_, ExposureBefore(model_.sensor, exposure_));
}

RgbImage SimulatedCamera::TakeColour(StereoRenderer& renderer, const Scene& scene,
                                     const ColourTable& colours, const CameraMotion& motion,
                                     Tick now, const Conditions& conditions) {
  const ColourSensorOptions sensor = ColourSensorOf(model_);
  const std::vector<Pose3> poses =
      PosesInExposure(motion.X_WC, motion.v_WC_W, motion.w_WC_W, model_.sensor.shutter_s,
                      MotionIn_px(motion, conditions.nearest_m, model_.sensor.shutter_s),
                      StepsUnderBlur(sensor.blur_sigma_px));
  const ColourView view{.camera = built_.camera,
                        .hole = {},
                        .vignetting_exponent = model_.sensor.vignetting_exponent,
                        .ripple = built_.ripple};
  const ColourRadiance light = renderer.RenderThrough(scene, colours, view, poses);
  const double since_s = taken_ > 0 ? static_cast<double>(now - last_) * kTickSeconds : 0.0;
  const std::uint64_t key =
      SplitMix(StreamKey(seed_, stream_ + " noise"), static_cast<std::uint64_t>(taken_));
  return ExposeColourView(light, sensor, since_s, key, colour_state_);
}

}  // namespace dockyard
