// From the truth to scenes: for cameras and for spectators.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "render/colour_table.h"
#include "render/scene.h"
#include "sim/base/random.h"
#include "sim/custom/build_run.h"
#include "sim/run/stage_shapes.h"

namespace dockyard::custom {

/// Builds the scene that a camera takes. Meshes are converted once; poses come from the truth.
class SceneBuilder {
 public:
  SceneBuilder(const BuiltRun& built, const Seed& run_seed);

  /// The scene borrows the grid's heights: draw it before the grid changes. A camera does not see
  /// the link that carries it, but for its shadow.
  Scene Make(const Truth& truth, const HeightGrid& ground, int carrier) const;
  /// Of the scene's materials; null where no camera needs them.
  const ColourTable* colours() const { return colours_ ? &*colours_ : nullptr; }
  /// For spectators; bodies in the order of CustomPlant::Look.
  StageShapes Shapes() const;

 private:
  struct Link {
    std::string name;
    std::vector<DrawnPart> parts;
  };
  static std::vector<Link> LinksOf(const LinkTree& tree, const char* root);
  void TakeColours(const BuiltRun& built);

  std::vector<Link> robot_, dock_;
  std::vector<BoardFit> boards_;
  Lighting lighting_;
  Pose3 X_WG_;
  Eigen::Vector3d floor_rgb_;
  double grain_ = 0.0;
  Eigen::Vector3d p_LQ_{0, 0, 0}, p_LP_{0, 0, 0};  // of the frames that meet, in their links
  int link_Q_ = 0, link_P_ = 0;
  std::vector<StagePoint> cameras_;
  std::optional<ColourTable> colours_;
  std::uint64_t texture_seed_ = 0, dust_seed_ = 0;
};

}  // namespace dockyard::custom
