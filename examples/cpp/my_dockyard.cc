// Dockyard's program with a controller of one's own beside Axel's:
//   my_dockyard run examples/cpp/my_docking.yaml
#include "controller/axel/axel.h"
#include "controller/axel/scripted.h"
#include "sim/app/program.h"
#include "sim/axel/axel_system.h"
#include "straight_in.h"

int main(int argc, char** argv) {
  namespace axel = dockyard::axel;
  const auto ours = [](const axel::Nominal& nominal) {
    return axel::MakeDockyardController(nominal);
  };
  // The names are those that a scenario's key `controller` takes.
  return dockyard::RunProgram(
      argc, argv,
      {axel::AxelSystem({{"dockyard", ours}, {"straight_in", MakeStraightIn}},
                        axel::MakeScriptedController)});
}
