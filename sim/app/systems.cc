#include "sim/app/systems.h"

#include "controller/axel/axel.h"
#include "controller/axel/scripted.h"
#include "sim/axel/axel_system.h"

namespace dockyard {

std::vector<System> Systems() {
  return {axel::AxelSystem(
      {{"dockyard",
        [](const axel::Nominal& nominal) { return axel::MakeDockyardController(nominal); }, "axel"},
       {"tsai2013",
        [](const axel::Nominal& nominal) { return axel::MakeTsai2013Controller(nominal); }},
       {"reel_only", axel::MakeReelOnlyController}},
      axel::MakeScriptedController)};
}

}  // namespace dockyard
