// Colour bands in a scenario of RAPOSA: the user's hand on ferreira2009's thresholds.
#pragma once

#include "controller/raposa/nominal/ferreira_options.h"
#include "sim/raposa/raposa_keys.h"

namespace dockyard::raposa {

/// Puts `bands` and `band_changes` in place of those of `vision`. Bands are {orange: {hue: [from,
/// to], saturation: [from, to], value: [from, to]}, blue: {...}}, hue in half degrees as OpenCV has
/// it; one that is left out stays as it was before. Changes are in the order of their times. Throws
/// ConfigError.
void PutBands(const RaposaKeys& keys, FerreiraVision& vision);

}  // namespace dockyard::raposa
