// Disparities of a rectified pair.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/image.h"
#include "controller/stereo/rectify.h"

namespace dockyard {

/// By pixel of the left image, row by row: u there less u in the right image [px]; NaN: none.
struct Disparities {
  int width = 0, height = 0;
  std::vector<float> px;

  float at(int u, int v) const {
    return px[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
              static_cast<std::size_t>(u)];
  }
};

/// A plane's disparity: a + b u + c v, nowhere below 0.
struct PlaneDisparity {
  double a = 0.0, b = 0.0, c = 0.0;

  double At(double u, double v) const { return std::max(0.0, a + b * u + c * v); }
};

/// Of a plane that does not hold the left camera; in the rig's frame.
PlaneDisparity DisparityOf(const RectifiedPair& pair, const Plane& plane_R);

enum class Matcher : std::uint8_t {
  kBlocks,      // sums of differences over a block: exact on sand, gaps on rocks of one colour
  kSemiGlobal,  // smooth along paths (Hirschmueller 2008): fewer gaps, less exact
  kBandPassed,  // blocks of differences of Gaussians, as on JPL's rovers (band_pass_blocks.h)
};

struct MatchSettings {
  Matcher matcher = Matcher::kBlocks;
  int block_px = 15;                 // odd, from 3; of blocks from 5
  int least_px = 0, count_px = 128;  // disparities that are tried; the count a multiple of 16
  int uniqueness_percent = 10;       // by which the best must beat the second; not of kBandPassed
  int most_left_right_px = 1;        // that left and right may differ by
  int speckle_px = 50;               // smaller patches are left out
  // Gaussian on both images before the search; 0: none. It takes noise off faint texture, as ground
  // far away has it, and blurs the edges of what stands out.
  double smooth_px = 0.0;
  /// The ground. Each row of the right image is shifted by its disparity before the search, so that
  /// the search is for what stands out of it: a block on a slope is as sharp as on a wall, and few
  /// disparities need be tried.
  std::optional<PlaneDisparity> ground{};
};

/// A sentence where images of this size are too small for the search: it would have no column with
/// all disparities, or no whole block. Empty for others. Match must not be called for them.
std::string WhyNoSearch(int width, int height, const MatchSettings& with);

/// Of the pair's images; none where a block, in either image, reaches beyond what the camera saw.
/// Images of one size, and settings that their matcher has.
Disparities Match(const Rectifier& rectifier, const StereoImages& images,
                  const MatchSettings& settings);

/// Of images that are rectified already.
Disparities Match(const StereoImages& rectified, const MatchSettings& settings);

}  // namespace dockyard
