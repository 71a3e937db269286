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
    case Light::kRoom:
      return "room";
  }
  return "unknown";
}

bool Spoils(const EyeFaults& eye) {
  return eye.picture != EyeFaults::Picture::kNormal || eye.cover_share > 0.0 ||
         eye.dust_share > 0.0;
}

}  // namespace dockyard
