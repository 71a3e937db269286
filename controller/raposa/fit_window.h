// A part of the image as the fit of the pyramid sees it: by how much each cell's colour is not the
// ground's, in units of the ground's own noise.
#pragma once

#include <optional>
#include <vector>

#include "controller/raposa/colour_pairs.h"

namespace dockyard::raposa {

/// A rectangle of the image [px].
struct PixelRect {
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
};

/// Cells of unit_px rows and as many columns, but two for a unit of 1: colour is coded by pairs.
/// Of light with red, green and blue R, G, B over a ground of Rg, Gg, Bg a cell has the two values
///   R / Gg - (Rg/Gg) G / Gg  and  B / Gg - (Bg/Gg) G / Gg,
/// which are 0 on the ground however bright it is, and linear in what covers the cell.
struct FitWindow {
  int unit_px = 1;
  int x0_px = 0, y0_px = 0;  // of the first cell's first pixel
  int columns = 0, rows = 0;
  std::vector<Eigen::Vector2f> seen;  // the two values, times `whiten`
  std::vector<float> open;            // 1, or 0 where the hole's rim, sky or nothing is
  std::vector<std::uint8_t> blue;     // whether any of the cell is tinted blue
  std::vector<float> sky;             // share of the sky in each cell
  Eigen::Matrix2f whiten = Eigen::Matrix2f::Identity();
  GroundColour ground;

  int across_px() const { return unit_px == 1 ? 2 : unit_px; }
  std::size_t size() const { return seen.size(); }
};

/// At most that many cells. Rows above a horizon, if there is one above the row
/// lowest_horizon_px, are closed. None when too little ground is seen.
std::optional<FitWindow> WindowOn(const TintMap& map, const GroundColour& ground,
                                  const PixelRect& rect, int most_cells, double lowest_horizon_px);

}  // namespace dockyard::raposa
