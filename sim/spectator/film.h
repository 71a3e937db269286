// A logged run as a film: the outside view, the cameras' last images in it, and a caption.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/image.h"
#include "sim/spectator/looks.h"
#include "sim/spectator/outside_view.h"

namespace dockyard {

/// Run, shapes and renderer must outlive it.
class Film {
 public:
  /// Throws as OutsideScenes.
  Film(const LoggedRun& run, const StageShapes& shapes, const OutsideOptions& options,
       StereoRenderer& renderer);

  /// Samples must not fall.
  RgbImage Frame(std::size_t sample);

 private:
  std::vector<std::string> Caption(std::size_t sample) const;
  void AddInsets(double time_s, RgbImage& frame);

  const LoggedRun& run_;
  OutsideView view_;
  std::vector<Look> looks_;
  std::optional<std::size_t> shown_;  // the look of the insets
  std::vector<RgbImage> insets_;
};

}  // namespace dockyard
