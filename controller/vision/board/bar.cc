#include "controller/vision/board/bar.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/geometry/pose.h"
#include "controller/vision/board/blobs.h"

namespace dockyard {
namespace {

constexpr double kSurround = 1.35;  // how far out the pattern is compared, in rim radii
constexpr double kHopeless = 0.12;  // correlation of a quarter of the angles, below which no more
constexpr double kNoBar = -10.0;    // half a bar's length in rim radii, beyond any blur

/// A step blurred over a distance in sigmas: a cubic with the Gaussian's slope in the middle.
double Step(double distance, double blur_px) {
  const double t = std::clamp(0.5 + distance / (3.75 * blur_px), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// Pearson's correlation, gathered sample by sample.
struct Correlation {
  double n = 0, sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0;
  void Add(double a, double b) {
    n += 1;
    sa += a;
    sb += b;
    saa += a * a;
    sbb += b * b;
    sab += a * b;
  }
  double value() const {
    const double va = saa - sa * sa / n, vb = sbb - sb * sb / n;
    return n > 0 && va > 1e-9 && vb > 1e-9 ? (sab - sa * sb / n) / std::sqrt(va * vb) : 0.0;
  }
};

struct Sample {
  double value = 0.0;  // flat grey, white is one
  Eigen::Vector2d disc;
  double ground = 0.0;  // white around the disc, blurred: 0 inside, 1 outside
};

std::vector<Sample> Gather(const cv::Mat& flat, const Ellipse& rim, double blur_px,
                           double white_level) {
  const Eigen::Matrix2d inverse = rim.shape_px.inverse();
  const double reach_x = kSurround * rim.shape_px.row(0).norm();
  const double reach_y = kSurround * rim.shape_px.row(1).norm();
  const int x0 = static_cast<int>(std::ceil(rim.centre_px.x() - reach_x));
  const int x1 = static_cast<int>(std::floor(rim.centre_px.x() + reach_x));
  const int y0 = static_cast<int>(std::ceil(rim.centre_px.y() - reach_y));
  const int y1 = static_cast<int>(std::floor(rim.centre_px.y() + reach_y));
  std::vector<Sample> samples;
  for (int y = std::max(y0, 0); y <= std::min(y1, flat.rows - 1); ++y) {
    const std::uint8_t* row = flat.ptr<std::uint8_t>(y);
    for (int x = std::max(x0, 0); x <= std::min(x1, flat.cols - 1); ++x) {
      const Eigen::Vector2d n = inverse * (Eigen::Vector2d(x, y) - rim.centre_px);
      const double length = n.norm();
      if (length >= kSurround) continue;
      const double slope = length > 1e-6 ? (inverse * (n / length)).norm() : 1.0;
      const double value = std::min(row[x] / (kFlatWhite * white_level), 1.0);
      samples.push_back({value, n, Step((length - 1.0) / slope, blur_px)});
    }
  }
  return samples;
}

/// The printed pattern at one sample, bar along the unit vector: black zero, white one.
struct BarPattern {
  Eigen::Vector2d along, across;
  double half_length, half_width;    // in rim radii
  double along_slope, across_slope;  // radii per pixel
  double blur_px;
  double white_level;

  double At(const Sample& sample) const {
    const double u = std::abs(sample.disc.dot(along)), v = std::abs(sample.disc.dot(across));
    const double bar = Step((half_length - u) / along_slope, blur_px) *
                       Step((half_width - v) / across_slope, blur_px);
    return std::min(std::max(sample.ground, bar) / white_level, 1.0);
  }
};

BarPattern Pattern(int index, const Ellipse& rim, const FiducialBoard& board, double blur_px,
                   double white_level) {
  const double angle = kPi * index / kBarAngles;
  BarPattern bar;
  bar.along = Eigen::Vector2d(std::cos(angle), -std::sin(angle));
  bar.across = Eigen::Vector2d(std::sin(angle), std::cos(angle));
  bar.half_length = board.HasBars() ? board.bar_length_m / board.disc_diameter_m : kNoBar;
  bar.half_width = board.bar_width_m / board.disc_diameter_m;
  const Eigen::Matrix2d inverse = rim.shape_px.inverse();
  bar.along_slope = (inverse * bar.along).norm();
  bar.across_slope = (inverse * bar.across).norm();
  bar.blur_px = blur_px;
  bar.white_level = white_level;
  return bar;
}

double Contrast(const std::vector<Sample>& samples, const BarPattern& bar) {
  double white = 0.0, black = 0.0;
  int whites = 0, blacks = 0;
  for (const Sample& sample : samples) {
    if (sample.disc.norm() > 1.15) {
      white += sample.value;
      ++whites;
    } else if (bar.At(sample) < 0.25) {
      black += sample.value;
      ++blacks;
    }
  }
  if (whites == 0 || blacks == 0) return 0.0;
  return 1.0 - (black / blacks) / std::max(white / whites, 1e-3);
}

}  // namespace

std::optional<BarMatch> MatchBar(const cv::Mat& flat, const Ellipse& rim,
                                 const FiducialBoard& board, double blur_px, double white_level) {
  const std::vector<Sample> samples = Gather(flat, rim, blur_px, white_level);
  const double expected = kPi * kSurround * kSurround * rim.shape_px.determinant();
  if (static_cast<double>(samples.size()) < 0.85 * expected) return std::nullopt;
  const auto correlate = [&](int angle, double reach) {
    const BarPattern bar = Pattern(angle, rim, board, blur_px, white_level);
    Correlation correlation;
    for (const Sample& sample : samples) {
      if (sample.disc.norm() < reach) correlation.Add(sample.value, bar.At(sample));
    }
    return correlation.value();
  };
  BarMatch match;
  if (!board.HasBars()) {
    match.whole = correlate(0, kSurround);
    match.contrast = Contrast(samples, Pattern(0, rim, board, blur_px, white_level));
    return match;
  }
  match.inner.fill(-1.0f);
  int best = 0;
  const auto try_angle = [&](int angle) {
    float& score = match.inner[static_cast<std::size_t>(angle)];
    score = static_cast<float>(correlate(angle, 1.0));
    if (score > match.inner[static_cast<std::size_t>(best)]) best = angle;
  };
  // Every fourth first: a true bar is at most 22.5 deg from one of them, and shows.
  for (int i = 0; i < kBarAngles; i += 4) try_angle(i);
  if (match.inner[static_cast<std::size_t>(best)] < kHopeless) return std::nullopt;
  for (int i = 0; i < kBarAngles; ++i) {
    if (i % 4 != 0) try_angle(i);
  }
  match.whole = correlate(best, kSurround);
  match.contrast = Contrast(samples, Pattern(best, rim, board, blur_px, white_level));
  return match;
}

}  // namespace dockyard
