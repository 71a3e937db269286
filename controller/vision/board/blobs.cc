#include "controller/vision/board/blobs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "controller/base/check.h"
#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

// Closing window: regions up to about 19 px of a level are filled; two levels overlap. A small
// window follows the light closely, broken shade included.
constexpr int kWindow = 21;
constexpr int kLevels = 5;  // up to 16 * 19 = 300 px across: a 10 cm disc at 0.22 m, f = 652 px
// Thresholds on dark over light. A mark's black over its white, albedo 0.05 to 0.85, is 0.06, with
// haze, veiling light or a small disc's blur more: up to 0.68 (assumed, 0.6-0.75; ground texture
// seldom gets there). In broken shade the light itself varies within the window, down to the sky's
// share; then only a threshold between 0.06 and that share parts black from shaded white.
constexpr std::array<double, 4> kBlack{0.68, 0.50, 0.36, 0.19};
// Light that the lens spreads over the whole image (sun in the lens, dust on it) lifts the black
// too, and ratios mean nothing until it is subtracted. It is the level of the darkest thousandth of
// the pixels beyond an ordinary image's black (3-9 DN in rendered views; assumed, 10-40).
constexpr double kVeiledShare = 0.001;
constexpr int kOrdinaryBlack = 20;

constexpr int kDarkest = 10;  // [DN] light below which nothing is searched; 5 sigma of noise

/// Smallest blob considered on the finest level [px]: two thirds of a 7 px disc seen at 45 deg.
constexpr double kMinAxis = 2.0;
constexpr double kMaxAxis = 11.0;  // semi-axis; the closing fills no wider blobs
constexpr std::size_t kMostOutline = 8 * kWindow;
constexpr int kReach = kMostOutline / 2 + 3;  // of a tile beyond itself: half an outline and a rim
constexpr double kMinAxisRatio = 0.30;  // 65 deg oblique, and the lens's stretch at the border
constexpr double kMaxHoleShare = 0.55;  // the bar covers 18 % of the disc; blur and threshold widen
constexpr int kMaxHoles = 3;            // Euler number >= -2: noise may split the bar's image
constexpr double kCoincidence = 0.45;   // of the mean radius, between black and white centroids

int VeilingLight(const GrayImage& image) {
  std::array<std::size_t, 256> histogram{};
  for (const std::uint8_t value : image.pixels) ++histogram[value];
  const double wanted = kVeiledShare * static_cast<double>(image.pixels.size());
  std::size_t count = 0;
  int black = 0;
  while (black < 255 &&
         static_cast<double>(count += histogram[static_cast<std::size_t>(black)]) < wanted) {
    ++black;
  }
  return std::max(0, black - kOrdinaryBlack);
}

cv::Mat Flatten(const cv::Mat& gray, int veil) {
  cv::Mat smooth, light, flat;
  cv::GaussianBlur(gray, smooth, cv::Size(3, 3), 0.7);
  if (veil > 0) cv::subtract(smooth, veil, smooth);
  cv::morphologyEx(smooth, light, cv::MORPH_CLOSE,
                   cv::getStructuringElement(cv::MORPH_RECT, cv::Size(kWindow, kWindow)));
  cv::max(light, kDarkest, light);
  cv::divide(smooth, light, flat, kFlatWhite);
  return flat;
}

using Contours = std::vector<std::vector<cv::Point>>;

/// Filters on the white regions within the black one. A region without a hole passes: at a distance
/// the blur hides the bar, and the local refinement brings it back.
bool HolesPass(const Contours& contours, const std::vector<cv::Vec4i>& links, int first,
               const Ellipse& outer, double outer_area) {
  int holes = 0;
  double area = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (int hole = first; hole >= 0; hole = links[static_cast<std::size_t>(hole)][0]) {
    const cv::Moments m = cv::moments(contours[static_cast<std::size_t>(hole)]);
    if (m.m00 < 1.0) continue;
    ++holes;
    area += m.m00;
    moment += Eigen::Vector2d(m.m10, m.m01);
  }
  if (holes == 0) return true;
  if (holes > kMaxHoles || area > kMaxHoleShare * outer_area) return false;
  return (moment / area - outer.centre_px).norm() < kCoincidence * outer.mean_radius_px();
}

std::optional<Blob> Filter(const Contours& contours, const std::vector<cv::Vec4i>& links, int index,
                           const BlobLevel& level) {
  const std::vector<cv::Point>& outline = contours[static_cast<std::size_t>(index)];
  if (outline.size() < 6 || outline.size() > kMostOutline) return std::nullopt;
  const cv::Moments m = cv::moments(outline);
  const std::optional<Ellipse> ellipse = MomentEllipse(m);
  if (!ellipse || !FitsInside(*ellipse, level.flat.size())) return std::nullopt;
  const Eigen::Vector2d axes = ellipse->semi_axes_px();
  const double smallest = level.level == 0 ? kMinAxis : 2.0 * kMinAxis;
  if (axes(0) < smallest || axes(1) > kMaxAxis / kMinAxisRatio || axes(0) > kMaxAxis) {
    return std::nullopt;
  }
  if (axes(0) < kMinAxisRatio * axes(1)) return std::nullopt;
  // An ellipse's outline encloses pi a b; frayed and crescent shapes enclose less.
  const double ellipse_area = kPi * (axes(0) - 0.5) * (axes(1) - 0.5);
  const double fullness = m.m00 / ellipse_area;
  if (fullness < 0.75) return std::nullopt;
  const int hole = links[static_cast<std::size_t>(index)][2];
  if (!HolesPass(contours, links, hole, *ellipse, m.m00)) return std::nullopt;
  return Blob{.moments = *ellipse};
}

