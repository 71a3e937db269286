#include "models/read/visit_sensor.h"

namespace dockyard {
namespace {

void VisitExposure(Keys& keys, ExposureModel& exposure) {
  keys.Choice({"rule", "", "by the light in an image, always the same, or in steps about it"},
              exposure.rule, {"automatic", "fixed", "bracketed"});
  keys.Choice({"by", "", "which image's light sets it: the same one's, or that of the one before"},
              exposure.by, {"same", "before"});
  keys.Number({"percent", "%", "of automatic: of the pixels, those brighter than level"},
              exposure.percent, Between(0.01, 99.0));
  keys.Number({"level", "", "of automatic: a share of the full well"}, exposure.level,
              Between(0.01, 1.0));
  keys.Number({"bracket_stops", "", "of bracketed: stops from exposure to exposure"},
              exposure.bracket_stops, Positive(8.0));
  Key fixed = keys.NeededIf(exposure.rule == ExposureRule::kFixed, "fixed_e");
  fixed.unit = "electrons";
  fixed.meaning = "of fixed: of a pixel at radiance 1, a white surface under pi of light";
  keys.Number(fixed, exposure.fixed_e, Positive(1e9));
}

void VisitFocus(Keys& keys, FocusModel& focus) {
  keys.Number({"focal_length_m", "m", "of the lens", Presence::kRequired}, focus.focal_length_m,
              Between(1e-4, 1.0));
  keys.Number({"f_number", "", "of the lens", Presence::kRequired}, focus.f_number,
              Between(0.5, 64.0));
  keys.Number({"distance_m", "m", "at which it is sharp", Presence::kRequired}, focus.distance_m,
              Positive(1e6));
  keys.Number({"pixel_pitch_m", "m", "of the sensor", Presence::kRequired}, focus.pixel_pitch_m,
              Between(1e-7, 1e-3));
  keys.Check("distance_m", focus.distance_m > focus.focal_length_m,
             "a number above focal_length_m");
}

void VisitVideo(Keys& keys, double shutter_s, VideoModel& video) {
  keys.Number({"noise_share", "", "added to the signal: 1 sigma as a share of full scale"},
              video.noise_share, NonNegative(0.2));
  keys.Number({"line_jitter_px", "px", "of where each line begins along the row, 1 sigma"},
              video.line_jitter_px, NonNegative(5.0));
  keys.Choice({"fields", "", "all lines at once, or odd lines 1/60 s after even ones"},
              video.fields, {"progressive", "interlaced"});
  keys.Check("fields", video.fields == VideoFields::kProgressive || shutter_s <= kFieldPeriod_s,
             "a shutter_s up to 1/60 next to interlaced");
}

void VisitDefects(Keys& keys, DefectModel& defects) {
  keys.Number({"hot_share", "", "of the pixels: their dark signal is high"}, defects.hot_share,
              NonNegative(0.1));
  keys.Number({"hot_rate_e_per_s", "electrons/s", "mean of their dark signal in shutter_s"},
              defects.hot_rate_e_per_s, NonNegative(1e7));
  keys.Number({"hot_offset_e", "electrons", "mean of what two in five add to each image"},
              defects.hot_offset_e, NonNegative(1e5));
  keys.Number({"dead_share", "", "of the pixels: they get no light"}, defects.dead_share,
              NonNegative(0.1));
}

}  // namespace

void VisitLensErrors(Keys& keys, LensErrors& errors, Presence needed) {
  keys.Number({"focal_relative", "", "of the focal length, 1 sigma as a share", needed},
              errors.focal_sigma, NonNegative(0.1));
  keys.Number({"centre_px", "px", "of the image centre, 1 sigma", needed}, errors.centre_sigma_px,
              NonNegative(50.0));
  keys.Number({"radial_px", "px", "of the distortion half the width out, 1 sigma", needed},
              errors.radial_sigma_px, NonNegative(50.0));
  keys.Number({"ripple_px", "px", "beyond its model: displacement of pixels, rms over the image"},
              errors.ripple_px, NonNegative(1.0));
}

void VisitSensor(Keys& keys, SensorModel& sensor, Presence needed) {
  keys.Number({"full_well_e", "electrons", "of a full pixel", needed}, sensor.full_well_e,
              Between(100.0, 1e6));
  keys.Number({"read_noise_e", "electrons", "1 sigma", needed}, sensor.read_noise_e,
              NonNegative(1e4));
  keys.Number({"vignetting_exponent", "", "n of cos^n of the angle off the axis", needed},
              sensor.vignetting_exponent, NonNegative(8.0));
  keys.Number({"blur_sigma_px", "px", "of lens and pixel, a Gaussian", needed},
              sensor.blur_sigma_px, NonNegative(10.0));
  keys.Number({"response_sigma", "", "of the pixels' gains, 1 sigma as a share"},
              sensor.response_sigma, NonNegative(0.2));
  keys.Number({"shutter_s", "s", "of an exposure; motion blurs it"}, sensor.shutter_s,
              NonNegative(0.1));
  keys.Number({"readout_s", "s", "from the first row's exposure to the last's; 0: all at once"},
              sensor.readout_s, NonNegative(0.1));
  keys.Integer({"bits", "", "of a pixel; a controller gets the upper eight"}, sensor.bits, 8, 16);
  keys.Mapping(Unset("exposure"), [&](Keys& in) { VisitExposure(in, sensor.exposure); });
  keys.Mapping(Unset("focus"), [&](Keys& in) { VisitFocus(in, sensor.focus); });
  keys.Mapping(Unset("video"), [&](Keys& in) { VisitVideo(in, sensor.shutter_s, sensor.video); });
  keys.Mapping(Unset("defects"), [&](Keys& in) { VisitDefects(in, sensor.defects); });
  keys.Check("readout_s",
             sensor.readout_s == 0.0 || sensor.video.fields == VideoFields::kProgressive,
             "0 next to interlaced video");
}

}  // namespace dockyard
