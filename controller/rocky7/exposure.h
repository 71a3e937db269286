// How much more light a picture should have for what is looked at.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "controller/geometry/image.h"

namespace dockyard::rocky7 {

/// By the grey about a pixel: stops more than the picture had, where that is worth another one;
/// none where it is not, and off the picture.
/// @param about_px   to either side of the pixel, that counts
/// @param stops_now  of this picture, off the cameras' own exposure
std::optional<double> MoreStops(const GrayImage& image, const Eigen::Vector2d& pixel, int about_px,
                                double stops_now);

}  // namespace dockyard::rocky7
