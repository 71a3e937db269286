#include "controller/raposa/mark_borders.h"

#include <algorithm>

namespace dockyard::raposa {
namespace {

/// Whether the mark lies in the cell or next to it.
bool Near(const FitWindow& window, const std::vector<float>& share, int column, int row) {
  for (int j = std::max(0, row - 1); j <= std::min(window.rows - 1, row + 1); ++j) {
    for (int i = std::max(0, column - 1); i <= std::min(window.columns - 1, column + 1); ++i) {
      if (share[static_cast<std::size_t>(j * window.columns + i)] >= kOfMarks) return true;
    }
  }
  return false;
}

}  // namespace

float MarksIn(const LayerImage& layers, std::size_t cell) {
  return layers.Shares(kOrangeLayer)[cell] + layers.Shares(kBlueLayer)[cell] +
         layers.Shares(kFaces)[cell] + layers.Shares(kBoxes)[cell];
}

double ShareBeyond(const FitWindow& window, const LayerImage& layers, const LayerColours& colours,
                   Layer mark) {
  const Eigen::Vector2f colour = colours.row(static_cast<Eigen::Index>(mark)).transpose();
  const Eigen::Vector2f sky = colours.row(kSky).transpose();
  int count = 0, like = 0;
  std::size_t k = 0;
  for (int row = 0; row < window.rows; ++row) {
    for (int column = 0; column < window.columns; ++column, ++k) {
      if (window.open[k] == 0.0f || MarksIn(layers, k) >= kOfMarks) continue;
      if (!Near(window, layers.Shares(mark), column, row)) continue;
      ++count;
      // The cells of a horizon are half of the sky's colour, which may be blue.
      const Eigen::Vector2f ground = window.seen[k] - layers.Shares(kSky)[k] * sky;
      like += ground.dot(colour) > 0.5f * colour.squaredNorm();
    }
  }
  return count > 0 ? static_cast<double>(like) / count : 0.0;
}

double ShareOfOthers(const FitWindow& window, const LayerImage& layers, const LayerColours& colours,
                     const std::vector<float>& weights, Layer mark) {
  int count = 0, others = 0;
  for (std::size_t k = 0; k < window.size(); ++k) {
    if (window.open[k] == 0.0f || layers.Shares(mark)[k] < kOfMarks) continue;
    ++count;
    others +=
        weights[k] * Residual(window, layers, colours, k).squaredNorm() > kOtherThing * kOtherThing;
  }
  return count > 0 ? static_cast<double>(others) / count : 0.0;
}

}  // namespace dockyard::raposa
