#include "sim/app/systems.h"

#include "controller/axel/axel.h"
#include "controller/axel/scripted.h"
#include "controller/custom/graceful.h"
#include "controller/raposa/dockyard.h"
#include "controller/raposa/ferreira2009.h"
#include "controller/rocky7/dockyard.h"
#include "controller/rocky7/nesnas2000.h"
#include "sim/app/raposa/raposa_commands.h"
#include "sim/axel/axel_system.h"
#include "sim/custom/custom_system.h"
#include "sim/raposa/raposa_system.h"
#include "sim/rocky7/rocky7_system.h"

namespace dockyard {
namespace {

std::unique_ptr<Controller> MakeGraceful(const custom::Nominal& nominal) {
  auto made = custom::MakeGracefulController(nominal);
  if (!made) custom::RefuseController("graceful", made.error().reason);
  return std::move(*made);
}

}  // namespace

std::vector<System> Systems() {
  return {axel::AxelSystem(
              {{"dockyard",
                [](const axel::Nominal& nominal) { return axel::MakeDockyardController(nominal); },
                "axel"},
               {"tsai2013",
                [](const axel::Nominal& nominal) { return axel::MakeTsai2013Controller(nominal); }},
               {"reel_only", axel::MakeReelOnlyController}},
              axel::MakeScriptedController),
          raposa::RaposaSystem({{"dockyard", raposa::MakeDockyardController},
                                {"ferreira2009", raposa::MakeFerreira2009Controller}},
                               raposa::RaposaCommands(), raposa::DetectCommand()),
          rocky7::Rocky7System({{"dockyard", rocky7::MakeDockyardController},
                                {"nesnas2000", rocky7::MakeNesnas2000Controller}}),
          custom::CustomSystem({{"graceful", MakeGraceful}})};
}

}  // namespace dockyard
