#include "controller/io/sensors.h"

namespace dockyard {
namespace {

template <class Image>
const Image* ImageOf(const SensorFrame& frame, int camera) {
  for (const CameraImage& image : frame.images) {
    if (image.camera == camera) return std::get_if<Image>(&image.pixels);
  }
  return nullptr;
}

}  // namespace

const GrayImage* GrayImageOf(const SensorFrame& frame, int camera) {
  return ImageOf<GrayImage>(frame, camera);
}

const RgbImage* RgbImageOf(const SensorFrame& frame, int camera) {
  return ImageOf<RgbImage>(frame, camera);
}

}  // namespace dockyard
