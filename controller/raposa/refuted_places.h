// Places of things that were taken for the guide and are not, kept by the belts.
#pragma once

#include <vector>

#include "controller/geometry/pose.h"

namespace dockyard::raposa {

/// A thing that is no guide. Frame V: the camera in plan, x along its view, y left.
struct RefutedThing {
  double bearing_rad = 0.0, range_m = 0.0;
  double radius_m = 0.0;  // within which it is
};

class RefutedPlaces {
 public:
  /// The motion of V in its own frame since the last call.
  void Move(const Pose2& X_VV);
  void Add(const RefutedThing& thing);
  void Clear() { things_.clear(); }
  bool empty() const { return things_.empty(); }
  /// As the camera would see them now.
  const std::vector<RefutedThing>& things() const { return things_; }
  /// One of them is in the image at this bearing: belts drift, so its place is corrected.
  void Correct(std::size_t thing, double bearing_rad);

 private:
  std::vector<RefutedThing> things_;
};

/// Whether an orange spot is that thing.
bool Is(const RefutedThing& thing, double bearing_rad, double range_m);

}  // namespace dockyard::raposa
