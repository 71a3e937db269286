#include "controller/raposa/layers.h"

#include <Eigen/Cholesky>
#include <algorithm>

namespace dockyard::raposa {
namespace {

// Of a paint's colour: its shading over the guide and the faces. Assumed, 0.05-0.2.
constexpr float kShading = 0.10f;
// Of a paint's colour, at an edge that halves a cell: the camera averages coded colours, not light.
// Assumed, 0.05-0.2.
constexpr float kAtEdge = 0.10f;
// Of grey parts' colour, where it is not the ground's: they are lit from full sun to shade.
// Assumed, 0.3-0.7.
constexpr float kGreyShading = 0.5f;
// Of grey parts against the ground, in its green. Assumed, 0.5-3.
constexpr double kGreyColour = 1.5;
// Of other paints: no prior. Numerical.
constexpr double kAnyColour = 100.0;
// Of paint's colour from the middle of a mark to its border: lit from above, or aside. Assumed,
// 0.3-0.6. As a share of the colour, and of any colour.
constexpr double kSlopeShare = 0.4, kAnySlope = 0.4;

struct Extent {
  Eigen::Vector2d middle_px{0.0, 0.0}, half_px{1.0, 1.0};
};
Extent ExtentOf(const std::vector<ConvexPolygon>& polygons) {
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const ConvexPolygon& polygon : polygons) {
    for (int i = 0; i < polygon.count; ++i) {
      low = low.cwiseMin(polygon.corners[static_cast<std::size_t>(i)]);
      high = high.cwiseMax(polygon.corners[static_cast<std::size_t>(i)]);
    }
  }
  if (low.x() > high.x()) return {};
  return {0.5 * (low + high), (0.5 * (high - low)).cwiseMax(0.5)};
}

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

/// The layer times how far, in halves of its mark, a cell lies below or right of the mark's middle.
void LayerImage::Slope(Layer of, Layer slope, bool down, const Eigen::Vector2d& middle_px,
                       double half_px) {
  const int across = window_->across_px(), unit = window_->unit_px;
  std::size_t k = 0;
  for (int j = 0; j < window_->rows; ++j) {
    const double v = window_->y0_px + (j + 0.5) * unit - 0.5 - middle_px.y();
    for (int i = 0; i < window_->columns; ++i, ++k) {
      const double u = window_->x0_px + (i + 0.5) * across - 0.5 - middle_px.x();
      const double far = std::clamp((down ? v : u) / half_px, -1.5, 1.5);
      shares_[slope][k] = shares_[of][k] * static_cast<float>(far);
    }
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
  const Extent guide = ExtentOf({marks.guide});
  Slope(kOrangeLayer, kOrangeDown, true, guide.middle_px, guide.half_px.y());
  Slope(kOrangeLayer, kOrangeAcross, false, guide.middle_px, guide.half_px.x());
  if (!whole) return;
  const Extent blue = ExtentOf(marks.strips);
  Slope(kBlueLayer, kBlueDown, true, blue.middle_px, blue.half_px.y());
}

SlopePriors AnySlopes(const FitWindow& window) {
  const double sigma = kAnySlope * window.whiten.cast<double>().norm();
  return {sigma, sigma};
}

SlopePriors SlopesFor(const FitWindow& window, const LayerColours& colours) {
  const double least = 0.1 * AnySlopes(window).orange;
  return {std::max(least, kSlopeShare * colours.row(kOrangeLayer).norm()),
          std::max(least, kSlopeShare * colours.row(kBlueLayer).norm())};
}

ColourFit FitColours(const FitWindow& window, const LayerImage& layers,
                     const std::vector<float>& weights, const SlopePriors& slopes) {
  using Cells = Eigen::Map<const Eigen::VectorXf>;
  const auto cells = static_cast<Eigen::Index>(window.size());
  Eigen::Matrix<float, Eigen::Dynamic, kLayers> weighted(cells, kLayers);
  const Cells weight(weights.data(), cells);
  const Eigen::Map<const Eigen::Matrix<float, 2, Eigen::Dynamic>> seen(window.seen.data()->data(),
                                                                       2, cells);
  const auto shares = [&](Eigen::Index l) {
    return Cells(layers.Shares(static_cast<std::size_t>(l)).data(), cells);
  };
  LayerNormal normal;
  Eigen::Matrix<double, kLayers, 2> right;
  constexpr auto n = static_cast<Eigen::Index>(kLayers);
  for (Eigen::Index l = 0; l < n; ++l) {
    weighted.col(l) = weight.cwiseProduct(shares(l));
    for (Eigen::Index m = 0; m <= l; ++m) {
      normal(l, m) = normal(m, l) = static_cast<double>(weighted.col(l).dot(shares(m)));
    }
    right.row(l) = (seen * weighted.col(l)).transpose().cast<double>();
  }
  // A colour's prior, in whitened values, about as wide as in plain ones times the whitening.
  const double scale = window.whiten.cast<double>().norm();
  for (Eigen::Index l = 0; l < n; ++l) {
    const auto layer = static_cast<std::size_t>(l);
    const bool grey = layer == kBoxes || layer == kFaces;
    const double sigma = layer == kBlueDown     ? slopes.blue
                         : layer >= kOrangeDown ? slopes.orange
                                                : scale * (grey ? kGreyColour : kAnyColour);
    normal(l, l) += 1.0 / (sigma * sigma);
  }
  const Eigen::LLT<LayerNormal> root(normal);
  const Eigen::Matrix<double, kLayers, 2> colours = root.solve(right);
  ColourFit fit;
  fit.colours = colours.cast<float>();
  fit.inverse = root.solve(LayerNormal::Identity());
  double data = 0.0;
  for (std::size_t k = 0; k < window.size(); ++k) {
    data += static_cast<double>(weights[k] * window.seen[k].squaredNorm());
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
  const float boxes2 = colours.row(kBoxes).squaredNorm();
  const float faces2 = colours.row(kFaces).squaredNorm();
  const auto edge = [](float share) { return 4.0f * share * (1.0f - share); };
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const float o = layers.Shares(kOrangeLayer)[k], b = layers.Shares(kBlueLayer)[k];
    const float grey = layers.Shares(kBoxes)[k], face = layers.Shares(kFaces)[k];
    const float shading =
        kShading * kShading * (o * o * orange2 + b * b * blue2) +
        kGreyShading * kGreyShading * (grey * grey * boxes2 + face * face * faces2);
    const float at_edge =
        kAtEdge * kAtEdge * (edge(o) * edge(o) * orange2 + edge(b) * edge(b) * blue2);
    // Two values share it.
    weights[k] = window.open[k] / (1.0f + 0.5f * (shading + at_edge));
  }
  return weights;
}

}  // namespace dockyard::raposa
