// What `dockyard detect --pipeline dockyard` draws and prints.
#pragma once

#include "controller/raposa/pyramid_finder.h"

namespace dockyard::raposa {

/// The outlines of the marks as the best fit has them, or a cross on the guide.
void DrawPyramid(const Nominal& nominal, const PyramidSighting& sighting, RgbImage& image);
void PrintPyramid(const PyramidSighting& sighting, bool as_json);

}  // namespace dockyard::raposa
