#include "controller/vision/tags/tag_problem.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "controller/vision/tags/tag_pattern.h"

namespace dockyard {
namespace {

constexpr double kHuber = 2.0;   // standard deviations
constexpr double kFull = 255.0;  // the brightest grey level: all above is shown as it
// How bright a veil over black is, 1 sigma. Assumed, 5-20 grey levels.
constexpr double kVeil = 10.0;

/// From the plane to the tag's cells, with the derivative by each corner's coordinates.
struct CellMap {
  Eigen::Matrix3d H;
  std::array<Eigen::Matrix3d, 8> by_corner;  // small differences
};

constexpr double kStep_px = 1e-4;

std::optional<CellMap> CellMapOf(const TagCorners& corners, int at_border, bool with_derivatives) {
  const auto inverse = [&](const TagCorners& c) -> std::optional<Eigen::Matrix3d> {
    const std::optional<Eigen::Matrix3d> H = FromCells(c, at_border);
    if (!H) return std::nullopt;
    const Eigen::Matrix3d cells = H->inverse();
    if (!cells.allFinite()) return std::nullopt;
    return cells;
  };
  const std::optional<Eigen::Matrix3d> H = inverse(corners);
  if (!H) return std::nullopt;
  CellMap map{.H = *H, .by_corner = {}};
  if (!with_derivatives) return map;
  for (std::size_t k = 0; k < 8; ++k) {
    TagCorners moved = corners;
    moved[k / 2][static_cast<int>(k % 2)] += kStep_px;
    const std::optional<Eigen::Matrix3d> H_moved = inverse(moved);
    if (!H_moved) return std::nullopt;
    map.by_corner[k] = *H_moved;
  }
  return map;
}

/// Cells a step of one pixel along x and along y takes: the lengths of the rows of its Jacobian.
Eigen::Vector2d CellsPerPixel(const Eigen::Matrix3d& H, const Eigen::Vector2d& point,
                              const Eigen::Vector2d& cell) {
  const double w = H(2, 0) * point.x() + H(2, 1) * point.y() + H(2, 2);
  const Eigen::Matrix2d J = (H.topLeftCorner<2, 2>() - cell * H.block<1, 2>(2, 0)) / w;
  return J.rowwise().norm();
}

/// The model of a pixel.
struct Modelled {
  double grey = 0.0, light = 0.0, step = 0.0;  // step: white over black there
  Blackness black;
  Eigen::Vector2d cell, per_px;
  Eigen::Vector3d slope;  // 1, x, y of the veil
};

Modelled ModelOf(const TagCells& cells, const TagEstimate& at, const Eigen::Matrix3d& H,
                 const GreySample& sample) {
  Modelled model;
  model.cell = (H * sample.point.homogeneous()).hnormalized();
  model.per_px = CellsPerPixel(H, sample.point, model.cell);
  model.black = BlacknessAt(cells, model.cell, at.blur_px * model.per_px);
  model.slope << 1.0, model.cell / (0.5 * cells.at_border);
  model.light = sample.light.Of(at.light);
  model.step = at.contrast * model.light - model.slope.dot(at.veil);
  model.grey = model.light - model.black.share * model.step;
  return model;
}

/// Adds one error to the lower triangle: its derivatives by the shared unknowns, and by the nodes
/// of its light.
void AddRow(const Eigen::Matrix<double, kTagShared, 1>& shared, const LightGrid::Place& light,
            double by_light, double weight, double error, TagEquations* equations) {
  equations->A.topLeftCorner<kTagShared, kTagShared>().selfadjointView<Eigen::Lower>().rankUpdate(
      shared, weight);
  equations->b.head<kTagShared>() += weight * error * shared;
  for (std::size_t i = 0; i < 4; ++i) {
    const int row = kTagShared + light.nodes[i];
    const double slope = light.weights[static_cast<Eigen::Index>(i)] * by_light;
    equations->A.row(row).head<kTagShared>() += weight * slope * shared.transpose();
    for (std::size_t j = 0; j <= i; ++j) {  // nodes rise
      equations->A(row, kTagShared + light.nodes[j]) +=
          weight * slope * light.weights[static_cast<Eigen::Index>(j)] * by_light;
    }
    equations->b[row] += weight * error * slope;
  }
}

/// f(a, b) for all pairs of adjacent nodes, a < b.
template <class F>
void ForNeighbours(const LightGrid& grid, const F& f) {
  const int n = grid.a_side();
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      if (x + 1 < n) f(y * n + x, y * n + x + 1);
      if (y + 1 < n) f(y * n + x, y * n + x + n);
    }
  }
}

