// Our controller of Rocky 7: it tracks the middle of a stone among its neighbours, and backs up
// where one arc cannot bring the point onto it, or where it comes no nearer.
#pragma once

#include <memory>

#include "controller/io/controller.h"
#include "controller/rocky7/nominal/nominal.h"

namespace dockyard::rocky7 {

/// Its belief has these values: "target_x_m" and "target_y_m" in R, "looks" and "grasps".
std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal);

}  // namespace dockyard::rocky7
