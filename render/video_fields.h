// Interlaced video: even and odd lines are exposed one after the other. No GL.
#pragma once

#include <functional>

#include "render/kept_exposure.h"
#include "render/kept_sensor.h"
#include "render/shutter.h"
#include "render/stereo_renderer.h"

namespace dockyard {

/// From the even lines' exposure to the odd ones': a field of 525-line video (EIA RS-170).
inline constexpr double kFieldApart_s = 1.0 / 60.0;

/// The light on both cameras over an exposure whose middle is `seconds` from now.
using PairAt = std::function<StereoRadiance(double seconds)>;
/// That on one camera.
using OneAt = std::function<RadianceImage(double seconds)>;

/// The images of a pair, of whose things the nearest move by field_px from field to field. Both
/// fields are drawn if the sensor is interlaced and that is 0.1 px or more: the even lines half a
/// field's time before now, the odd ones half of it after. Else one view, of now, serves all lines.
/// before: of cameras whose exposure is set by the image before (exposure_rule.h).
StereoImages ExposeVideo(const PairAt& light, double field_px, const StereoRig& rig,
                         const SensorOptions& sensor, KeptExposure* before = nullptr);
/// The same of one camera, as ExposeGrey exposes it.
GrayImage ExposeVideo(const OneAt& light, double field_px, const Camera& camera,
                      const SensorOptions& sensor, KeptSensor& kept,
                      KeptExposure* before = nullptr);

/// Of rows that follow on each other: the even ones of `even`, the odd ones of `odd`.
RadianceImage Interlaced(RadianceImage even, const RadianceImage& odd);

/// The images of two fields, one exposure for all: even and odd lines come together behind the
/// lens, which blurs each field by itself.
StereoImages ExposeFields(std::array<StereoRadiance, 2> fields, const StereoRig& rig,
                          const SensorOptions& sensor, KeptExposure* before = nullptr);
GrayImage ExposeFields(std::array<RadianceImage, 2> fields, const Camera& camera,
                       const SensorOptions& sensor, KeptSensor& kept,
                       KeptExposure* before = nullptr);

}  // namespace dockyard
