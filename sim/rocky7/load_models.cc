#include "sim/rocky7/load_models.h"

#include "models/read/load_soil.h"
#include "models/rocky7/load_robot.h"
#include "sim/plant/model_files.h"

namespace dockyard::rocky7 {

Rocky7Models LoadModels(const Scenario& scenario) {
  RequireFiles(scenario, "Rocky 7's");
  RefuseCamera(scenario, "Rocky 7's cameras stand in its robot's file",
               "the robot's cameras.width_px and height_px give the size of Rocky 7's images");
  Rocky7Models models;
  models.keys = ReadRocky7Keys(scenario);
  CheckRoots(scenario, {"robot", "soil"});
  LoadSets(
      scenario,
      [&](const auto& changes) {
        return ModelSet{LoadRobot(scenario.robot_file, changes("robot")),
                        LoadSoil(scenario.soil_file, changes("soil"))};
      },
      models);
  return models;
}

}  // namespace dockyard::rocky7
