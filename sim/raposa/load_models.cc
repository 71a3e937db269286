#include "sim/raposa/load_models.h"

#include "models/raposa/load_ground.h"
#include "models/raposa/load_pyramid.h"
#include "models/raposa/load_robot.h"
#include "sim/plant/model_files.h"

namespace dockyard::raposa {

RaposaModels LoadModels(const Scenario& scenario, MeshStore* meshes) {
  RequireFiles(scenario, "RAPOSA's", "a ground's");
  RefuseCamera(scenario, "RAPOSA's camera stands in its robot's file",
               "they stand in the robot's file");
  RaposaModels models;
  models.keys = ReadRaposaKeys(scenario);
  CheckRoots(scenario, {"robot", "pyramid", "soil"});
  LoadSets(
      scenario,
      [&](const auto& changes) {
        return ModelSet{LoadRobot(scenario.robot_file, changes("robot"), meshes),
                        LoadPyramid(models.keys.pyramid_file, changes("pyramid"), meshes),
                        LoadGround(scenario.soil_file, changes("soil"))};
      },
      models);
  return models;
}

}  // namespace dockyard::raposa
