// Orange that may be the guide, without bands: pixels that are far redder, against blue, than most
// of the view. What the light does to colours it does to the ground as well, so it cancels
// (log-chromaticity, as in Finlayson and Hordley's colour constancy).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/raposa/nominal/nominal.h"
#include "controller/vision/linear_colour.h"

namespace dockyard::raposa {

/// Sigma of the image's blur, lens and pixel together. Assumed, 0.7-1.5.
inline constexpr double kImageBlur_px = 1.0;

/// Limits in pixels that are angles, such as the hole's shade, are of this focal length.
inline constexpr double kLimitsFocal_px = 377.0;

enum class Tint : std::uint8_t { kPlain, kOrange, kBlue, kUnseen };

/// Which orange counts: what clearly differs from the view, or also a guide too far for that.
enum class Spots : std::uint8_t { kClear, kFaint };

/// The image by pairs of pixels (linear_colour.h).
struct TintMap {
  PairImage light;
  std::vector<float> red_blue;  // ln R/B of each pair, columns smoothed
  std::vector<Tint> tints;
  double hole_px = 0.0;  // radius of what the hole leaves, about middle_px
  double finer = 1.0;    // focal length over kLimitsFocal_px
  Eigen::Vector2d middle_px{0.0, 0.0};
  Spots spots = Spots::kClear;

  std::size_t Index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(light.width) +
           static_cast<std::size_t>(i);
  }
  /// Of the pair's middle from the hole's rim, inwards [px].
  double Inside(int i, int j) const;
};

TintMap TintsOf(const RgbImage& image, const Nominal& nominal, Spots spots = Spots::kClear);

/// An orange region.
struct OrangeSpot {
  Eigen::Vector2d centre_px{0.0, 0.0};
  double area_px2 = 0.0;                         // without the blur
  double strength = 0.0;                         // sum of ln R/B above the view's
  int left = 0, right = 0, top = 0, bottom = 0;  // pairs and rows, both ends included
  bool clipped = false;                          // reaches the hole's rim
};

/// The strongest ones first, at most that many.
std::vector<OrangeSpot> OrangeSpots(const TintMap& map, std::size_t most);

/// Red over green and blue over green of the plain ground about a region: beside and below it.
/// None if too little is seen of it.
struct GroundColour {
  double red_green = 1.0, blue_green = 1.0;
  double green = 0.0;  // linear
};
std::optional<GroundColour> GroundAbout(const TintMap& map, int left, int right, int top,
                                        int bottom);

}  // namespace dockyard::raposa
