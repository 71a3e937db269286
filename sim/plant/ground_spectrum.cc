#include "sim/plant/ground_spectrum.h"

namespace dockyard {

Spectrum SpectrumOf(GroundMaterialKind material) {
  switch (material) {
    case GroundMaterialKind::kSoil:
      return Soil();
    case GroundMaterialKind::kGrass:
      return Grass();
    case GroundMaterialKind::kBrick:
      return Brick();
    case GroundMaterialKind::kGrey:
      return EvenGrey(0.3);
    case GroundMaterialKind::kFloor:
      break;
  }
  return FloorCovering();
}

}  // namespace dockyard
