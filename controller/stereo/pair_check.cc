#include "controller/stereo/pair_check.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "controller/base/split_mix.h"
#include "controller/stereo/gray_mat.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int kMostCorners = 200;
constexpr double kCornerQuality = 0.01;  // of the sharpest one
constexpr int kMostWidth_px = 800;       // wider images are made smaller
constexpr double kBlur_px = 1.0;         // takes noise off
constexpr int kMostHalf_px = 8;          // of a patch
constexpr int kLeastSide_px = 24;        // of an image
constexpr int kMostRows_px = 24;         // above and below
constexpr double kLeastScore = 0.7;      // of normalised correlation; assumed, 0.6-0.8
constexpr double kLeastContrast = 1.0;   // grey, one sigma over a patch
constexpr double kBack_px = 1.5;         // a corner must come back so near
constexpr double kAgrees_px = 1.0;       // rows that agree
constexpr double kMostSlope = 0.2;       // of rows: 11 deg, 20 % of scale
constexpr int kDraws = 400;              // of three corners

/// Both images, smaller by a whole number and smoothed.
struct Views {
  cv::Mat left, right, mask;  // mask: where the left camera sees a whole patch
  int smaller = 1, half_px = kMostHalf_px, rows_px = kMostRows_px;
};

Views ViewsOf(const Rectifier& rectifier, const StereoImages& images) {
  const StereoImages rectified = rectifier.Rectified(images);
  const int width = rectified.left.width, height = rectified.left.height;
  Views views;
  views.smaller = (width + kMostWidth_px - 1) / kMostWidth_px;
  const cv::Size size(width / views.smaller, height / views.smaller);
  if (std::min(size.width, size.height) < kLeastSide_px) return views;
  views.half_px = std::min(kMostHalf_px, std::min(size.width, size.height) / 6);
  views.rows_px = std::min(kMostRows_px, size.height / 4);
  const auto Made = [&](const GrayImage& image) {
    cv::Mat small, out;
    cv::resize(MatOn(image), small, size, 0, 0, cv::INTER_AREA);
    cv::GaussianBlur(small, out, {}, kBlur_px);
    return out;
  };
  views.left = Made(rectified.left);
  views.right = Made(rectified.right);
  cv::Mat valid(size, CV_8U);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const bool is_valid = rectifier.IsSeen(u * views.smaller, v * views.smaller, false);
      valid.at<std::uint8_t>(v, u) = is_valid ? 255 : 0;
    }
  }
  const int side = 2 * views.half_px + 3;
  cv::erode(valid, views.mask, cv::Mat::ones(side, side, CV_8U), {-1, -1}, 1, cv::BORDER_CONSTANT,
            cv::Scalar(0));
  return views;
}

double ContrastOf(const cv::Mat& patch) {
  cv::Scalar mean, sigma;
  cv::meanStdDev(patch, mean, sigma);
  return sigma[0];
}

// Between the places before and after a peak.
double Past(double before, double peak, double after) {
  const double bend = before - 2.0 * peak + after;
  return bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
}

/// The place in `to` that correlates best with `from` about a pixel; none where nothing does.
std::optional<Vector2d> Sought(const cv::Mat& from, const cv::Mat& to, const Vector2d& pixel,
                               const Views& views) {
  const int half = views.half_px, side = 2 * half + 1;
  const int u = static_cast<int>(std::lround(pixel.x())),
            v = static_cast<int>(std::lround(pixel.y()));
  if (u < half || v < half || u + half >= from.cols || v + half >= from.rows) return std::nullopt;
  const cv::Mat patch = from(cv::Rect(u - half, v - half, side, side));
  if (ContrastOf(patch) < kLeastContrast) return std::nullopt;
  const int top = std::max(0, v - views.rows_px - half),
            bottom = std::min(to.rows, v + views.rows_px + half + 1);
  cv::Mat scores;
  cv::matchTemplate(to.rowRange(top, bottom), patch, scores, cv::TM_CCOEFF_NORMED);
  double best = 0.0;
  cv::Point at;
  cv::minMaxLoc(scores, nullptr, &best, nullptr, &at);
  if (!(best >= kLeastScore)) return std::nullopt;
  if (ContrastOf(to(cv::Rect(at.x, top + at.y, side, side))) < kLeastContrast) return std::nullopt;
  Vector2d found(at.x + half, top + at.y + half);
  const auto Score = [&](int x, int y) { return static_cast<double>(scores.at<float>(y, x)); };
  if (at.x > 0 && at.x + 1 < scores.cols) {
    found.x() += Past(Score(at.x - 1, at.y), best, Score(at.x + 1, at.y));
  }
  if (at.y > 0 && at.y + 1 < scores.rows) {
    found.y() += Past(Score(at.x, at.y - 1), best, Score(at.x, at.y + 1));
  }
  return found;
}

std::vector<Vector2d> CornersOf(const Views& views) {
  std::vector<cv::Point2f> corners;
  const double apart_px = 0.5 * std::sqrt(1.0 * views.left.cols * views.left.rows / kMostCorners);
  cv::goodFeaturesToTrack(views.left, corners, kMostCorners, kCornerQuality, apart_px, views.mask,
                          5);
  std::vector<Vector2d> pixels;
  for (const cv::Point2f& corner : corners) {
    pixels.emplace_back(std::round(corner.x), std::round(corner.y));
  }
  return pixels;
}

