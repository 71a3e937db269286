#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "controller/geometry/pose.h"
#include "controller/vision/board/blobs.h"
#include "controller/vision/board/tsai2013.h"

namespace dockyard {
namespace {

// Wellner's adaptive threshold (EuroPARC EPC-93-110, 1993) in the form of the toolbox that the
// paper cites: a pixel is black when it lies a share below the Gaussian mean about it.
cv::Mat AdaptiveBlack(const cv::Mat& gray, const Tsai2013Vision& settings) {
  cv::Mat values, mean, black;
  gray.convertTo(values, CV_32F);
  cv::GaussianBlur(values, mean, cv::Size(), settings.window_share * gray.cols, 0.0,
                   cv::BORDER_REPLICATE);
  cv::compare(values, mean * (1.0 - settings.black_below_mean), black, cv::CMP_LT);
  return black;
}

// More outlines are noise, and no marks are found: cv::findContours takes 1.4 s for 125 000 of them
// (3 megapixels of noise), and 34 s for 500 000. A rendered image 1024 px wide has 1000.
constexpr int kMostOutlines = 150000;

/// How many outlines cv::findContours would find: of the black regions and of their holes.
int CountOutlines(const cv::Mat& black) {
  cv::Mat labels;  // the background counts as one
  const int regions = cv::connectedComponents(black, labels, 8, CV_32S) - 1;
  return regions + cv::connectedComponents(~black, labels, 4, CV_32S) - 2;
}

/// Threshold half way between the darkest and the brightest tenth of a region's surroundings.
double LocalThreshold(const cv::Mat& patch) {
  std::vector<std::uint8_t> values;
  for (int y = 0; y < patch.rows; ++y) {
    values.insert(values.end(), patch.ptr(y), patch.ptr(y) + patch.cols);
  }
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return 0.5 * (values[n / 20] + values[n - 1 - n / 20]);
}

struct Pattern {
  double white_share = 0.0;
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  // of the white, in rim radii
  double direction_rad = 0.0;  // major axis, counter-clockwise as the viewer sees it
};

/// The white inside a disc, seen with the rim as a unit circle.
Pattern InsidePattern(const cv::Mat& gray, const Ellipse& rim, double threshold, double within) {
  Pattern pattern;
  const double reach_x = rim.shape_px.row(0).norm(), reach_y = rim.shape_px.row(1).norm();
  int all = 0, white = 0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  const int x0 = std::max(0, static_cast<int>(rim.centre_px.x() - reach_x));
  const int x1 = std::min(gray.cols - 1, static_cast<int>(rim.centre_px.x() + reach_x) + 1);
  const int y0 = std::max(0, static_cast<int>(rim.centre_px.y() - reach_y));
  const int y1 = std::min(gray.rows - 1, static_cast<int>(rim.centre_px.y() + reach_y) + 1);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const Eigen::Vector2d n = rim.ToDisc({x, y});
      if (n.norm() > within) continue;
      ++all;
      if (gray.at<std::uint8_t>(y, x) < threshold) continue;
      ++white;
      sum += n;
      squares += n * n.transpose();
    }
  }
  if (white < 2) return pattern;
  pattern.white_share = within * within * white / all;
  pattern.centroid = sum / white;
  const Eigen::Matrix2d M = squares / white - pattern.centroid * pattern.centroid.transpose();
  const double angle = 0.5 * std::atan2(2.0 * M(0, 1), M(0, 0) - M(1, 1));  // y down
  pattern.direction_rad = -angle;
  return pattern;
}

/// The region's outline after a local threshold, as an ellipse through its perimeter.
std::optional<Ellipse> Perimeter(const cv::Mat& gray, const cv::Rect& box, double threshold) {
  cv::Mat black;
  cv::threshold(gray(box), black, threshold, 255, cv::THRESH_BINARY_INV);
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(black, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE, box.tl());
  const auto largest = std::max_element(
      outlines.begin(), outlines.end(),
      [](const auto& a, const auto& b) { return cv::contourArea(a) < cv::contourArea(b); });
  if (largest == outlines.end()) return std::nullopt;
  std::vector<Eigen::Vector2d> rim;
  for (const cv::Point& p : *largest) rim.emplace_back(p.x, p.y);
  auto ellipse = FitEllipse(rim);
  if (ellipse) ellipse->shape_px += 0.5 * Eigen::Matrix2d::Identity();  // to the pixels' outside
  return ellipse;
}

