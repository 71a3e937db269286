// Reaches the headers of what it links, and no others.
#include <cstdio>

#include "controller/geometry/pose.h"
#include "controller/io/controller.h"

#ifdef REACHES_controller
#include "controller/axel/axel.h"
#include "controller/vision/board/locate.h"
#elif __has_include("controller/vision/board/locate.h")
#error "dockyard::contract reaches controller/vision"
#endif
#if __has_include("sim/run/system.h") || __has_include("models/parts/link.h") || \
                                                       __has_include("render/scene.h")
#error "a controller reaches the simulation"
#endif

int main() {
  const double turned_rad = dockyard::WrapPi(3.0 * dockyard::kPi);
  std::printf("half a turn, three times: %.6f rad\n", turned_rad);
  return turned_rad > 3.14 || turned_rad < -3.14 ? 0 : 1;
}
