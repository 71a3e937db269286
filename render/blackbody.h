// Colour of light by its temperature.
#pragma once

#include <Eigen/Core>

namespace dockyard {

/// Linear red, green, blue (primaries of IEC 61966-2-1) of a black body at 1667 to 25000 K, scaled
/// to Luminance 1. Chromaticity: cubic fit of the Planckian locus (Kim et al., US patent 7024034,
/// 2006). Values outside the primaries' triangle are cut at zero.
Eigen::Vector3d BlackbodyRgb(double temperature_k);

/// The same before the colour is taken: CIE 1931 x and y.
Eigen::Vector2d BlackbodyChromaticity(double temperature_k);

}  // namespace dockyard
