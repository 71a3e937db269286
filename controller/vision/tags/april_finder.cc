#include "controller/vision/tags/april_finder.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

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

/// Grey levels on a scale on which a share of the light is nearly the same step everywhere. The
/// library takes the middle between the darkest and the lightest pixel nearby for the threshold, so
/// a white square in the shade counts as black next to a lit one: on this scale it does not.
/// @param dark  darker levels are stretched no more
GrayImage Toned(GrayImage image, double dark) {
  constexpr double kFull = 255.0;
  std::array<std::uint8_t, 256> tones{};
  for (std::size_t grey = 0; grey < tones.size(); ++grey) {
    const double share = std::log1p(static_cast<double>(grey) / dark) / std::log1p(kFull / dark);
    tones[grey] = static_cast<std::uint8_t>(std::lround(kFull * share));
  }
  for (std::uint8_t& pixel : image.pixels) pixel = tones[pixel];
  return image;
}

/// Means of squares of pixels; those of a last part of a square are left out.
GrayImage Reduced(const GrayImage& image, int factor) {
  GrayImage small{image.width / factor, image.height / factor, {}};
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      int sum = factor * factor / 2;
      for (int i = 0; i < factor * factor; ++i)
        sum += image.at(factor * x + i % factor, factor * y + i / factor);
      small.pixels.push_back(static_cast<std::uint8_t>(sum / (factor * factor)));
    }
  }
  return small;
}

/// Corners of a reduced image in the whole one.
std::vector<FoundTag> Enlarged(std::vector<FoundTag> tags, int factor) {
  for (FoundTag& tag : tags) {
    for (Eigen::Vector2d& corner : tag.corners)
      corner = (factor * (corner.array() + 0.5) - 0.5).matrix();
  }
  return tags;
}

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
  std::vector<FoundTag> found = FindIn(image);
  // Worn ink breaks the outline of a near tag and spoils readings at single pixels.
  for (const int factor : {2, 4}) {
    if (found.empty()) found = Enlarged(FindIn(Reduced(image, factor)), factor);
  }
  // The first scale suffices where a shade leaves half of the light, the second, which stretches
  // noise too, where it leaves a quarter.
  for (const double dark : {32.0, 5.0}) {
    if (found.empty()) found = FindIn(Toned(image, dark));
  }
  return found;
}

std::vector<FoundTag> AprilFinder::FindIn(GrayImage image) const {
  if (image.width < kLeastSide_px || image.height < kLeastSide_px) return {};
  image_u8_t view{.width = image.width,
                  .height = image.height,
                  .stride = image.width,
                  .buf = image.pixels.data()};
  zarray_t* detections = apriltag_detector_detect(detector_.get(), &view);
  std::vector<FoundTag> found;
  for (int i = 0; i < zarray_size(detections); ++i) {
    apriltag_detection_t* tag = nullptr;
    zarray_get(detections, i, &tag);
    FoundTag one{.id = tag->id, .hamming = tag->hamming, .corners = {}};
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
