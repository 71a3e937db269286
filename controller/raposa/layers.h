// The pyramid's colours in a window as sums of layers: how much of each cell the ground, the sky,
// grey parts, orange and blue fill, and the colours that explain the image best.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "controller/raposa/fit_window.h"
#include "controller/raposa/marks_projection.h"

namespace dockyard::raposa {

enum Layer : std::size_t { kEven, kRamp, kSky, kBoxes, kFaces, kOrangeLayer, kBlueLayer };
inline constexpr std::size_t kLayers = 7;

/// Shares of the cells, by layer.
class LayerImage {
 public:
  /// What does not move: ground, with a ramp down the rows, and sky.
  explicit LayerImage(const FitWindow& window);
  /// The marks there; without blue and grey parts where they have no polygons.
  void Draw(const MarksInImage& marks);
  const std::vector<float>& Shares(std::size_t layer) const { return shares_[layer]; }

 private:
  void Raster(const std::vector<ConvexPolygon>& polygons, std::vector<float>* fine);
  void ToCells(std::vector<float>* fine, std::vector<float>* cells);

  const FitWindow* window_;
  Coverage coverage_;
  std::vector<float> guide_, rod_, strips_, faces_, boxes_;
  std::array<std::vector<float>, kLayers> shares_;
};

/// Colours of the layers in the two whitened values of FitWindow.
using LayerColours = Eigen::Matrix<float, kLayers, 2>;
using LayerNormal = Eigen::Matrix<double, kLayers, kLayers>;

struct ColourFit {
  LayerColours colours = LayerColours::Zero();
  LayerNormal inverse = LayerNormal::Zero();  // of the normal matrix: the colours' covariance
  double chi2 = 0.0;                          // of cells and of the colours' priors
};

/// Least squares with these weights of the cells. Priors: colours of the grey parts lie near the
/// ground's, those of paint anywhere.
ColourFit FitColours(const FitWindow& window, const LayerImage& layers,
                     const std::vector<float>& weights);

/// What is left of a cell.
inline Eigen::Vector2f Residual(const FitWindow& window, const LayerImage& layers,
                                const LayerColours& colours, std::size_t cell) {
  Eigen::Vector2f left = window.seen[cell];
  for (std::size_t l = 0; l < kLayers; ++l) {
    left -= layers.Shares(l)[cell] * colours.row(static_cast<Eigen::Index>(l)).transpose();
  }
  return left;
}

/// Weights for these colours: paint's shading, and the coding of colours at its edges, are known to
/// a share of it only.
std::vector<float> WeightsFor(const FitWindow& window, const LayerImage& layers,
                              const LayerColours& colours);

}  // namespace dockyard::raposa
