#include "controller/raposa/pyramid_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "controller/raposa/mark_borders.h"

namespace dockyard::raposa {
namespace {

using Matrix6 = Eigen::Matrix<double, kPlaceUnknowns, kPlaceUnknowns>;

// Of the covariance, above that of independent cells: shading and the coding of colours err alike
// in neighbours. From raposa_eye_survey, where chi2 of the poses was 2.5 to 6 a value; 3-6.
constexpr double kCorrelated = 6.0;
// Of CostOf: far from the place more cells are off, by less. Assumed, 6-15.
constexpr float kGridOtherThing = 10.0f;
// Steps in which cells of other things still draw the marks, by their distance and not by its
// square; then those outside of the marks no more. Assumed, 2-6.
constexpr int kDrawingSteps = 4;

/// Steps for the derivatives: some 0.05 px each.
PlaceVector Steps(const PyramidPlace& place) {
  const double r_m = std::hypot(place.X_VD.x, place.X_VD.y);
  PlaceVector steps;
  steps << 2e-3 * r_m, 5e-4 * r_m, 5e-3, 5e-4 * r_m, 3e-4, 3e-3;
  return steps;
}

double PriorCost(const PlaceVector& at, const PlacePrior& prior) {
  double cost = 0.0;
  for (int i = 0; i < kPlaceUnknowns; ++i) {
    if (prior.sigma[i] > 0.0) cost += std::pow((at[i] - prior.mean[i]) / prior.sigma[i], 2);
  }
  return cost;
}

std::optional<MarksInImage> Project(const Nominal& nominal, const PyramidPlace& place,
                                    MarksDrawn drawn) {
  return drawn == MarksDrawn::kAll ? ProjectMarks(nominal, place) : ProjectGuide(nominal, place);
}

/// Weights before any colour is known: cells that differ from the ground, where no mark lies, are
/// of other things.
std::vector<float> FirstWeights(const FitWindow& window, const LayerImage& layers) {
  std::vector<float> weights = window.open;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const float off2 = window.seen[k].squaredNorm();
    if (off2 > kOtherThing * kOtherThing && MarksIn(layers, k) < kOfMarks)
      weights[k] *= kOtherThing * kOtherThing / off2;
  }
  return weights;
}

/// The colours at a place, weighted by themselves.
struct Point {
  ColourFit colours;
  std::vector<float> weights;
  SlopePriors slopes;
  double cost = 0.0;  // of cells that count no more than as another thing
};
Point PointAt(const FitWindow& window, const LayerImage& layers, bool drawing) {
  Point point;
  point.colours = FitColours(window, layers, FirstWeights(window, layers), AnySlopes(window));
  point.slopes = SlopesFor(window, point.colours.colours);
  for (int round = 0; round < 2; ++round) {
    point.weights = WeightsFor(window, layers, point.colours.colours);
    point.cost = 0.0;
    for (std::size_t k = 0; k < window.size(); ++k) {
      const float off2 =
          point.weights[k] * Residual(window, layers, point.colours.colours, k).squaredNorm();
      point.cost += std::min(off2, kOtherThing * kOtherThing);
      if (off2 <= kOtherThing * kOtherThing) continue;
      const bool thing = !drawing && MarksIn(layers, k) < kOfMarks;
      point.weights[k] *= thing ? 0.0f : kOtherThing / std::sqrt(off2);
    }
    point.colours = FitColours(window, layers, point.weights, point.slopes);
  }
  return point;
}

struct Linear {
  Matrix6 normal = Matrix6::Zero();
  PlaceVector gradient = PlaceVector::Zero();
};

/// Of the residuals by the unknowns, with the colours following (Kaufman's short form of variable
/// projection, BIT 15, 1975).
std::optional<Linear> Linearise(const Nominal& nominal, const FitWindow& window,
                                const LayerImage& layers, const Point& point, const PlaceVector& at,
                                const PlacePrior& prior, MarksDrawn drawn) {
  const std::size_t cells = window.size();
  std::array<std::vector<Eigen::Vector2f>, kPlaceUnknowns> columns;
  LayerImage moved(window);
  const PlaceVector steps = Steps(ToPlace(at));
  const LayerColours& c = point.colours.colours;
  for (int i = 0; i < kPlaceUnknowns; ++i) {
    if (prior.sigma[i] <= 0.0) continue;
    PlaceVector there = at;
    there[i] += steps[i];
    const auto marks = Project(nominal, ToPlace(there), drawn);
    if (!marks) return std::nullopt;
    moved.Draw(*marks);
    std::vector<Eigen::Vector2f>& column = columns[static_cast<std::size_t>(i)];
    column.assign(cells, Eigen::Vector2f::Zero());
    const auto per_step = static_cast<float>(1.0 / steps[i]);
    for (std::size_t l = kBoxes; l < kLayers; ++l) {
      const Eigen::Vector2f colour = per_step * c.row(static_cast<Eigen::Index>(l)).transpose();
      const float* now = layers.Shares(l).data();
      const float* then = moved.Shares(l).data();
      for (std::size_t k = 0; k < cells; ++k) column[k] += (then[k] - now[k]) * colour;
    }
    // What other colours would explain is no news of the place.
    Eigen::Matrix<double, kLayers, 2> right = Eigen::Matrix<double, kLayers, 2>::Zero();
    for (std::size_t l = 0; l < kLayers; ++l) {
      Eigen::Vector2f sum = Eigen::Vector2f::Zero();
      const float* share = layers.Shares(l).data();
      for (std::size_t k = 0; k < cells; ++k) sum += point.weights[k] * share[k] * column[k];
      right.row(static_cast<Eigen::Index>(l)) = sum.transpose().cast<double>();
    }
    const LayerColours follow = (point.colours.inverse * right).cast<float>();
    for (std::size_t l = 0; l < kLayers; ++l) {
      const Eigen::Vector2f colour = follow.row(static_cast<Eigen::Index>(l)).transpose();
      const float* share = layers.Shares(l).data();
      for (std::size_t k = 0; k < cells; ++k) column[k] -= share[k] * colour;
    }
  }
  Linear linear;
  for (std::size_t k = 0; k < cells; ++k) {
    if (point.weights[k] == 0.0f) continue;
    Eigen::Matrix<float, kPlaceUnknowns, 2> J = Eigen::Matrix<float, kPlaceUnknowns, 2>::Zero();
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (!columns[i].empty()) J.row(static_cast<Eigen::Index>(i)) = columns[i][k].transpose();
    }
    const Eigen::Matrix<float, kPlaceUnknowns, 2> wJ = point.weights[k] * J;
    linear.normal += (wJ * J.transpose()).cast<double>();
    linear.gradient += (wJ * Residual(window, layers, c, k)).cast<double>();
  }
  for (int i = 0; i < kPlaceUnknowns; ++i) {
    const double weight = prior.sigma[i] > 0.0 ? 1.0 / (prior.sigma[i] * prior.sigma[i]) : 1.0;
    linear.normal(i, i) += weight;
    if (prior.sigma[i] > 0.0) linear.gradient[i] -= weight * (at[i] - prior.mean[i]);
  }
  return linear;
}

