#include "controller/stereo/band_pass_blocks.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "controller/base/check.h"

namespace dockyard {
namespace {

// Widths of the two Gaussians. Assumed, 0.7-1.4 px and twice that.
constexpr double kFine_px = 1.0, kCoarse_px = 2.0;
// Steps of the 8-bit result for a grey level. Assumed, 2-8.
constexpr double kSteps = 4.0;
constexpr int kSubpixels = 16;
constexpr auto kNone = std::numeric_limits<std::uint16_t>::max();

cv::Mat BandPassed(const cv::Mat& image) {
  cv::Mat grey, fine, coarse, out;
  image.convertTo(grey, CV_32F);
  cv::GaussianBlur(grey, fine, {}, kFine_px);
  cv::GaussianBlur(grey, coarse, {}, kCoarse_px);
  cv::Mat(fine - coarse).convertTo(out, CV_8U, kSteps, 128.0);
  return out;
}

// The least sum of a pixel so far, and its neighbours'.
struct Least {
  std::uint16_t cost = kNone, before = kNone, after = kNone;
  std::int16_t at_px = -1;
};

// Sums of absolute differences at one disparity; its first column is the left image's `px`.
cv::Mat CostAt(const cv::Mat& left, const cv::Mat& right, int px, int block_px) {
  const int columns = left.cols - px;
  cv::Mat differ, sum;
  cv::absdiff(left.colRange(px, left.cols), right.colRange(0, columns), differ);
  cv::boxFilter(differ, sum, CV_16U, {block_px, block_px}, {-1, -1}, false);
  return sum;
}

// In the image's columns from `first` on. `costs_before` are the last disparity's, one column more.
void Take(const cv::Mat& costs, const cv::Mat& costs_before, int px, int first,
          std::vector<Least>& least) {
  const bool has_before = !costs_before.empty();
  const int width = static_cast<int>(least.size()) / costs.rows;
  for (int v = 0; v < costs.rows; ++v) {
    const auto* row = costs.ptr<std::uint16_t>(v);
    // The same pixel: one column further from the first one, where that moves on.
    const auto* row_before =
        has_before ? costs_before.ptr<std::uint16_t>(v) + (first > 0 ? 1 : 0) : nullptr;
    Least* place = &least[static_cast<std::size_t>(v * width + first)];
    for (int u = 0; u < costs.cols; ++u) {
      Least& pixel = place[u];
      if (row[u] < pixel.cost) {
        pixel = {row[u], row_before != nullptr ? row_before[u] : kNone, kNone,
                 static_cast<std::int16_t>(px)};
      } else if (pixel.at_px == px - 1) {
        pixel.after = row[u];
      }
    }
  }
}

int Bend(const Least& least) { return least.before - 2 * least.cost + least.after; }

// In sixteenths, by a parabola through the least sum and its neighbours'.
short InSixteenths(const Least& least) {
  const int whole = least.at_px * kSubpixels, bend = Bend(least);
  if (bend <= 0) return static_cast<short>(whole);
  return static_cast<short>(whole + kSubpixels * (least.before - least.after) / (2 * bend));
}

}  // namespace

cv::Mat MatchBandPassed(const cv::Mat& left, const cv::Mat& right, const BandPassSettings& with) {
  DOCKYARD_CHECK(left.size() == right.size() && with.least_px >= 0 && with.count_px > 0);
  DOCKYARD_CHECK(with.block_px % 2 == 1 && with.block_px >= 3 && with.block_px <= 15);
  const cv::Mat l = BandPassed(left), r = BandPassed(right);
  std::vector<Least> of_left(left.total()), of_right(left.total());
  cv::Mat before;
  for (int px = with.least_px; px < std::min(with.least_px + with.count_px, left.cols); ++px) {
    const cv::Mat costs = CostAt(l, r, px, with.block_px);
    Take(costs, before, px, px, of_left);
    Take(costs, before, px, 0, of_right);
    before = costs;
  }
  cv::Mat out(left.size(), CV_16S, cv::Scalar(kSubpixels * (with.least_px - 1)));
  for (int v = 0; v < left.rows; ++v) {
    const Least* row = &of_left[static_cast<std::size_t>(v * left.cols)];
    const Least* row_right = &of_right[static_cast<std::size_t>(v * left.cols)];
    for (int u = 0; u < left.cols; ++u) {
      // A least sum at either end of the search is none.
      if (row[u].before == kNone || row[u].after == kNone) continue;
      const int back_px = row_right[u - row[u].at_px].at_px;
      if (std::abs(back_px - row[u].at_px) > with.most_left_right_px) continue;
      if (Bend(row[u]) < with.least_bend) continue;
      out.at<short>(v, u) = InSixteenths(row[u]);
    }
  }
  return out;
}

}  // namespace dockyard
