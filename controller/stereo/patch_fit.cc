#include "controller/stereo/patch_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

// A map so far from the identity, in sigmas, has gone astray. Assumed, 2.5-4.
constexpr double kMostStretches = 3.0;

using Row = Eigen::Matrix<double, 8, 1>;

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

}  // namespace

std::optional<PatchFit> FitPatch(const cv::Mat& patch, const cv::Mat& on_face,
                                 const cv::Mat& picture, const Eigen::Vector2d& at,
                                 const PatchFitSettings& settings) {
  const int half_u = patch.cols / 2, half_v = patch.rows / 2;
  PatchFit fit;
  fit.t = at;
  double gain = 1.0, offset = 0.0;
  for (int round = 0; round < settings.rounds; ++round) {
    Eigen::Matrix<double, 8, 8> N = Eigen::Matrix<double, 8, 8>::Zero();
    Row b = Row::Zero();
    double sum = 0.0;
    int count = 0;
    for (int v = 0; v < patch.rows; ++v) {
      for (int u = 0; u < patch.cols; ++u) {
        if (on_face.at<std::uint8_t>(v, u) == 0) continue;
        const Eigen::Vector2d p(u - half_u, v - half_v);
        const Eigen::Vector2d x = fit.A * p + fit.t;
        const auto seen = Sample(picture, x);
        const auto slope = Slope(picture, x);
        if (!seen || !slope) continue;
        const double grey = patch.at<float>(v, u);
        const double left = *seen - gain * grey - offset;
        Row row;
        row << slope->x() * p.x(), slope->x() * p.y(), slope->y() * p.x(), slope->y() * p.y(),
            slope->x(), slope->y(), -grey, -1.0;
        N += row * row.transpose();
        b -= left * row;
        sum += left * left;
        ++count;
      }
    }
    if (count < 8 * static_cast<int>(settings.alike_px)) return std::nullopt;
    fit.left = std::sqrt(sum / count);
    // The first round has neither gain nor offset yet, and so no measure of the noise.
    if (round > 0) {
      const double weight = settings.alike_px * sum / count / (settings.stretch * settings.stretch);
      const Eigen::Matrix2d off = fit.A - Eigen::Matrix2d::Identity();
      for (int i = 0; i < 4; ++i) {
        N(i, i) += weight;
        b[i] -= weight * off(i / 2, i % 2);
      }
    } else {
      for (int i = 0; i < 4; ++i) N(i, i) += 1e12;
    }
    const Row step = N.ldlt().solve(b);
    if (!step.allFinite()) return std::nullopt;
    for (int i = 0; i < 4; ++i) fit.A(i / 2, i % 2) += step[i];
    fit.t += step.segment<2>(4);
    gain += step[6];
    offset += step[7];
    const double stretched = (fit.A - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff();
    if ((fit.t - at).norm() > settings.most_shift_px || gain <= 0.0 ||
        stretched > kMostStretches * settings.stretch) {
      return std::nullopt;
    }
    if (round > 1 && step.segment<2>(4).norm() < settings.still_px) return fit;
  }
  return std::nullopt;
}

}  // namespace dockyard
