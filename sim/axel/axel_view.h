// From the truth to images: the only caller of render/.
#pragma once

#include <memory>
#include <vector>

#include "models/axel/axel_model.h"
#include "models/axel/station_model.h"
#include "models/parts/soil_model.h"
#include "render/scene.h"
#include "sim/axel/world.h"
#include "sim/plant/light.h"
#include "sim/run/stage_shapes.h"
#include "sim/scenario/scenario.h"

namespace dockyard::axel {

/// Builds the scene that the cameras see. Meshes are converted once; poses come from the truth.
class SceneBuilder {
 public:
  SceneBuilder(const RoverModel& rover, const StationModel& station, const SoilModel& soil,
               Lighting lighting, const Pose3& X_WG, const Seed& run_seed);

  /// Rocks that stand in the ground, in G.
  void AddRocks(const RockBed& bed);
  /// The scene borrows the grid's heights: draw it before the grid changes.
  Scene Make(const Truth& truth, const HeightGrid& ground) const;
  /// The same for spectators; bodies in the order of AxelPlant::Look.
  StageShapes Shapes() const;

 private:
  struct DrawnLink {
    std::string name;
    std::vector<DrawnPart> parts;
  };

  std::vector<DrawnPart> body_, left_wheel_, right_wheel_, arm_, station_, stand_, rocks_;
  std::vector<DrawnLink> further_;
  Pose3 X_S_module_, X_SB_;
  Eigen::Vector3d p_SM_, p_AT_;  // the mouth; the arm's tip
  FiducialBoard board_;
  BoardCutout cutout_;
  Eigen::Vector3d soil_rgb_, rock_rgb_;
  double tether_diameter_m_ = 0.0;
  Lighting lighting_;
  Pose3 X_WG_;
  std::uint64_t texture_seed_ = 0;
};

}  // namespace dockyard::axel