struct FoundBlob {
  cv::Point first;  // of its outline
  Blob blob;
};

/// The blobs whose box begins in the tile. Its surroundings are as wide as the longest outline that
/// passes, so every other outline that they cut fails the filters, or begins elsewhere.
void FindInTile(const BlobLevel& level, const cv::Mat& black, const cv::Rect& tile,
                std::vector<FoundBlob>& found) {
  const cv::Rect wide =
      cv::Rect(tile.x - 1, tile.y - 1, tile.width + kReach, tile.height + kReach) &
      cv::Rect(0, 0, black.cols, black.rows);
  Contours contours;
  std::vector<cv::Vec4i> links;  // next, previous, first hole, parent
  cv::findContours(black(wide), contours, links, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE, wide.tl());
  for (int i = 0; i < static_cast<int>(contours.size()); ++i) {
    if (links[static_cast<std::size_t>(i)][3] >= 0) continue;  // a hole
    const std::vector<cv::Point>& outline = contours[static_cast<std::size_t>(i)];
    const auto blob = Filter(contours, links, i, level);
    if (blob && tile.contains(cv::boundingRect(outline).tl())) found.push_back({outline[0], *blob});
  }
}

}  // namespace

std::optional<Ellipse> MomentEllipse(const cv::Moments& m) {
  if (m.m00 < 4.0) return std::nullopt;
  Eigen::Matrix2d covariance;
  covariance << m.mu20, m.mu11, m.mu11, m.mu02;
  covariance /= m.m00;
  // Square root of a 2x2 matrix (Cayley-Hamilton); a disc of radius R has variance R^2/4.
  const double root = std::sqrt(std::max(covariance.determinant(), 0.0));
  if (root < 1e-9) return std::nullopt;
  const Eigen::Matrix2d shape = 2.0 * (covariance + root * Eigen::Matrix2d::Identity()) /
                                std::sqrt(covariance.trace() + 2.0 * root);
  return Ellipse{.centre_px = Eigen::Vector2d(m.m10 / m.m00, m.m01 / m.m00),
                 .shape_px = shape + 0.5 * Eigen::Matrix2d::Identity()};
}

bool FitsInside(const Ellipse& ellipse, const cv::Size& size) {
  const double reach_x = ellipse.shape_px.row(0).norm(), reach_y = ellipse.shape_px.row(1).norm();
  return ellipse.centre_px.x() - reach_x > 0.0 && ellipse.centre_px.y() - reach_y > 0.0 &&
         ellipse.centre_px.x() + reach_x < size.width - 1.0 &&
         ellipse.centre_px.y() + reach_y < size.height - 1.0;
}

std::vector<BlobLevel> BuildLevels(const GrayImage& image) {
  DOCKYARD_CHECK(image.pixels.size() ==
                 static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  // One thread, whatever the machine: a static of the function's own, set once.
  [[maybe_unused]] static const bool single = (cv::setNumThreads(1), true);
  const int veil = VeilingLight(image);
  std::vector<BlobLevel> levels;
  cv::Mat gray(image.height, image.width, CV_8U,
               const_cast<std::uint8_t*>(image.pixels.data()));  // only read
  for (int level = 0; level < kLevels && gray.rows >= kWindow && gray.cols >= kWindow; ++level) {
    levels.push_back({.level = level, .gray = gray, .flat = Flatten(gray, veil)});
    cv::Mat even = gray(cv::Rect(0, 0, gray.cols & ~1, gray.rows & ~1));
    cv::Mat half;
    cv::resize(even, half, cv::Size(even.cols / 2, even.rows / 2), 0, 0, cv::INTER_AREA);
    gray = half;
  }
  return levels;
}

std::vector<Blob> FindBlobs(const BlobLevel& level, int tile_px) {
  std::vector<Blob> blobs;
  for (const double threshold : kBlack) {
    cv::Mat black;
    cv::threshold(level.flat, black, threshold * kFlatWhite, 255, cv::THRESH_BINARY_INV);
    std::vector<FoundBlob> found;
    for (int y = 0; y < black.rows; y += tile_px) {
      for (int x = 0; x < black.cols; x += tile_px) {
        FindInTile(level, black, cv::Rect(x, y, tile_px, tile_px), found);
      }
    }
    // As findContours would order all: by the first pixel, from the bottom.
    std::sort(found.begin(), found.end(), [](const FoundBlob& a, const FoundBlob& b) {
      return std::make_pair(a.first.y, a.first.x) > std::make_pair(b.first.y, b.first.x);
    });
    for (FoundBlob& one : found) {
      one.blob.threshold = threshold;
      blobs.push_back(one.blob);
    }
  }
  return blobs;
}

}  // namespace dockyard