/// lower = rows . (1, u, v), from the middle of the image.
double LowerAt(const Vector3d& rows, const Vector2d& p) {
  return rows.dot(Vector3d(1, p.x(), p.y()));
}

std::vector<FoundCorner> Agreeing(const std::vector<FoundCorner>& corners, const Vector3d& rows) {
  std::vector<FoundCorner> agreeing;
  for (const FoundCorner& corner : corners) {
    if (std::abs(corner.lower_px - LowerAt(rows, corner.left)) <= kAgrees_px) {
      agreeing.push_back(corner);
    }
  }
  return agreeing;
}

// By least squares. The slopes are held, weakly, where all corners lie in one line.
Vector3d Fitted(const std::vector<FoundCorner>& corners) {
  Eigen::Matrix3d A = Vector3d(1e-9, 1.0, 1.0).asDiagonal();
  Vector3d b = Vector3d::Zero();
  for (const FoundCorner& corner : corners) {
    const Vector3d row(1.0, corner.left.x(), corner.left.y());
    A += row * row.transpose();
    b += corner.lower_px * row;
  }
  return A.inverse() * b;
}

/// The rows on which most corners agree, among those of three corners each (RANSAC).
Vector3d MostAgreed(const std::vector<FoundCorner>& corners) {
  Vector3d best = Vector3d::Zero();
  std::size_t most = 0;
  const auto Try = [&](const Vector3d& rows) {
    if (std::max(std::abs(rows.y()), std::abs(rows.z())) > kMostSlope) return;
    const std::size_t agreeing = Agreeing(corners, rows).size();
    if (agreeing <= most) return;
    most = agreeing;
    best = rows;
  };
  for (const FoundCorner& corner : corners) Try({corner.lower_px, 0.0, 0.0});
  std::uint64_t place = 0;
  const auto Any = [&] {
    return corners[SplitMix(7, place++) % static_cast<std::uint64_t>(corners.size())];
  };
  for (int draw = 0; draw < kDraws; ++draw) {
    Eigen::Matrix3d A;
    Vector3d b;
    for (int i = 0; i < 3; ++i) {
      const FoundCorner corner = Any();
      A.row(i) << 1.0, corner.left.x(), corner.left.y();
      b[i] = corner.lower_px;
    }
    if (std::abs(A.determinant()) > 100.0) Try(A.inverse() * b);
  }
  return best;
}

double SpanOf(const std::vector<FoundCorner>& corners, int axis) {
  double low = corners.front().left[axis], high = low;
  for (const FoundCorner& corner : corners) {
    low = std::min(low, corner.left[axis]);
    high = std::max(high, corner.left[axis]);
  }
  return high - low;
}

/// Found there and back, about the middle of the smaller image.
std::vector<FoundCorner> FoundMutually(const Views& views, const std::vector<Vector2d>& corners) {
  const Vector2d middle(0.5 * views.left.cols, 0.5 * views.left.rows);
  std::vector<FoundCorner> found;
  for (const Vector2d& corner : corners) {
    const auto there = Sought(views.left, views.right, corner, views);
    const auto back = there ? Sought(views.right, views.left, *there, views) : std::nullopt;
    if (!back || (*back - corner).norm() > kBack_px) continue;
    found.push_back({corner - middle, corner.x() - there->x(), there->y() - corner.y()});
  }
  return found;
}

}  // namespace

PairCheck CheckPair(const Rectifier& rectifier, const StereoImages& images) {
  const Views views = ViewsOf(rectifier, images);
  PairCheck check;
  check.pixel_px = views.smaller;
  check.farthest_row_px = views.smaller * views.rows_px;
  if (views.left.empty()) return check;
  const std::vector<Vector2d> corners = CornersOf(views);
  check.corners = static_cast<int>(corners.size());
  const std::vector<FoundCorner> found = FoundMutually(views, corners);
  check.both_ways = static_cast<int>(found.size());
  if (found.size() < 3) return check;
  Vector3d rows = MostAgreed(found);
  for (int i = 0; i < 2; ++i) rows = Fitted(Agreeing(found, rows));
  check.found = Agreeing(found, rows);
  if (check.found.empty()) return check;
  const double scale = views.smaller;
  check.across_px = scale * rows.y() * SpanOf(check.found, 0);
  check.down_px = scale * rows.z() * SpanOf(check.found, 1);
  check.turn_rad = std::atan(rows.y());
  check.scale = rows.z();
  std::vector<double> lower;
  for (FoundCorner& corner : check.found) {
    corner.left = scale * (corner.left + Vector2d(0.5 * views.left.cols, 0.5 * views.left.rows));
    corner.disparity_px *= scale;
    corner.lower_px *= scale;
    lower.push_back(corner.lower_px);
  }
  std::sort(lower.begin(), lower.end());
  check.lower_px = lower[lower.size() / 2];
  return check;
}

}  // namespace dockyard
