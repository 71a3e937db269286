// What the encoders of belts and arm say of the motion in one control period.
#pragma once

#include <array>
#include <optional>

#include "controller/raposa/dockyard_options.h"
#include "controller/raposa/nominal/nominal.h"
#include "controller/raposa/pyramid_filter.h"

namespace dockyard::raposa {

class BeltReader {
 public:
  BeltReader(const Nominal& nominal, const DockyardOptions& options)
      : nominal_(nominal), options_(options) {}
  /// None at the first reading. driven: whether the belts were commanded since the last one.
  std::optional<BeltSteps> Read(const SensorFrame& sensed, bool driven);
  double arm_rad() const { return arm_rad_; }
  /// Nominal, for the arm's angle: pressed down its tip bears, and the belts' tread is longer.
  double gauge_m() const;

 private:
  Nominal nominal_;
  DockyardOptions options_;
  double arm_rad_ = 0.0;
  std::optional<std::array<double, 2>> belts_m_;  // left, right
};

}  // namespace dockyard::raposa