double Mean(const LightGrid::Levels& light, int a, int b) { return 0.5 * (light[a] + light[b]); }

}  // namespace

double Unevenness(const LightGrid& grid, const LightGrid::Levels& light) {
  double sum = 0.0;
  int pairs = 0;
  ForNeighbours(grid, [&](int a, int b) {
    sum += std::pow((light[b] - light[a]) / Mean(light, a, b), 2);
    ++pairs;
  });
  return std::sqrt(sum / pairs);
}

TagEstimate Moved(const TagEstimate& at, const TagStep& step) {
  TagEstimate moved = at;
  for (int k = 0; k < 4; ++k) moved.corners[static_cast<std::size_t>(k)] += step.segment<2>(2 * k);
  moved.blur_px += step[8];
  moved.contrast += step[9];
  moved.veil += step.segment<3>(10);
  moved.light += step.tail(at.light.size());
  return moved;
}

TagProblem::TagProblem(const TagCells& cells, const LightGrid& grid,
                       const std::vector<GreySample>& samples)
    : cells_(cells), grid_(grid), samples_(samples) {}

/// The cost of the light's changes from node to node, and of the veil.
double TagProblem::Expected(const TagEstimate& at, TagEquations* equations) const {
  double cost = 0.0;
  ForNeighbours(grid_, [&](int a, int b) {
    const double weight = 1.0 / std::pow(uneven_ * Mean(at.light, a, b), 2);
    const double difference = at.light[b] - at.light[a];
    cost += weight * difference * difference;
    if (equations == nullptr) return;
    const int i = kTagShared + a, j = kTagShared + b;  // a < b
    equations->A(i, i) += weight;
    equations->A(j, j) += weight;
    equations->A(j, i) -= weight;
    equations->b[i] -= weight * difference;
    equations->b[j] += weight * difference;
  });
  constexpr double kWeight = 1.0 / (kVeil * kVeil);
  cost += kWeight * at.veil.squaredNorm();
  if (equations == nullptr) return cost;
  equations->A.diagonal().segment<3>(10).array() += kWeight;
  equations->b.segment<3>(10) += kWeight * at.veil;
  return cost;
}

double TagProblem::Cost(const TagEstimate& at, TagEquations* equations) const {
  constexpr double kImpossible = std::numeric_limits<double>::infinity();
  constexpr double kLeastBlur_px = 0.15, kMostBlur_px = 10.0;
  if (!(at.blur_px > kLeastBlur_px && at.blur_px < kMostBlur_px)) return kImpossible;
  if (!(at.light.minCoeff() > 0.0)) return kImpossible;
  const std::optional<CellMap> map = CellMapOf(at.corners, cells_.at_border, equations != nullptr);
  if (!map) return kImpossible;
  if (equations != nullptr) {
    const int unknowns = kTagShared + grid_.nodes();
    equations->A.setZero(unknowns, unknowns);
    equations->b.setZero(unknowns);
  }
  double cost = Expected(at, equations);
  for (const GreySample& sample : samples_) {
    const Modelled model = ModelOf(cells_, at, map->H, sample);
    const bool clipped = model.grey > kFull;
    const double error = (clipped ? kFull : model.grey) - sample.grey;
    const double sigmas = std::abs(error) / noise_;
    const bool near = sigmas <= kHuber;
    cost += near ? sigmas * sigmas : kHuber * (2.0 * sigmas - kHuber);
    if (equations == nullptr || clipped) continue;
    Eigen::Matrix<double, kTagShared, 1> row;
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector2d moved =
          (map->by_corner[static_cast<std::size_t>(k)] * sample.point.homogeneous()).hnormalized();
      row[k] = -model.step * model.black.slope.dot(moved - model.cell) / kStep_px;
    }
    row[8] = -model.step * model.black.by_sigma.dot(model.per_px);
    row[9] = -model.black.share * model.light;
    row.segment<3>(10) = model.black.share * model.slope;
    const double weight = (near ? 1.0 : kHuber / sigmas) / (noise_ * noise_);
    AddRow(row, sample.light, 1.0 - model.black.share * at.contrast, weight, error, equations);
  }
  return cost;
}

std::vector<double> TagProblem::Errors(const TagEstimate& at) const {
  std::vector<double> errors;
  const std::optional<CellMap> map = CellMapOf(at.corners, cells_.at_border, false);
  if (!map) return errors;
  for (const GreySample& sample : samples_) {
    errors.push_back(std::min(ModelOf(cells_, at, map->H, sample).grey, kFull) - sample.grey);
  }
  return errors;
}

}  // namespace dockyard
