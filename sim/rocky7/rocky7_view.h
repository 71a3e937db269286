// From the truth to pictures: the only caller of render/.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/scene.h"
#include "sim/base/random.h"
#include "sim/rocky7/build_run.h"
#include "sim/rocky7/rover_shapes.h"
#include "sim/run/stage_shapes.h"

namespace dockyard::rocky7 {

/// The name of a loose stone of the field in a spectator's log.
std::string LooseStoneName(std::size_t number);

/// Builds the scene that the cameras see. Meshes are converted once; poses come from the truth.
class SceneBuilder {
 public:
  SceneBuilder(const BuiltRun& built, const WheeledBody& rover, const Seed& run_seed);

  /// The scene borrows the grid's heights: draw it before the grid changes.
  Scene Make(const Truth& truth, const HeightGrid& ground) const;
  /// For spectators; bodies in the order of Rocky7Plant::Look.
  StageShapes Shapes() const;

 private:
  struct Link {
    std::string name;
    std::vector<DrawnPart> parts;
  };

  /// In G; it follows the ground below it.
  struct Pebble {
    std::shared_ptr<const RenderMesh> mesh;
    Eigen::Vector2d p_G{0, 0};
    double ground_m = 0.0;  // at the start
  };

  void AddStones(const Truth& truth, const HeightGrid& ground, Scene& scene) const;
  void AddStones(StageShapes& shapes) const;
  Stains StainsOf(std::uint64_t seed) const { return {.contrast = stains_, .seed = seed}; }
  std::vector<StagePoint> Points() const;

  std::vector<Link> links_;
  std::optional<std::size_t> instrument_link_;             // the mast's outer link
  double instrument_m_ = 0.0;                              // along it to the instrument's face
  std::vector<std::shared_ptr<const RenderMesh>> stones_;  // in G; a fixed target first
  std::vector<std::shared_ptr<const RenderMesh>> loose_;   // of the field, each in its own frame
  std::vector<Pebble> gravel_;
  std::shared_ptr<const RenderMesh> loose_target_;  // in its own frame; or none
  std::shared_ptr<const RenderMesh> boulder_;       // in G; or none
  Lighting lighting_;
  Pose3 X_WG_;
  Eigen::Vector3d soil_rgb_, stone_rgb_;
  double stains_;
  Eigen::Vector3d target_G_;  // of a boulder: the middle of its face
  std::uint64_t texture_seed_ = 0;
};

}  // namespace dockyard::rocky7