void Describe(const FitWindow& window, const LayerImage& layers, const Point& point,
              PlaceFit* fit) {
  const std::vector<float> weights = WeightsFor(window, layers, point.colours.colours);
  double sum = 0.0, blue = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < window.size(); ++k) {
    if (window.open[k] == 0.0f) continue;
    blue += layers.Shares(kBlueLayer)[k];
    if (MarksIn(layers, k) < kOfMarks) continue;
    sum += std::min(weights[k] * Residual(window, layers, point.colours.colours, k).squaredNorm(),
                    kOtherThing * kOtherThing);
    ++count;
  }
  const auto border = [&](Layer mark) {
    return MarkBorder{ShareBeyond(window, layers, point.colours.colours, mark),
                      ShareOfOthers(window, layers, point.colours.colours, weights, mark)};
  };
  fit->orange_border = border(kOrangeLayer);
  fit->blue_border = border(kBlueLayer);
  fit->misfit = count > 0 ? sum / (2.0 * count) : 0.0;
  fit->blue_px2 = window.unit_px * window.across_px() * blue;
  const Eigen::Matrix2d plain = window.whiten.cast<double>().inverse();
  const auto colour = [&](Eigen::Index l) {
    return Eigen::Vector2d(point.colours.colours.row(l).transpose().cast<double>());
  };
  fit->orange = plain * colour(kOrangeLayer);
  fit->blue = plain * colour(kBlueLayer);
  const auto sigmas = [&](Eigen::Index l) {
    return colour(l).norm() / std::sqrt(point.colours.inverse(l, l));
  };
  fit->orange_sigmas = sigmas(kOrangeLayer);
  fit->blue_sigmas = sigmas(kBlueLayer);
}

}  // namespace

