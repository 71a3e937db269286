#include "controller/vision/tags/april_finder.h"

#include "controller/base/check.h"

namespace dockyard {
namespace {

// Wrong squares that are corrected. With two, tag16h5 is found in many a pattern, for every fifth
// reading of its 16 squares is within two of a code. The table for two has 16 x 3 x ids x bits^2
// bytes: 36 MB for tag36h11, 170 MB for tagStandard41h12, 6 GB for tagStandard52h13. So large
// families correct one.
int BitsCorrected(const apriltag_family_t& family) {
  constexpr std::uint32_t kManyIds = 1000, kFewBits = 20;
  if (family.nbits < kFewBits) return 0;
  return family.ncodes < kManyIds ? 2 : 1;
}

// libapriltag divides the image into tiles of 4 x 4 pixels, and needs some of them.
constexpr int kLeastSide_px = 16;
// Grey levels between the dark and the light of a tile of 4 x 4 pixels: with the library's 5 a
// sensor's noise is searched for outlines. A dusty tag has 20 and more. Assumed, 10-20.
constexpr int kLeastContrast = 12;
// Pixels of an outline: those of a tag of 8 px. Assumed, 12-24.
constexpr int kLeastOutline_px = 16;

}  // namespace

AprilFinder::AprilFinder(const std::string& name)
    : family_(AprilFamilyNamed(name)),
      detector_(apriltag_detector_create(), apriltag_detector_destroy) {
  DOCKYARD_CHECK(family_ != nullptr);
  apriltag_detector_add_family_bits(detector_.get(), family_.get(), BitsCorrected(*family_));
  detector_->nthreads = 1;
  detector_->quad_decimate = 1.0f;
  detector_->refine_edges = true;
  detector_->qtp.min_white_black_diff = kLeastContrast;
  detector_->qtp.min_cluster_pixels = kLeastOutline_px;
}

std::vector<FoundTag> AprilFinder::Find(const GrayImage& image) const {
  if (image.width < kLeastSide_px || image.height < kLeastSide_px) return {};
  std::vector<std::uint8_t> pixels = image.pixels;
  image_u8_t view{
      .width = image.width, .height = image.height, .stride = image.width, .buf = pixels.data()};
  zarray_t* detections = apriltag_detector_detect(detector_.get(), &view);
  std::vector<FoundTag> found;
  for (int i = 0; i < zarray_size(detections); ++i) {
    apriltag_detection_t* tag = nullptr;
    zarray_get(detections, i, &tag);
    FoundTag one{.id = tag->id,
                 .hamming = tag->hamming,
                 .decision_margin = tag->decision_margin,
                 .corners = {}};
    for (std::size_t k = 0; k < 4; ++k) {
      // Its first corner is the bottom left one, and they go round counter-clockwise. It counts
      // pixels from the outer corner of the first one.
      one.corners[3 - k] = {tag->p[k][0] - 0.5, tag->p[k][1] - 0.5};
    }
    found.push_back(one);
  }
  apriltag_detections_destroy(detections);
  return found;
}

}  // namespace dockyard
