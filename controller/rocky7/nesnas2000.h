// The controller of Nesnas, Maimone and Das (ICRA 2000), as they describe it.
#pragma once

#include <memory>

#include "controller/io/controller.h"
#include "controller/rocky7/nominal/nominal.h"

namespace dockyard::rocky7 {

/// Tracks the local maximum of heights and stops for each look. Its belief has these values:
/// "target_x_m" and "target_y_m" in R, "looks" and "grasps".
std::unique_ptr<Controller> MakeNesnas2000Controller(const Nominal& nominal);

}  // namespace dockyard::rocky7
