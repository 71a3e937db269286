#include "controller/stereo/patch_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace dockyard {
namespace {

// A map that is further from the identity, in sigmas, has gone astray. Assumed, 2.5-4.
constexpr double kMostStretches = 3.0;

// Where a shadow's edge or the ground behind the face has moved, greys differ by more than noise. A
// pixel counts half where it is off by this, in sigmas (Cauchy's weights: 2.4; Zhang 1997); and the
// least noise, 1 sigma in grey. Assumed, 2-3 and 0.3-1.
constexpr double kHalfCounts = 2.4, kLeastSigma = 0.5;
// 1 sigma over the median of the magnitudes, of a Gaussian.
constexpr double kSigmaOfMedian = 1.4826;

// The four parts of A, t, gain and offset; then the bend.
constexpr int kParts = 11, kPlane = 8;
using Row = Eigen::Matrix<double, kParts, 1>;

// Bilinear; none beyond the border.
std::optional<double> Sample(const cv::Mat& picture, const Eigen::Vector2d& x) {
  const int u = static_cast<int>(std::floor(x.x())), v = static_cast<int>(std::floor(x.y()));
  if (u < 0 || v < 0 || u + 1 >= picture.cols || v + 1 >= picture.rows) return std::nullopt;
  const double a = x.x() - u, b = x.y() - v;
  const double p00 = picture.at<float>(v, u), p01 = picture.at<float>(v, u + 1);
  const double p10 = picture.at<float>(v + 1, u), p11 = picture.at<float>(v + 1, u + 1);
  return (1.0 - b) * ((1.0 - a) * p00 + a * p01) + b * ((1.0 - a) * p10 + a * p11);
}

// Grey a pixel along each side, by the neighbours on both: it has no jumps between the pixels, at
// which the steps would go to and fro.
std::optional<Eigen::Vector2d> Slope(const cv::Mat& picture, const Eigen::Vector2d& x) {
  const auto left = Sample(picture, {x.x() - 1.0, x.y()}),
             right = Sample(picture, {x.x() + 1.0, x.y()});
  const auto above = Sample(picture, {x.x(), x.y() - 1.0}),
             below = Sample(picture, {x.x(), x.y() + 1.0});
  if (!left || !right || !above || !below) return std::nullopt;
  return Eigen::Vector2d(0.5 * (*right - *left), 0.5 * (*below - *above));
}

double Median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double Scatter(std::vector<double> values, double about) {
  for (double& value : values) value = std::abs(value - about);
  return kSigmaOfMedian * Median(std::move(values));
}

// X^2, 2 X Y and Y^2 of a pixel.
Eigen::Vector3d Squares(const Eigen::Vector2d& p, int side) {
  const Eigen::Vector2d at = p / std::max(1, side / 2);
  return {at.x() * at.x(), 2.0 * at.x() * at.y(), at.y() * at.y()};
}

// A pixel of the patch that counts: where it lies in the image by the map of now, and the image
// there.
struct Pixel {
  Eigen::Vector2d p, slope;
  Eigen::Vector3d squares;
  double then = 0.0, now = 0.0;  // greys
};

std::vector<Pixel> Counting(const cv::Mat& patch, const cv::Mat& on_face, const cv::Mat& image,
                            const PatchFit& fit, const Eigen::Vector2d& edge_px) {
  std::vector<Pixel> pixels;
  for (int v = 0; v < patch.rows; ++v) {
    for (int u = 0; u < patch.cols; ++u) {
      if (on_face.at<std::uint8_t>(v, u) == 0) continue;
      const Eigen::Vector2d p(u - patch.cols / 2, v - patch.rows / 2);
      const Eigen::Vector3d squares = Squares(p, patch.cols);
      const Eigen::Vector2d x = fit.A * p + fit.t + squares.dot(fit.bend) * edge_px;
      const auto now = Sample(image, x);
      const auto slope = Slope(image, x);
      if (now && slope) pixels.push_back({p, *slope, squares, patch.at<float>(v, u), *now});
    }
  }
  return pixels;
}

// grey now = gain * grey then + offset.
struct Light {
  double gain = 1.0, offset = 0.0;
};

// By the medians and the scatter about them, which do not follow what has changed.
Light LightOf(const std::vector<Pixel>& pixels) {
  std::vector<double> then, now;
  for (const Pixel& pixel : pixels) {
    then.push_back(pixel.then);
    now.push_back(pixel.now);
  }
  const double then_middle = Median(then), now_middle = Median(now);
  const double gain = std::max(kLeastSigma, Scatter(now, now_middle)) /
                      std::max(kLeastSigma, Scatter(then, then_middle));
  return {gain, now_middle - gain * then_middle};
}

// Normal equations of the next step, and the weighted mean square of what is left.
struct Equations {
  Eigen::Matrix<double, kParts, kParts> N = Eigen::Matrix<double, kParts, kParts>::Zero();
  Row b = Row::Zero();
  double square = 0.0;
};

Equations EquationsOf(const std::vector<Pixel>& pixels, const Light& light,
                      const Eigen::Vector2d& edge_px) {
  std::vector<double> left;
  for (const Pixel& pixel : pixels)
    left.push_back(pixel.now - light.gain * pixel.then - light.offset);
  const double half = kHalfCounts * std::max(kLeastSigma, Scatter(left, 0.0));
  Equations out;
  double sum = 0.0, weights = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Eigen::Vector2d &p = pixels[i].p, &slope = pixels[i].slope;
    Row row;
    row << slope.x() * p.x(), slope.x() * p.y(), slope.y() * p.x(), slope.y() * p.y(), slope.x(),
        slope.y(), -pixels[i].then, -1.0, slope.dot(edge_px) * pixels[i].squares;
    const double weight = 1.0 / (1.0 + left[i] * left[i] / (half * half));
    out.N += weight * row * row.transpose();
    out.b -= weight * left[i] * row;
    sum += weight * left[i] * left[i];
    weights += weight;
  }
  out.square = sum / weights;
  return out;
}

