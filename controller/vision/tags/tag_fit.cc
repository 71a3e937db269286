#include "controller/vision/tags/tag_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "controller/base/median.h"
#include "controller/vision/descend.h"
#include "controller/vision/tags/tag_pattern.h"
#include "controller/vision/tags/tag_problem.h"

namespace dockyard {
namespace {

constexpr double kBlur_px = 0.7;  // first guess: a pixel's own 0.3 and a lens's of about 0.6

/// The printed squares but their rim, which may border on anything: part of a cell, in cells.
double RimOf(const TagCells& cells, double cell_px) {
  return std::min(std::max(0.3, 1.0 / cell_px), 0.5 + 0.25 * cells.margin);
}

struct Bounds {
  int x0 = 0, y0 = 0, x1 = -1, y1 = -1;
};

/// Pixels about the printed pattern.
std::optional<Bounds> BoundsOf(const GrayImage& image, const TagCells& cells,
                               const Eigen::Matrix3d& plane_from_cells,
                               const StraightPlane& plane) {
  const double half = 0.5 * cells.across;
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  constexpr int kSteps = 8;  // a side: a wide lens bends it
  for (int i = 0; i <= kSteps; ++i) {
    const double t = half * (2.0 * i / kSteps - 1.0);
    for (const Eigen::Vector2d& cell : {Eigen::Vector2d(t, -half), Eigen::Vector2d(t, half),
                                        Eigen::Vector2d(-half, t), Eigen::Vector2d(half, t)}) {
      const auto pixel = plane.ToPixel((plane_from_cells * cell.homogeneous()).hnormalized());
      if (!pixel || !pixel->allFinite()) return std::nullopt;
      low = low.cwiseMin(*pixel);
      high = high.cwiseMax(*pixel);
    }
  }
  return Bounds{.x0 = std::max(0, static_cast<int>(low.x())),
                .y0 = std::max(0, static_cast<int>(low.y())),
                .x1 = std::min(image.width - 1, static_cast<int>(high.x()) + 1),
                .y1 = std::min(image.height - 1, static_cast<int>(high.y()) + 1)};
}

/// Pixels near edges of the pattern, and some of its plain parts for the grey levels.
std::vector<GreySample> SamplesOf(const GrayImage& image, const TagCells& cells,
                                  const LightGrid& grid, const Eigen::Matrix3d& plane_from_cells,
                                  const StraightPlane& plane, double cell_px) {
  constexpr double kNearby_px = 1.0;  // blur by which an edge is near: 3 px of it
  constexpr std::size_t kMost = 1000, kPlainStep = 8;
  // A large tag is sampled with a stride along both sides.
  constexpr double kPixels = 1.5e4;
  std::vector<GreySample> edges, plain;
  const std::optional<Bounds> bounds = BoundsOf(image, cells, plane_from_cells, plane);
  if (!bounds) return {};
  const Eigen::Matrix3d to_cells = plane_from_cells.inverse();
  const double most = 0.5 * cells.across - RimOf(cells, cell_px);
  const Eigen::Vector2d blur = Eigen::Vector2d::Constant(kNearby_px / cell_px);
  const double pixels = (bounds->x1 - bounds->x0 + 1.0) * (bounds->y1 - bounds->y0 + 1.0);
  const int stride = std::max(1, static_cast<int>(std::sqrt(pixels / kPixels)));
  for (int y = bounds->y0; y <= bounds->y1; y += stride) {
    for (int x = bounds->x0; x <= bounds->x1; x += stride) {
      const Eigen::Vector2d point = plane.FromPixel({x, y});
      const Eigen::Vector2d cell = (to_cells * point.homogeneous()).hnormalized();
      if (!(cell.cwiseAbs().maxCoeff() < most)) continue;
      const double share = BlacknessAt(cells, cell, blur).share;
      const bool edge = share > 0.003 && share < 0.997;
      (edge ? edges : plain).push_back({point, grid.At(cell), static_cast<double>(image.at(x, y))});
    }
  }
  const std::size_t step = 1 + edges.size() / kMost;
  std::vector<GreySample> samples;
  for (std::size_t i = 0; i < edges.size(); i += step) samples.push_back(edges[i]);
  for (std::size_t i = 0; i < plain.size(); i += kPlainStep * step) samples.push_back(plain[i]);
  return samples;
}

/// Grey levels that fit the pattern at its first place, even light assumed.
void SetLevels(const TagCells& cells, const LightGrid& grid, const std::vector<GreySample>& samples,
               const Eigen::Matrix3d& to_cells, double cell_px, TagEstimate* at) {
  Eigen::Matrix2d A = Eigen::Matrix2d::Identity() * 1e-9;
  Eigen::Vector2d b = Eigen::Vector2d::Zero();
  const Eigen::Vector2d blur = Eigen::Vector2d::Constant(kBlur_px / cell_px);
  for (const GreySample& sample : samples) {
    const Eigen::Vector2d cell = (to_cells * sample.point.homogeneous()).hnormalized();
    const Eigen::Vector2d row(1.0, BlacknessAt(cells, cell, blur).share);
    A += row * row.transpose();
    b += row * sample.grey;
  }
  const Eigen::Vector2d levels = A.ldlt().solve(b);
  at->light.setConstant(grid.nodes(), std::max(1.0, levels[0]));
  at->contrast = -levels[1] / at->light[0];
}

/// Standard deviation of normal errors, wild ones left aside; of rounding at the least.
double NoiseOf(const std::vector<double>& errors) {
  constexpr double kRounding = 0.289;  // sqrt(1/12), of whole grey levels
  std::vector<double> sizes;
  for (const double error : errors) sizes.push_back(std::abs(error));
  return std::max(kRounding, 1.4826 * Median(sizes));
}

/// The same for the prediction: what a shade or worn ink leaves counts as well, up to a bound.
double SpreadOf(const std::vector<double>& errors) {
  const double most = 6.0 * NoiseOf(errors);
  double sum = 0.0;
  for (const double error : errors) sum += std::pow(std::min(std::abs(error), most), 2);
  return std::max(NoiseOf(errors), std::sqrt(sum / static_cast<double>(errors.size())));
}

// Errors of a fit, as a share of the step from white to black. Assumed, 0.1-0.2.
constexpr double kMostNoise = 0.15;

/// Descends in rounds. Each takes the noise, and how uneven the light is, from the one before:
/// with even light free to vary, errors of the blur's model would pass for light.
bool Fit(const LightGrid& grid, TagProblem* problem, TagEstimate* at) {
  // Bounds of the light's changes from node to node, as a share of it: even light, a sharp shade.
  // Assumed, 0.002-0.01 and 0.2-0.5.
  constexpr double kLeastUneven = 0.005, kMostUneven = 0.3;
  problem->SetNoise(kMostNoise * at->Step());
  problem->SetUnevenness(kMostUneven);
  for (const int iterations : {12, 8, 6}) {
    *at = Descend<TagEquations>(*problem, *at, iterations, 1e-6);
    problem->SetUnevenness(std::clamp(Unevenness(grid, at->light), kLeastUneven, kMostUneven));
    const std::vector<double> errors = problem->Errors(*at);
    if (errors.empty()) return false;
    problem->SetNoise(NoiseOf(errors));
  }
  return true;
}

/// Of a corner, one axis, over all corners [px].
double SigmaOf(const TagEquations& equations, const TagEstimate& at, const StraightPlane& plane) {
  const TagEquations::Square covariance = equations.A.ldlt().solve(
      TagEquations::Square::Identity(equations.A.rows(), equations.A.cols()));
  double variance = 0.0;
  for (int k = 0; k < 4; ++k) {
    const Eigen::Vector2d& corner = at.corners[static_cast<std::size_t>(k)];
    Eigen::Matrix2d J = Eigen::Matrix2d::Identity();
    constexpr double kStep = 1e-3;
    const auto here = plane.ToPixel(corner);
    for (int axis = 0; axis < 2; ++axis) {
      const auto there = plane.ToPixel(corner + kStep * Eigen::Vector2d::Unit(axis));
      if (here && there) J.col(axis) = (*there - *here) / kStep;
    }
    variance += (J * covariance.block<2, 2>(2 * k, 2 * k) * J.transpose()).trace() / 8.0;
  }
  return std::sqrt(variance);
}

}  // namespace

std::optional<TagFit> FitTag(const GrayImage& image, const TagCells& cells,
                             const TagCorners& corners, const Camera* camera) {
  const StraightPlane plane(corners, camera);
  TagEstimate at{.corners = {}, .blur_px = kBlur_px};
  for (std::size_t k = 0; k < 4; ++k) at.corners[k] = plane.FromPixel(corners[k]);
  const std::optional<Eigen::Matrix3d> H = FromCells(at.corners, cells.at_border);
  if (!H) return std::nullopt;
  const double perimeter =
      (at.corners[0] - at.corners[1]).norm() + (at.corners[1] - at.corners[2]).norm() +
      (at.corners[2] - at.corners[3]).norm() + (at.corners[3] - at.corners[0]).norm();
  const double cell_px = perimeter / (4.0 * cells.at_border);
  const LightGrid grid(cells.across, cells.across * cell_px);
  constexpr int kLeastShare = 2;  // of samples over unknowns
  const std::vector<GreySample> samples = SamplesOf(image, cells, grid, *H, plane, cell_px);
  if (samples.size() < static_cast<std::size_t>(kLeastShare * (kTagShared + grid.nodes())))
    return std::nullopt;
  SetLevels(cells, grid, samples, H->inverse(), cell_px, &at);
  constexpr double kLeastContrast = 8.0;  // grey levels; assumed, 5-15
  if (at.Step() < kLeastContrast) return std::nullopt;
  TagProblem problem(cells, grid, samples);
  const TagCorners first = at.corners;
  if (!Fit(grid, &problem, &at)) return std::nullopt;
  // A fit that went elsewhere, or one that leaves much of the contrast unexplained.
  const std::vector<double> errors = problem.Errors(at);
  double moved = 0.0;
  for (std::size_t k = 0; k < 4; ++k) moved = std::max(moved, (at.corners[k] - first[k]).norm());
  if (moved > std::max(2.0, 0.5 * cell_px) || NoiseOf(errors) > kMostNoise * at.Step())
    return std::nullopt;
  problem.SetNoise(SpreadOf(errors));
  TagEquations equations;
  problem.Cost(at, &equations);
  // What the model leaves out, such as the shape of the blur. Assumed, 0.005-0.03.
  constexpr double kModel_px = 0.01;
  TagFit fit{.corners = {}, .sigma_px = std::hypot(SigmaOf(equations, at, plane), kModel_px)};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto pixel = plane.ToPixel(at.corners[k]);
    if (!pixel || !pixel->allFinite()) return std::nullopt;
    fit.corners[k] = *pixel;
  }
  return fit;
}

