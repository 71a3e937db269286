#include "models/read/visit_sensor.h"

namespace dockyard {
namespace {

void VisitExposure(Keys& keys, ExposureModel& exposure) {
  keys.Choice(Optional("rule"), exposure.rule, {"automatic", "fixed", "bracketed"});
  keys.Number(Optional("percent"), exposure.percent, Between(0.01, 99.0));
  keys.Number(Optional("level"), exposure.level, Between(0.01, 1.0));
  keys.Number(Optional("bracket_stops"), exposure.bracket_stops, Positive(8.0));
  keys.Number(keys.NeededIf(exposure.rule == ExposureRule::kFixed, "fixed_e"), exposure.fixed_e,
              Positive(1e9));
}

void VisitFocus(Keys& keys, FocusModel& focus) {
  keys.Number("focal_length_m", focus.focal_length_m, Between(1e-4, 1.0));
  keys.Number("f_number", focus.f_number, Between(0.5, 64.0));
  keys.Number("distance_m", focus.distance_m, Positive(1e6));
  keys.Number("pixel_pitch_m", focus.pixel_pitch_m, Between(1e-7, 1e-3));
  keys.Check("distance_m", focus.distance_m > focus.focal_length_m,
             "a number above focal_length_m");
}

}  // namespace

void VisitLensErrors(Keys& keys, LensErrors& errors, Presence needed) {
  const auto key = [&](std::string_view name) { return Key(name, "", "", needed); };
  keys.Number(key("focal_relative"), errors.focal_sigma, NonNegative(0.1));
  keys.Number(key("centre_px"), errors.centre_sigma_px, NonNegative(50.0));
  keys.Number(key("radial_px"), errors.radial_sigma_px, NonNegative(50.0));
}

void VisitSensor(Keys& keys, SensorModel& sensor, Presence needed) {
  const auto key = [&](std::string_view name) { return Key(name, "", "", needed); };
  keys.Number(key("full_well_e"), sensor.full_well_e, Between(100.0, 1e6));
  keys.Number(key("read_noise_e"), sensor.read_noise_e, NonNegative(1e4));
  keys.Number(key("vignetting_exponent"), sensor.vignetting_exponent, NonNegative(8.0));
  keys.Number(key("blur_sigma_px"), sensor.blur_sigma_px, NonNegative(10.0));
  keys.Number(Optional("response_sigma"), sensor.response_sigma, NonNegative(0.2));
  keys.Number(Optional("shutter_s"), sensor.shutter_s, NonNegative(0.1));
  keys.Integer(Optional("bits"), sensor.bits, 8, 16);
  keys.Mapping(Unset("exposure"), [&](Keys& in) { VisitExposure(in, sensor.exposure); });
  keys.Mapping(Unset("focus"), [&](Keys& in) { VisitFocus(in, sensor.focus); });
}

}  // namespace dockyard
