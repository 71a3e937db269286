#include "controller/raposa/layers.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace dockyard::raposa {
namespace {

// Of a paint's colour: its shading over the guide and the faces. Assumed, 0.05-0.2.
constexpr float kShading = 0.10f;
// Of a paint's colour, at an edge that halves a cell: the camera averages coded colours, not light.
// Assumed, 0.05-0.2.
constexpr float kAtEdge = 0.10f;
// Of grey parts against the ground, in its green. Assumed, 0.5-3.
constexpr double kGreyColour = 1.5;
constexpr double kAnyColour = 100.0;

}  // namespace

LayerImage::LayerImage(const FitWindow& window) : window_(&window) {
  for (std::vector<float>& layer : shares_) layer.assign(window.size(), 0.0f);
  std::fill(shares_[kEven].begin(), shares_[kEven].end(), 1.0f);
  shares_[kSky] = window.sky;
  for (int j = 0; j < window.rows; ++j) {
    const float ramp = (static_cast<float>(j) + 0.5f) / static_cast<float>(window.rows) - 0.5f;
    std::fill_n(shares_[kRamp].begin() + static_cast<std::ptrdiff_t>(j) * window.columns,
                window.columns, ramp);
  }
}

void LayerImage::Raster(const std::vector<ConvexPolygon>& polygons, std::vector<float>* fine) {
  const double unit = window_->unit_px;
  const int columns = window_->columns * window_->across_px() / window_->unit_px;
  coverage_.Reset(columns, window_->rows);
  for (ConvexPolygon polygon : polygons) {
    if (polygon.count < 3) continue;
    for (int i = 0; i < polygon.count; ++i) {
      Eigen::Vector2d& p = polygon.corners[static_cast<std::size_t>(i)];
      p = (p + Eigen::Vector2d(0.5 - window_->x0_px, 0.5 - window_->y0_px)) / unit;
    }
    coverage_.Add(polygon);
  }
  coverage_.Finish();
  *fine = coverage_.values();
}

void LayerImage::ToCells(std::vector<float>* fine, std::vector<float>* cells) {
  const int per_cell = window_->across_px() / window_->unit_px;
  BlurShares(window_->columns * per_cell, window_->rows, kImageBlur_px / window_->unit_px, fine);
  if (per_cell == 1) {
    cells->swap(*fine);
    return;
  }
  for (std::size_t k = 0; k < cells->size(); ++k) {
    (*cells)[k] = 0.5f * ((*fine)[2 * k] + (*fine)[2 * k + 1]);
  }
}

void LayerImage::Draw(const MarksInImage& marks) {
  Raster({marks.guide}, &guide_);
  const bool whole = !marks.strips.empty() || marks.rod.count > 0;
  if (whole) {
    Raster({marks.rod}, &rod_);
    Raster(marks.strips, &strips_);
    Raster(marks.faces, &faces_);
    Raster(marks.boxes, &boxes_);
    for (std::size_t k = 0; k < guide_.size(); ++k) {
      const float before = (1.0f - guide_[k]) * (1.0f - rod_[k]);
      const float plain = std::max(0.0f, 1.0f - strips_[k] - faces_[k]);
      boxes_[k] *= before * plain;
      strips_[k] *= before;
      faces_[k] *= before;
    }
    ToCells(&strips_, &shares_[kBlueLayer]);
    ToCells(&faces_, &shares_[kFaces]);
    ToCells(&boxes_, &shares_[kBoxes]);
  }
  ToCells(&guide_, &shares_[kOrangeLayer]);
}

ColourFit FitColours(const FitWindow& window, const LayerImage& layers,
                     const std::vector<float>& weights) {
  constexpr auto n = static_cast<Eigen::Index>(kLayers);
  LayerNormal normal = LayerNormal::Zero();
  Eigen::Matrix<double, kLayers, 2> right = Eigen::Matrix<double, kLayers, 2>::Zero();
  std::array<const float*, kLayers> shares{};
  for (std::size_t l = 0; l < kLayers; ++l) shares[l] = layers.Shares(l).data();
  const std::size_t columns = static_cast<std::size_t>(window.columns);
  for (int j = 0; j < window.rows; ++j) {
    const std::size_t first = static_cast<std::size_t>(j) * columns;
    Eigen::Matrix<float, kLayers, kLayers> of_row = Eigen::Matrix<float, kLayers, kLayers>::Zero();
    Eigen::Matrix<float, kLayers, 2> right_row = Eigen::Matrix<float, kLayers, 2>::Zero();
    for (std::size_t k = first; k < first + columns; ++k) {
      if (weights[k] == 0.0f) continue;
      Eigen::Matrix<float, kLayers, 1> a;
      for (std::size_t l = 0; l < kLayers; ++l) a[static_cast<Eigen::Index>(l)] = shares[l][k];
      const Eigen::Matrix<float, kLayers, 1> wa = weights[k] * a;
      of_row.noalias() += wa * a.transpose();
      right_row.noalias() += wa * window.seen[k].transpose();
    }
    normal += of_row.cast<double>();
    right += right_row.cast<double>();
  }
  // A colour's prior, in whitened values, about as wide as in plain ones times the whitening.
  const double scale = window.whiten.cast<double>().norm();
  for (Eigen::Index l = 0; l < n; ++l) {
    const bool grey = l == kBoxes || l == kFaces;
    const double sigma = scale * (grey ? kGreyColour : kAnyColour);
    normal(l, l) += 1.0 / (sigma * sigma);
  }
  const Eigen::LLT<LayerNormal> root(normal);
  const Eigen::Matrix<double, kLayers, 2> colours = root.solve(right);
  ColourFit fit;
  fit.colours = colours.cast<float>();
  fit.inverse = root.solve(LayerNormal::Identity());
  double data = 0.0;
  for (std::size_t k = 0; k < window.size(); ++k) {
    if (weights[k] > 0.0f) data += weights[k] * window.seen[k].squaredNorm();
  }
  // With linear unknowns at their best: d'Wd - right' colours.
  fit.chi2 = data - right.cwiseProduct(colours).sum();
  return fit;
}

std::vector<float> WeightsFor(const FitWindow& window, const LayerImage& layers,
                              const LayerColours& colours) {
  std::vector<float> weights(window.size());
  const float orange2 = colours.row(kOrangeLayer).squaredNorm();
  const float blue2 = colours.row(kBlueLayer).squaredNorm();
  const auto edge = [](float share) { return 4.0f * share * (1.0f - share); };
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const float o = layers.Shares(kOrangeLayer)[k], b = layers.Shares(kBlueLayer)[k];
    const float shading = kShading * kShading * (o * o * orange2 + b * b * blue2);
    const float at_edge =
        kAtEdge * kAtEdge * (edge(o) * edge(o) * orange2 + edge(b) * edge(b) * blue2);
    // Two values share it.
    weights[k] = window.open[k] / (1.0f + 0.5f * (shading + at_edge));
  }
  return weights;
}

}  // namespace dockyard::raposa
