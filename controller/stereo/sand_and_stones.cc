#include "controller/stereo/sand_and_stones.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "controller/base/check.h"

namespace dockyard {
namespace {

constexpr int kTile_px = 8;

float MiddleOf(std::vector<float>& values) {
  if (values.empty()) return std::numeric_limits<float>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Medians of tiles, then medians of the tiles about each: a stone that covers less than half of
// its surroundings does not move them.
cv::Mat Surroundings(const cv::Mat& rest_px, int around_tiles) {
  const int columns = (rest_px.cols + kTile_px - 1) / kTile_px;
  const int rows = (rest_px.rows + kTile_px - 1) / kTile_px;
  cv::Mat tiles(rows, columns, CV_32F), around(rows, columns, CV_32F);
  std::vector<float> values;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      values.clear();
      for (int v = y * kTile_px; v < std::min((y + 1) * kTile_px, rest_px.rows); ++v) {
        for (int u = x * kTile_px; u < std::min((x + 1) * kTile_px, rest_px.cols); ++u) {
          if (const float px = rest_px.at<float>(v, u); !std::isnan(px)) values.push_back(px);
        }
      }
      tiles.at<float>(y, x) = MiddleOf(values);
    }
  }
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      values.clear();
      for (int j = std::max(0, y - around_tiles); j <= std::min(rows - 1, y + around_tiles); ++j) {
        for (int i = std::max(0, x - around_tiles); i <= std::min(columns - 1, x + around_tiles);
             ++i) {
          if (const float px = tiles.at<float>(j, i); !std::isnan(px)) values.push_back(px);
        }
      }
      around.at<float>(y, x) = MiddleOf(values);
    }
  }
  return around;
}

}  // namespace

Disparities MergeStones(const Disparities& sand, const Disparities& stones,
                        const PlaneDisparity& ground, const SandAndStonesSettings& with) {
  DOCKYARD_CHECK(sand.width == stones.width && sand.height == stones.height);
  cv::Mat rest_px(stones.height, stones.width, CV_32F);
  for (int v = 0; v < stones.height; ++v) {
    for (int u = 0; u < stones.width; ++u) {
      const float px = stones.at(u, v);
      rest_px.at<float>(v, u) = px - static_cast<float>(ground.At(u, v));
    }
  }
  const cv::Mat around = Surroundings(rest_px, with.around_tiles);
  cv::Mat stands_out(stones.height, stones.width, CV_8U);
  for (int v = 0; v < stones.height; ++v) {
    for (int u = 0; u < stones.width; ++u) {
      const double level_px =
          ground.At(u, v) + static_cast<double>(around.at<float>(v / kTile_px, u / kTile_px));
      const double sharp_px = static_cast<double>(stones.at(u, v)) - level_px;
      const double smooth_px = static_cast<double>(sand.at(u, v)) - level_px;
      const bool sharp = std::abs(sharp_px) > with.stands_out_px;
      const bool smooth =
          std::isnan(smooth_px) ||
          (std::abs(smooth_px) > 0.75 * with.stands_out_px && sharp_px * smooth_px > 0.0);
      stands_out.at<std::uint8_t>(v, u) = sharp && smooth ? 255 : 0;
    }
  }
  const int side = 2 * with.beside_px + 1;
  cv::dilate(stands_out, stands_out, cv::getStructuringElement(cv::MORPH_RECT, {side, side}));
  Disparities merged = sand;
  std::size_t place = 0;
  for (int v = 0; v < sand.height; ++v) {
    for (int u = 0; u < sand.width; ++u, ++place) {
      if (stands_out.at<std::uint8_t>(v, u) != 0) merged.px[place] = stones.px[place];
    }
  }
  return merged;
}

Disparities WithoutEdges(const Disparities& disparities, const PlaneDisparity& ground,
                         int beside_px, double drop_px) {
  std::vector<float> rest_px(disparities.px.size());
  std::size_t place = 0;
  for (int v = 0; v < disparities.height; ++v) {
    for (int u = 0; u < disparities.width; ++u, ++place) {
      rest_px[place] = disparities.px[place] - static_cast<float>(ground.At(u, v));
    }
  }
  Disparities kept = disparities;
  place = 0;
  for (int v = 0; v < kept.height; ++v) {
    for (int u = 0; u < kept.width; ++u, ++place) {
      for (int y = std::max(0, v - beside_px); y <= std::min(kept.height - 1, v + beside_px); ++y) {
        for (int x = std::max(0, u - beside_px); x <= std::min(kept.width - 1, u + beside_px);
             ++x) {
          const auto other = static_cast<std::size_t>(y) * static_cast<std::size_t>(kept.width) +
                             static_cast<std::size_t>(x);
          if (static_cast<double>(rest_px[place] - rest_px[other]) > drop_px) {
            kept.px[place] = std::numeric_limits<float>::quiet_NaN();
          }
        }
      }
    }
  }
  return kept;
}

Disparities MatchSandAndStones(const Rectifier& rectifier, const StereoImages& images,
                               const PlaneDisparity& ground, const SandAndStonesSettings& with) {
  MatchSettings sand = with.sand, stones = with.stones;
  sand.ground = stones.ground = ground;
  return MergeStones(Match(rectifier, images, sand), Match(rectifier, images, stones), ground,
                     with);
}

}  // namespace dockyard
