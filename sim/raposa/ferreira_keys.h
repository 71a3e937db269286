// What a scenario of RAPOSA says of ferreira2009: its colour bands, speeds, times and limits.
#pragma once

#include "controller/raposa/nominal/ferreira_options.h"
#include "sim/raposa/raposa_keys.h"

namespace dockyard::raposa {

/// Puts `bands` and `band_changes` in place of those of `vision`. Bands are {orange: {hue: [from,
/// to], saturation: [from, to], value: [from, to]}, blue: {...}}, hue in half degrees as OpenCV has
/// it; one that is left out stays as it was before. Changes are in the order of their times. Throws
/// ConfigError.
void PutBands(const RaposaKeys& keys, FerreiraVision& vision);

/// Puts what the keys `motion` and `vision` name in place of the members: the names of
/// FerreiraMotion, with _deg for _rad, and of FerreiraVision. Throws ConfigError.
void PutMotion(const RaposaKeys& keys, FerreiraMotion& motion);
void PutVision(const RaposaKeys& keys, FerreiraVision& vision);

}  // namespace dockyard::raposa
