#include "models/read/load_camera_model.h"

#include <cmath>

#include "models/read/load_cameras.h"
#include "models/read/visit_sensor.h"

namespace dockyard {
namespace {

constexpr double kMostRate_hz = 200.0;

/// A grey camera module with a global shutter of 1.2 Mp and pixels of 3.75 um, the Aptina MT9M031
/// of Matrix Vision's mvBlueFOX3-1012b: its manual gives, measured by EMVA 1288, a largest signal
/// to noise of 37.4 dB, so a full well of 10^3.74, and a dynamic range of 54.3 dB over that.
SensorModel CheapSensor() {
  return {.full_well_e = 5500.0,       // assumed for other modules: 4000-20000
          .read_noise_e = 10.6,        // assumed for other modules: 3-30
          .vignetting_exponent = 2.0,  // small lenses fall off less than cos^4; assumed, 1-4
          .blur_sigma_px = 0.7,        // lens and pixel together; assumed, 0.5-1.2
          .response_sigma = 0.01,      // assumed, 0.005-0.02
          .shutter_s = 0.005,          // indoors, f/2; assumed, 0.001-0.02
          .exposure = {},
          .focus = {},
          .video = {}};
}

/// Against a calibration of the camera itself, and a mount that is measured. Assumed, each a third
/// to three times that.
CameraErrors CalibratedErrors() {
  return {.rotation_sigma_rad = Radians(0.2),
          .place_sigma_m = 0.001,
          .lens = {.focal_sigma = 0.002, .centre_sigma_px = 1.0, .radial_sigma_px = 0.3}};
}

void VisitLens(Keys& keys, CameraFile& file) {
  keys.File(
      {"file", "", "a calibration (cameras.md), in place of a field of view", Presence::kUnset},
      file.lens);
  const bool own = file.lens.empty();
  keys.Allow("field_of_view_deg", own, "no such key next to file, which sets it");
  keys.Allow("file_camera", !own, "a file next to it");
  keys.Text({"file_camera", "", "which camera of that file", Presence::kUnset}, file.lens_name);
  Key view = keys.NeededIf(own, "field_of_view_deg");
  view.unit = "deg";
  view.meaning = "across the width; up to 100 a pinhole, wider ones equidistant";
  keys.Degrees(view, file.field_of_view_rad, Between(10.0, 200.0));
  const auto side = [&](const char* name, const char* meaning, int& pixels, bool needed) {
    keys.Integer(
        {name, "px", meaning, keys.reads() && needed ? Presence::kRequired : Presence::kDefault},
        pixels, 1, kMostImagePixels);
  };
  side("width_px", "of its images; required without a file, which has its own", file.width_px, own);
  side("height_px", "the same", file.height_px, own || file.width_px > 0);
  keys.Check("height_px", (file.width_px > 0) == (file.height_px > 0), "a width_px next to it");
}

Camera PinholeOf(const CameraFile& file) {
  const double w = file.width_px, h = file.height_px;
  const double f = 0.5 * w / std::tan(0.5 * file.field_of_view_rad);
  return {.width = file.width_px,
          .height = file.height_px,
          .lens = BrownPinhole{.fx = f, .fy = f, .cx = 0.5 * (w - 1.0), .cy = 0.5 * (h - 1.0)}};
}

Camera LensOf(const CameraFile& file) {
  if (file.lens.empty()) {
    return file.field_of_view_rad <= kWidestPinhole_rad
               ? PinholeOf(file)
               : EquidistantCamera(file.width_px, file.height_px, file.field_of_view_rad);
  }
  const Camera camera =
      Sized(file.lens, LoadCamera(file.lens, file.lens_name).camera, file.width_px, file.height_px);
  RequireRays(file.lens, camera);
  return camera;
}

}  // namespace

CameraFile::CameraFile() {
  camera.sensor = CheapSensor();
  camera.errors = CalibratedErrors();
}

void VisitCamera(Keys& keys, CameraFile& file) {
  CameraModel& camera = file.camera;
  keys.Text({"name", "", "of its own among the cameras", Presence::kRequired}, camera.name);
  keys.Text({"link", "", "of the URDF file, which carries it", Presence::kRequired}, camera.link);
  VisitLens(keys, file);
  constexpr const char* kPlaces[] = {"x_m", "y_m", "z_m"};
  for (int i = 0; i < 3; ++i)
    keys.Number({kPlaces[i], "m", "its place in the link's frame"}, file.p_LC[i], Between(-10, 10));
  keys.Degrees({"roll_deg", "deg", "about its line of sight"}, file.turn.roll,
               Between(-180.0, 180.0));
  keys.Degrees({"pitch_deg", "deg", "of its line of sight, down positive"}, file.turn.pitch,
               Between(-90.0, 90.0));
  keys.Degrees({"yaw_deg", "deg", "the same about z, to the left positive"}, file.turn.yaw,
               Between(-180.0, 180.0));
  keys.Choice(
      {"link_axes", "", "the view is along the link's x (forward), or its z with y down (optical)"},
      file.axes, {"forward", "optical"});
  keys.Bool({"colour", "", "images in red, green and blue, else grey"}, camera.colour);
  keys.Number({"rate_hz", "Hz", "of images, at most"}, file.rate_hz, Between(0.01, kMostRate_hz));
  keys.Number({"latency_s", "s", "from an exposure to the image's arrival"}, camera.latency_s,
              NonNegative(5.0));
  keys.Mapping(Unset("as_built"), [&](Keys& in) {
    in.Degrees({"rotation_deg", "deg", "of its mounting, 1 sigma about each axis"},
               camera.errors.rotation_sigma_rad, NonNegative(5.0));
    in.Number({"place_m", "m", "of its mounting, 1 sigma along each axis"},
              camera.errors.place_sigma_m, NonNegative(0.1));
    VisitLensErrors(in, camera.errors.lens, Presence::kDefault);
  });
  keys.Mapping(Unset("sensor"), [&](Keys& in) {
    for (const char* of_grey :
         {"response_sigma", "bits", "focus", "video", "defects", "readout_s"}) {
      in.Allow(of_grey, !camera.colour, "no such key of a colour camera");
    }
    VisitSensor(in, camera.sensor, Presence::kDefault);
    in.Check("exposure", !camera.colour || camera.sensor.exposure.rule != ExposureRule::kBracketed,
             "automatic or fixed for a colour camera");
    in.Check("exposure", !camera.colour || camera.sensor.exposure.by == ExposureBy::kSame,
             "no key 'by' for a colour camera, whose exposure follows with a lag");
    // render/colour_sensor.h draws no wider blur.
    in.Check("blur_sigma_px", !camera.colour || camera.sensor.blur_sigma_px <= 1.5,
             "at most 1.5 for a colour camera");
  });
}

CameraModel CameraOf(const CameraFile& file) {
  CameraModel camera = file.camera;
  camera.nominal = LensOf(file);
  Eigen::Matrix3d R_view = Eigen::Matrix3d::Identity();
  if (file.axes == LinkAxes::kForward) R_view << 0, 0, 1, -1, 0, 0, 0, -1, 0;  // right, down, ahead
  camera.X_LC = {ToRotation(file.turn) * R_view, file.p_LC};
  camera.period_s = 1.0 / file.rate_hz;
  return camera;
}

}  // namespace dockyard
