#include "controller/raposa/pyramid_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace dockyard::raposa {
namespace {

using Matrix6 = Eigen::Matrix<double, kPlaceUnknowns, kPlaceUnknowns>;

// Of the covariance, above that of independent cells: shading and the coding of colours err alike
// in neighbours. From raposa_eye_survey, where chi2 of the poses was 2.5 to 6 a value; 3-6.
constexpr double kCorrelated = 4.0;
constexpr float kOfMarks = 0.02f;     // a cell of which marks fill so much counts for the misfit
constexpr float kOtherColour = 4.0f;  // so does one that is so many sigmas off the ground

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

/// The colours at a place, weighted by themselves.
struct Point {
  ColourFit colours;
  std::vector<float> weights;
  SlopePriors slopes;
};
Point PointAt(const FitWindow& window, const LayerImage& layers) {
  Point point;
  point.colours = FitColours(window, layers, window.open, AnySlopes(window));
  point.weights = WeightsFor(window, layers, point.colours.colours);
  point.slopes = SlopesFor(window, point.colours.colours);
  point.colours = FitColours(window, layers, point.weights, point.slopes);
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
  double sum = 0.0, blue = 0.0;
  int count = 0;
  for (std::size_t k = 0; k < window.size(); ++k) {
    if (window.open[k] == 0.0f) continue;
    const float o = layers.Shares(kOrangeLayer)[k], b = layers.Shares(kBlueLayer)[k];
    blue += b;
    const float marks = o + b + layers.Shares(kFaces)[k] + layers.Shares(kBoxes)[k];
    if (marks < kOfMarks && window.seen[k].norm() < kOtherColour) continue;
    sum += point.weights[k] * Residual(window, layers, point.colours.colours, k).squaredNorm();
    ++count;
  }
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
  return FitColours(window, layers, window.open, AnySlopes(window)).chi2 +
         PriorCost(ToVector(place), prior);
}

std::optional<PlaceFit> FitPlace(const Nominal& nominal, const FitWindow& window,
                                 const PyramidPlace& start, const PlacePrior& prior,
                                 MarksDrawn drawn, int most_steps) {
  const auto first = Project(nominal, start, drawn);
  if (!first) return std::nullopt;
  PlaceVector at = ToVector(start);
  LayerImage layers(window), tried(window);
  layers.Draw(*first);
  Point point = PointAt(window, layers);
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
    if (!better) break;
    point = PointAt(window, layers);
    if (gain < 0.02) break;
  }
  linear = Linearise(nominal, window, layers, point, at, prior, drawn);
  if (!linear) return std::nullopt;
  PlaceFit fit;
  fit.place = ToPlace(at);
  fit.place.X_VD.heading = WrapPi(fit.place.X_VD.heading);
  fit.covariance = linear->normal.inverse();
  fit.chi2 = point.colours.chi2 + PriorCost(at, prior);
  Describe(window, layers, point, &fit);
  fit.covariance *= kCorrelated * std::max(1.0, fit.misfit);
  return fit;
}

}  // namespace dockyard::raposa
