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

}  // namespace

TagEstimate Moved(const TagEstimate& at, const TagStep& step) {
  TagEstimate moved = at;
  for (int k = 0; k < 4; ++k) moved.corners[static_cast<std::size_t>(k)] += step.segment<2>(2 * k);
  moved.blur_px += step[8];
  moved.white += step.segment<3>(9);
  moved.dark += step.segment<3>(12);
  return moved;
}

TagProblem::TagProblem(const TagCells& cells, const std::vector<GreySample>& samples)
    : cells_(cells), samples_(samples) {}

double TagProblem::Cost(const TagEstimate& at, TagEquations* equations) const {
  constexpr double kImpossible = std::numeric_limits<double>::infinity();
  constexpr double kLeastBlur_px = 0.15, kMostBlur_px = 10.0;
  if (!(at.blur_px > kLeastBlur_px && at.blur_px < kMostBlur_px)) return kImpossible;
  const std::optional<CellMap> map = CellMapOf(at.corners, cells_.at_border, equations != nullptr);
  if (!map) return kImpossible;
  if (equations != nullptr) {
    equations->A.setZero();
    equations->b.setZero();
  }
  double cost = 0.0;
  for (const GreySample& sample : samples_) {
    const Eigen::Vector2d cell = (map->H * sample.point.homogeneous()).hnormalized();
    const Eigen::Vector2d per_px = CellsPerPixel(map->H, sample.point, cell);
    const Blackness black = BlacknessAt(cells_, cell, at.blur_px * per_px);
    const Eigen::Vector2d half = cell / (0.5 * cells_.at_border);
    const Eigen::Vector3d light(1.0, half.x(), half.y());
    const double dark = light.dot(at.dark);
    const double grey = light.dot(at.white) + black.share * dark;
    const bool clipped = grey > kFull;
    const double error = (clipped ? kFull : grey) - sample.grey;
    const double sigmas = std::abs(error) / noise_;
    const bool near = sigmas <= kHuber;
    cost += near ? sigmas * sigmas : kHuber * (2.0 * sigmas - kHuber);
    if (equations == nullptr || clipped) continue;
    TagStep row;
    for (int k = 0; k < 8; ++k) {
      const Eigen::Vector2d moved =
          (map->by_corner[static_cast<std::size_t>(k)] * sample.point.homogeneous()).hnormalized();
      row[k] = dark * black.slope.dot(moved - cell) / kStep_px;
    }
    row[8] = dark * black.by_sigma.dot(per_px);
    row.segment<3>(9) = light;
    row.segment<3>(12) = black.share * light;
    const double weight = (near ? 1.0 : kHuber / sigmas) / (noise_ * noise_);
    equations->A.noalias() += weight * row * row.transpose();
    equations->b += weight * error * row;
  }
  return cost;
}

std::vector<double> TagProblem::Errors(const TagEstimate& at) const {
  std::vector<double> errors;
  const std::optional<CellMap> map = CellMapOf(at.corners, cells_.at_border, false);
  if (!map) return errors;
  for (const GreySample& sample : samples_) {
    const Eigen::Vector2d cell = (map->H * sample.point.homogeneous()).hnormalized();
    const Eigen::Vector2d per_px = CellsPerPixel(map->H, sample.point, cell);
    const Blackness black = BlacknessAt(cells_, cell, at.blur_px * per_px);
    const Eigen::Vector2d half = cell / (0.5 * cells_.at_border);
    const Eigen::Vector3d light(1.0, half.x(), half.y());
    const double grey = light.dot(at.white) + black.share * light.dot(at.dark);
    errors.push_back(std::min(grey, kFull) - sample.grey);
  }
  return errors;
}

}  // namespace dockyard
