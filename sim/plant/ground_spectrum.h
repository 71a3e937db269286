// The spectrum that the ground reflects.
#pragma once

#include "models/parts/floor_model.h"
#include "render/spectrum.h"

namespace dockyard {

Spectrum SpectrumOf(GroundMaterialKind material);

}  // namespace dockyard
