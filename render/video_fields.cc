#include "render/video_fields.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard {
namespace {

// Below this the two fields of an image do not differ enough for a second view: a third of the
// error of a match. Assumed, 0.05-0.2 px.
constexpr double kStill_px = 0.1;

bool InTwo(double field_px, const SensorOptions& sensor) {
  DOCKYARD_CHECK(std::isfinite(field_px) && field_px >= 0.0);
  return sensor.video.interlaced && field_px >= kStill_px;
}

}  // namespace

RadianceImage Interlaced(RadianceImage even, const RadianceImage& odd) {
  DOCKYARD_CHECK(even.width == odd.width && even.values.size() == odd.values.size());
  const auto columns = static_cast<std::ptrdiff_t>(even.width);
  const auto end = static_cast<std::ptrdiff_t>(even.values.size());
  for (std::ptrdiff_t first = columns; first < end; first += 2 * columns) {
    std::copy_n(odd.values.begin() + first, columns, even.values.begin() + first);
  }
  return even;
}

StereoImages ExposeVideo(const PairAt& light, double field_px, const StereoRig& rig,
                         const SensorOptions& sensor, KeptExposure* before) {
  if (!InTwo(field_px, sensor)) return ExposeStereo(light(0.0), rig, sensor, before);
  return ExposeFields({light(-0.5 * kFieldApart_s), light(0.5 * kFieldApart_s)}, rig, sensor,
                      before);
}

GrayImage ExposeVideo(const OneAt& light, double field_px, const Camera& camera,
                      const SensorOptions& sensor, KeptSensor& kept, KeptExposure* before) {
  if (!InTwo(field_px, sensor)) return ExposeGrey(light(0.0), camera, sensor, kept, before);
  return ExposeFields({light(-0.5 * kFieldApart_s), light(0.5 * kFieldApart_s)}, camera, sensor,
                      kept, before);
}

}  // namespace dockyard
