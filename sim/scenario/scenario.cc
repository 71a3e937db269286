#include "sim/scenario/scenario.h"

namespace dockyard {

const char* LightName(Light light) {
  switch (light) {
    case Light::kEven:
      return "even";
    case Light::kSpeckled:
      return "speckled";
    case Light::kHardShadow:
      return "hard_shadow";
  }
  return "unknown";
}

}  // namespace dockyard