PlaceVector ToVector(const PyramidPlace& place) {
  PlaceVector v;
  v << place.X_VD.x, place.X_VD.y, place.X_VD.heading, place.down_m, place.pitch_rad,
      place.roll_rad;
  return v;
}

PyramidPlace ToPlace(const PlaceVector& v) { return {{v[0], v[1], v[2]}, v[3], v[4], v[5]}; }

std::optional<double> CostOf(const Nominal& nominal, const FitWindow& window,
                             const PyramidPlace& place, const PlacePrior& prior, MarksDrawn drawn) {
  const auto marks = Project(nominal, place, drawn);
  if (!marks) return std::nullopt;
  LayerImage layers(window);
  layers.Draw(*marks);
  const std::vector<float> weights = FirstWeights(window, layers);
  const ColourFit fit = FitColours(window, layers, weights, AnySlopes(window));
  double cost = 0.0;
  for (std::size_t k = 0; k < window.size(); ++k) {
    cost += std::min(window.open[k] * Residual(window, layers, fit.colours, k).squaredNorm(),
                     kGridOtherThing * kGridOtherThing);
  }
  return cost + PriorCost(ToVector(place), prior);
}

std::optional<PlaceFit> FitPlace(const Nominal& nominal, const FitWindow& window,
                                 const PyramidPlace& start, const PlacePrior& prior,
                                 MarksDrawn drawn, int most_steps) {
  const auto first = Project(nominal, start, drawn);
  if (!first) return std::nullopt;
  PlaceVector at = ToVector(start);
  LayerImage layers(window), tried(window);
  layers.Draw(*first);
  Point point = PointAt(window, layers, true);
  double damping = 1e-3;
  std::optional<Linear> linear;
  for (int step = 0; step < most_steps; ++step) {
    linear = Linearise(nominal, window, layers, point, at, prior, drawn);
    if (!linear) return std::nullopt;
    const double now = point.colours.chi2 + PriorCost(at, prior);
    bool better = false;
    double gain = 0.0;
    for (int tries = 0; tries < 5 && !better; ++tries) {
      Matrix6 damped = linear->normal;
      damped.diagonal() *= 1.0 + damping;
      const PlaceVector change = damped.llt().solve(linear->gradient);
      const PlaceVector there = at + change;
      const auto marks = Project(nominal, ToPlace(there), drawn);
      if (marks) {
        tried.Draw(*marks);
        const ColourFit colours = FitColours(window, tried, point.weights, point.slopes);
        gain = now - colours.chi2 - PriorCost(there, prior);
        if (gain > 0.0) {
          better = true;
          at = there;
          std::swap(layers, tried);
          damping = std::max(1e-6, 0.2 * damping);
          break;
        }
      }
      damping = std::max(1e-3, 10.0 * damping);
    }
    if (!better && step >= kDrawingSteps) break;
    point = PointAt(window, layers, step + 1 < kDrawingSteps);
    if (gain < 0.02 && step >= kDrawingSteps) break;
  }
  point = PointAt(window, layers, false);
  linear = Linearise(nominal, window, layers, point, at, prior, drawn);
  if (!linear) return std::nullopt;
  PlaceFit fit;
  fit.place = ToPlace(at);
  fit.place.X_VD.heading = WrapPi(fit.place.X_VD.heading);
  fit.covariance = linear->normal.inverse();
  fit.chi2 = point.cost + PriorCost(at, prior);
  Describe(window, layers, point, &fit);
  fit.covariance *= kCorrelated * std::max(1.0, fit.misfit);
  return fit;
}

}  // namespace dockyard::raposa
