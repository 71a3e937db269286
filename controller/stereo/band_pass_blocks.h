// The stereo matcher of JPL's rovers about 2000: differences of Gaussians, then sums of absolute
// differences over blocks, left and right compared.
#pragma once

#include <opencv2/core.hpp>

namespace dockyard {

struct BandPassSettings {
  int block_px = 7;
  int least_px = 0, count_px = 128;  // disparities that are tried, none below 0
  int most_left_right_px = 1;        // that left and right may differ by
  // The sums of a block without texture are flat about their least: the parabola bends by less than
  // this within a pixel to either side, in quarters of a grey level. 40 drops 88 % of the matches
  // by chance of noise of 0.75 % of full scale, and 1 % of those of a texture of twice that noise,
  // with blocks of 7 px. Assumed, 20-80.
  int least_bend = 40;
};

/// Disparities of the left image's pixels in sixteenths of a pixel (CV_16S), 16 (least_px - 1)
/// where there is none. 8-bit images of one size, in which equal rows show equal rays.
///
/// Goldberg, Maimone and Matthies (IEEE Aerospace Conference 2002): the Laplacian, as a difference
/// of Gaussians, takes the cameras' own brightness off; a block of 7 px; a parabola about the least
/// sum, left out where it is flat; the right image's match must lead back. The widths of the
/// Gaussians are assumed.
cv::Mat MatchBandPassed(const cv::Mat& left, const cv::Mat& right, const BandPassSettings& with);

}  // namespace dockyard