/// The outline's ellipse where its size, eccentricity and fullness pass.
std::optional<Ellipse> Region(const std::vector<cv::Point>& outline, const cv::Size& image,
                              const Tsai2013Vision& settings) {
  const cv::Moments m = cv::moments(outline);
  if (m.m00 < settings.least_area_px || m.m00 > settings.most_area_share * image.area()) {
    return std::nullopt;
  }
  const auto region = MomentEllipse(m);
  if (!region || !FitsInside(*region, image)) return std::nullopt;
  const Eigen::Vector2d axes = region->semi_axes_px();
  if (axes(0) < settings.least_axis_ratio * axes(1) ||
      m.m00 < settings.fullness * kPi * (axes(0) - 0.5) * (axes(1) - 0.5)) {
    return std::nullopt;
  }
  return region;
}

/// The outline's box, a little wider.
cv::Rect BoxAround(const std::vector<cv::Point>& outline, const cv::Mat& gray) {
  const cv::Rect box = cv::boundingRect(outline);
  const int margin = 2 + box.width / 10;
  return cv::Rect(box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin) &
         cv::Rect(0, 0, gray.cols, gray.rows);
}

std::optional<DetectedFiducial> Examine(const cv::Mat& gray, const std::vector<cv::Point>& outline,
                                        const Tsai2013Vision& settings) {
  const auto region = Region(outline, gray.size(), settings);
  if (!region) return std::nullopt;
  const cv::Rect box = BoxAround(outline, gray);
  const double threshold = LocalThreshold(gray(box));
  const auto rim = Perimeter(gray, box, threshold);
  if (!rim || !FitsInside(*rim, gray.size()) ||
      (rim->centre_px - region->centre_px).norm() >
          settings.coincidence * region->mean_radius_px()) {
    return std::nullopt;
  }
  const Pattern pattern = InsidePattern(gray, *rim, threshold, settings.pattern_within);
  if (pattern.white_share < settings.least_white || pattern.white_share > settings.most_white ||
      pattern.centroid.norm() > settings.coincidence) {
    return std::nullopt;
  }
  // The image's up in the plane where the rim is a circle.
  const Eigen::Vector2d up = rim->shape_px.inverse() * Eigen::Vector2d(0.0, -1.0);
  const double lean_rad = std::atan2(-up.y(), up.x()) - kPi / 2.0;
  return DetectedFiducial{.rim = *rim,
                          .match = 1.0,
                          .clear = true,
                          .rotation_class = RotationClass(pattern.direction_rad - lean_rad)};
}

}  // namespace

std::vector<DetectedFiducial> DetectTsai2013(const GrayImage& image,
                                             const Tsai2013Vision& settings) {
  std::vector<DetectedFiducial> found;
  if (image.width < 8 || image.height < 8) return found;
  [[maybe_unused]] static const bool single = (cv::setNumThreads(1), true);
  const cv::Mat gray(image.height, image.width, CV_8U,
                     const_cast<std::uint8_t*>(image.pixels.data()));  // only read
  std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Vec4i> links;  // next, previous, first hole, parent
  const cv::Mat black = AdaptiveBlack(gray, settings);
  if (CountOutlines(black) > kMostOutlines) return found;
  cv::findContours(black, contours, links, cv::RETR_CCOMP, cv::CHAIN_APPROX_NONE);
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (links[i][3] >= 0) continue;  // a hole
    int holes = 0;
    for (int hole = links[i][2]; hole >= 0; hole = links[static_cast<std::size_t>(hole)][0]) {
      holes += cv::contourArea(contours[static_cast<std::size_t>(hole)]) >= 1.0;
    }
    if (holes > settings.most_holes) continue;
    const auto fiducial = Examine(gray, contours[i], settings);
    if (fiducial) found.push_back(*fiducial);
  }
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
    return a.rim.centre_px.y() > b.rim.centre_px.y();
  });
  return found;
}

}  // namespace dockyard
