#include "models/read/read_stereo.h"

#include "models/parts/mounting.h"
#include "models/read/load_cameras.h"
#include "models/read/load_mounting.h"

namespace dockyard {
namespace {

/// Cameras side by side, facing along the body's x axis, pitched down together.
StereoRig MakeRig(double baseline_m, double forward_m, double height_m, double pitch_rad,
                  const Camera& camera) {
  Eigen::Matrix3d R_level;  // z along the view, x right, y down
  R_level.col(0) = -Eigen::Vector3d::UnitY();
  R_level.col(1) = -Eigen::Vector3d::UnitZ();
  R_level.col(2) = Eigen::Vector3d::UnitX();
  const Eigen::Matrix3d R = RotY(pitch_rad) * R_level;
  StereoRig rig;
  rig.left = rig.right = camera;
  rig.X_RL = {R, Eigen::Vector3d(forward_m, 0.5 * baseline_m, height_m)};
  rig.X_RQ = {R, Eigen::Vector3d(forward_m, -0.5 * baseline_m, height_m)};
  return rig;
}

StereoRig ReadRig(const YamlReader& in, const PictureSize& size, const PictureSize& usual) {
  if (in.Has("file")) {
    for (const char* key :
         {"baseline_m", "forward_m", "height_m", "pitch_deg", "field_of_view_deg"}) {
      if (in.Has(key))
        in.Refuse(key, "no such key beside " + in.PathOf("file") + ", which sets it");
    }
    return LoadRig(in.File("file"), size.width, size.height);
  }
  const double fov_rad = in.Degrees("field_of_view_deg", Between(10.0, 200.0));
  return MakeRig(in.Number("baseline_m", Between(0.01, 2.0)),
                 in.Number("forward_m", Between(-2.0, 2.0)),
                 in.Number("height_m", Between(-2.0, 3.0)),
                 in.DegreesOr("pitch_deg", 0.0, Between(-60.0, 60.0)),
                 EquidistantCamera(size.width > 0 ? size.width : usual.width,
                                   size.height > 0 ? size.height : usual.height, fov_rad));
}

ExposureModel ReadExposure(const YamlReader& sensor) {
  ExposureModel exposure;
  if (!sensor.Has("exposure")) return exposure;
  const YamlReader in(sensor.Child("exposure"), sensor.PathOf("exposure"),
                      {"rule", "percent", "level", "fixed_e", "bracket_stops"});
  exposure.rule =
      static_cast<ExposureRule>(in.ChoiceOr("rule", 0, {"automatic", "fixed", "bracketed"}));
  exposure.percent = in.NumberOr("percent", exposure.percent, Between(0.01, 99.0));
  exposure.level = in.NumberOr("level", exposure.level, Between(0.01, 1.0));
  exposure.bracket_stops = in.NumberOr("bracket_stops", exposure.bracket_stops, Positive(8.0));
  if (exposure.rule == ExposureRule::kFixed) exposure.fixed_e = in.Number("fixed_e", Positive(1e9));
  return exposure;
}

FocusModel ReadFocus(const YamlReader& sensor) {
  FocusModel focus;
  if (!sensor.Has("focus")) return focus;
  const YamlReader in(sensor.Child("focus"), sensor.PathOf("focus"),
                      {"focal_length_m", "f_number", "distance_m", "pixel_pitch_m"});
  focus.focal_length_m = in.Number("focal_length_m", Between(1e-4, 1.0));
  focus.f_number = in.Number("f_number", Between(0.5, 64.0));
  focus.distance_m = in.Number("distance_m", Positive(1e6));
  focus.pixel_pitch_m = in.Number("pixel_pitch_m", Between(1e-7, 1e-3));
  if (focus.distance_m <= focus.focal_length_m) {
    in.Refuse("distance_m", "a number above focal_length_m");
  }
  return focus;
}

}  // namespace

StereoRig MountedRig(const StereoRig& rig, const StereoModel& stereo) {
  const Eigen::Vector3d p_R_middle = 0.5 * (rig.X_RL.p + rig.X_RQ.p);
  StereoRig mounted = rig;
  mounted.X_RL = Mounted(rig.X_RL, stereo.mounting, p_R_middle);
  mounted.X_RQ =
      Mounted(Mounted(rig.X_RQ, stereo.right_mounting, rig.X_RQ.p), stereo.mounting, p_R_middle);
  return mounted;
}

StereoModel ReadStereo(const YamlReader& root, const PictureSize& size, const PictureSize& usual,
                       const std::string& key) {
  const YamlReader in(root.Child(key), root.PathOf(key),
                      {"file", "baseline_m", "forward_m", "height_m", "pitch_deg",
                       "field_of_view_deg", "mounting", "right_mounting", "as_built", "sensor"});
  StereoModel stereo;
  stereo.mounting = ReadMounting(in);
  stereo.right_mounting = ReadMounting(in, "right_mounting");
  stereo.nominal = MountedRig(ReadRig(in, size, usual), stereo);
  const YamlReader built(
      in.Child("as_built"), in.PathOf("as_built"),
      {"relative_yaw_deg", "rotation_deg", "focal_relative", "centre_px", "radial_px"});
  stereo.relative_yaw_sigma_rad = built.Degrees("relative_yaw_deg", NonNegative(5.0));
  stereo.rotation_sigma_rad = built.Degrees("rotation_deg", NonNegative(5.0));
  stereo.focal_sigma = built.Number("focal_relative", NonNegative(0.1));
  stereo.centre_sigma_px = built.Number("centre_px", NonNegative(50.0));
  stereo.radial_sigma_px = built.Number("radial_px", NonNegative(50.0));
  const YamlReader sensor(in.Child("sensor"), in.PathOf("sensor"),
                          {"full_well_e", "read_noise_e", "vignetting_exponent", "blur_sigma_px",
                           "response_sigma", "shutter_s", "bits", "exposure", "focus"});
  stereo.full_well_e = sensor.Number("full_well_e", Between(100.0, 1e6));
  stereo.read_noise_e = sensor.Number("read_noise_e", NonNegative(1e4));
  stereo.vignetting_exponent = sensor.Number("vignetting_exponent", NonNegative(8.0));
  stereo.blur_sigma_px = sensor.Number("blur_sigma_px", NonNegative(10.0));
  stereo.response_sigma = sensor.NumberOr("response_sigma", 0.0, NonNegative(0.2));
  stereo.shutter_s = sensor.NumberOr("shutter_s", 0.0, NonNegative(0.1));
  stereo.bits = sensor.IntegerOr("bits", 8, 8, 16);
  stereo.exposure = ReadExposure(sensor);
  stereo.focus = ReadFocus(sensor);
  return stereo;
}

}  // namespace dockyard