// The map is held near the identity, and the bend near 0.
void Hold(const PatchFit& fit, const PatchFitSettings& settings, Equations& equations) {
  const double weight =
      settings.alike_px * equations.square / (settings.stretch * settings.stretch);
  const Eigen::Matrix2d off = fit.A - Eigen::Matrix2d::Identity();
  for (int i = 0; i < 4; ++i) {
    equations.N(i, i) += weight;
    equations.b[i] -= weight * off(i / 2, i % 2);
  }
  for (int i = 0; i < 3; ++i) {
    equations.N(kPlane + i, kPlane + i) += settings.alike_px * equations.square;
    equations.b[kPlane + i] -= settings.alike_px * equations.square * fit.bend[i];
  }
}

// The step of the first parts; 0 of the others.
Row Solved(const Equations& equations, int parts) {
  using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kParts, kParts>;
  const Square N = equations.N.topLeftCorner(parts, parts);
  Row step = Row::Zero();
  step.head(parts) = N.ldlt().solve(equations.b.head(parts));
  return step;
}

}  // namespace

std::optional<PatchFit> FitPatch(const cv::Mat& patch, const cv::Mat& on_face,
                                 const cv::Mat& picture, const Eigen::Vector2d& at,
                                 const PatchFitSettings& settings) {
  PatchFit fit;
  fit.t = at;
  Light light;
  for (int round = 0; round < settings.rounds; ++round) {
    const std::vector<Pixel> pixels = Counting(patch, on_face, picture, fit, settings.edge_px);
    if (pixels.size() < 8 * static_cast<std::size_t>(settings.alike_px)) return std::nullopt;
    if (round == 0) light = LightOf(pixels);
    Equations equations = EquationsOf(pixels, light, settings.edge_px);
    fit.left = std::sqrt(equations.square);
    Hold(fit, settings, equations);
    const Row step = Solved(equations, settings.edge_px.isZero() ? kPlane : kParts);
    if (!step.allFinite()) return std::nullopt;
    for (int i = 0; i < 4; ++i) fit.A(i / 2, i % 2) += step[i];
    fit.t += step.segment<2>(4);
    fit.bend += step.tail<3>();
    light.gain += step[6];
    light.offset += step[7];
    const double stretched = (fit.A - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff();
    if ((fit.t - at).norm() > settings.most_shift_px || light.gain <= 0.0 ||
        stretched > kMostStretches * settings.stretch) {
      return std::nullopt;
    }
    if (round > 1 && step.segment<2>(4).norm() < settings.still_px) return fit;
  }
  return std::nullopt;
}

}  // namespace dockyard
