// The world of a logged run as a scene to draw.
#pragma once

#include <cstddef>
#include <vector>

#include "render/scene.h"
#include "sim/log/ground_over_time.h"
#include "sim/log/logged_run.h"
#include "sim/run/stage_shapes.h"

namespace dockyard {

/// Scenes of a run, one sample after the other. Run and shapes must outlive it.
class OutsideScenes {
 public:
  /// Throws DataError for a log whose bodies are not those of the shapes, or without a sample.
  OutsideScenes(const LoggedRun& run, const StageShapes& shapes);

  /// Samples must not fall. The scene borrows the heights: it is good until the next call.
  Scene At(std::size_t sample);

 private:
  void AddBodies(std::size_t sample, Scene& scene) const;
  void AddGround(std::size_t sample, Scene& scene);

  const LoggedRun& run_;
  const StageShapes& shapes_;
  std::vector<std::size_t> places_;  // of the shapes' bodies in the log
  GroundOverTime ground_;
  std::size_t revision_ = 0;  // of the heights in metres
  std::vector<double> heights_m_;
};

}  // namespace dockyard
