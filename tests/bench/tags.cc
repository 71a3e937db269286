#include "bench/tags.h"

#include <apriltag/tag36h11.h>

#include <cstdlib>

namespace dockyard {
namespace {

constexpr int kModules = 10;  // of a tag's pattern, white ring included; eight are the edge

}  // namespace

TagDetector::TagDetector(float decimate)
    : family_(tag36h11_create()), detector_(apriltag_detector_create()) {
  apriltag_detector_add_family(detector_, family_);
  detector_->nthreads = 1;
  detector_->quad_decimate = decimate;
}

TagDetector::~TagDetector() {
  apriltag_detector_destroy(detector_);
  tag36h11_destroy(family_);
}

std::vector<PrintedImage> TagDetector::Images(const FiducialBoard& board) const {
  std::vector<PrintedImage> images;
  for (std::size_t i = 0; i < board.fiducials.size(); ++i) {
    image_u8_t* image = apriltag_to_image(family_, static_cast<int>(i));
    PrintedImage printed{.p_BM = board.fiducials[i].p_BF,
                         .module_m = kTagImage_m / kModules,
                         .modules = kModules,
                         .black = {}};
    for (int y = 0; y < kModules; ++y) {
      for (int x = 0; x < kModules; ++x) {
        printed.black.push_back(image->buf[y * image->stride + x] < 128);
      }
    }
    images.push_back(printed);
    std::free(image->buf);  // the library's own function for this is not public
    std::free(image);
  }
  return images;
}

std::vector<SeenTag> TagDetector::Detect(const GrayImage& image) {
  std::vector<std::uint8_t> pixels = image.pixels;
  image_u8_t view{
      .width = image.width, .height = image.height, .stride = image.width, .buf = pixels.data()};
  zarray_t* found = apriltag_detector_detect(detector_, &view);
  std::vector<SeenTag> seen;
  for (int i = 0; i < zarray_size(found); ++i) {
    apriltag_detection_t* tag = nullptr;
    zarray_get(found, i, &tag);
    // AprilTag counts from the corner of the first pixel.
    seen.push_back({tag->id, {tag->c[0] - 0.5, tag->c[1] - 0.5}});
  }
  apriltag_detections_destroy(found);
  return seen;
}

}  // namespace dockyard