CellReading ReadCells(const GrayImage& image, const TagCells& cells, const TagCorners& corners) {
  const std::optional<Eigen::Matrix3d> H = FromCells(corners, cells.at_border);
  if (!H) return {};
  std::vector<std::pair<double, bool>> read;
  double white = 0.0, black = 0.0;
  int whites = 0, blacks = 0;
  const double half = 0.5 * cells.across;
  for (int row = cells.margin; row < cells.across - cells.margin; ++row) {
    for (int column = cells.margin; column < cells.across - cells.margin; ++column) {
      const Eigen::Vector2d pixel =
          (*H * Eigen::Vector3d(column + 0.5 - half, row + 0.5 - half, 1.0)).hnormalized();
      const int x = static_cast<int>(std::lround(pixel.x()));
      const int y = static_cast<int>(std::lround(pixel.y()));
      if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
      const bool ink = cells.IsBlack(column, row);
      read.emplace_back(image.at(x, y), ink);
      (ink ? black : white) += image.at(x, y);
      (ink ? blacks : whites) += 1;
    }
  }
  if (whites == 0 || blacks == 0) return {};
  const double threshold = 0.5 * (white / whites + black / blacks);
  CellReading reading;
  for (const auto& [grey, ink] : read) {
    reading.wrong += (grey < threshold) != ink;
    reading.margin += std::abs(grey - threshold) / static_cast<double>(read.size());
  }
  return reading;
}

}  // namespace dockyard
