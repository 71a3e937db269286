// Which frames of a run keep their images in its log.
#pragma once

#include <optional>
#include <string>

#include "controller/io/sensors.h"

namespace dockyard {

/// All of them without a gap. Else those of a change of the controller's phase, and one in the gap.
class ImageThinning {
 public:
  explicit ImageThinning(double gap_s);
  /// Of the frame with images at that tick; `phase` is the controller's after it. In order of time.
  bool Keeps(Tick tick, const std::string& phase);

 private:
  Tick gap_ = 0;
  std::optional<Tick> kept_;
  std::string phase_;
};

}  // namespace dockyard
