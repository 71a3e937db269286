// The pyramid's colours in a window as sums of layers: how much of each cell the ground, the sky,
// grey parts, orange and blue fill, and the colours that explain the image best.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "controller/raposa/fit_window.h"
#include "controller/raposa/marks_projection.h"

namespace dockyard::raposa {

/// Paint is lit unevenly: its colour has a slope down the rows, the guide's one across as well.
enum Layer : std::size_t {
  kEven,
  kRamp,
  kSky,
  kBoxes,
  kFaces,
  kOrangeLayer,
  kBlueLayer,
  kOrangeDown,
  kOrangeAcross,
  kBlueDown
};
inline constexpr std::size_t kLayers = 10;

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
  void Slope(Layer of, Layer slope, bool down, const Eigen::Vector2d& middle_px, double half_px);
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

/// How far the slopes of orange and of blue may go from 0, in whitened values.
struct SlopePriors {
  double orange = 0.0, blue = 0.0;
};
/// For paint of unknown colour, and of these colours.
SlopePriors AnySlopes(const FitWindow& window);
SlopePriors SlopesFor(const FitWindow& window, const LayerColours& colours);

/// Least squares with these weights of the cells. Priors: colours of the grey parts lie near the
/// ground's, those of paint anywhere, their slopes near 0.
ColourFit FitColours(const FitWindow& window, const LayerImage& layers,
                     const std::vector<float>& weights, const SlopePriors& slopes);

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
