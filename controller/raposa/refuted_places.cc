#include "controller/raposa/refuted_places.h"

#include <algorithm>
#include <cmath>

namespace dockyard::raposa {
namespace {

constexpr std::size_t kMost = 40;      // the oldest go
constexpr double kDrift = 0.05;        // of a distance, added to the radius; assumed, 0.02-0.1
constexpr double kMostRadius_m = 0.4;  // assumed, 0.3-0.6
constexpr double kBearing_rad = 0.05;  // of a bearing by belts and image; assumed, 0.03-0.1
constexpr double kRangeFactor = 1.6;   // of a range by a spot's size; assumed, 1.4-2

}  // namespace

void RefutedPlaces::Move(const Pose2& X_VV) {
  const Pose2 back = Inverse(X_VV);
  const double moved_m = std::hypot(X_VV.x, X_VV.y);
  for (RefutedThing& thing : things_) {
    const Pose2 p = back * Pose2{thing.range_m * std::cos(thing.bearing_rad),
                                 thing.range_m * std::sin(thing.bearing_rad), 0.0};
    thing.bearing_rad = std::atan2(p.y, p.x);
    thing.range_m = std::hypot(p.x, p.y);
    thing.radius_m = std::min(kMostRadius_m, thing.radius_m + kDrift * moved_m);
  }
}

void RefutedPlaces::Add(const RefutedThing& thing) {
  if (things_.size() == kMost) things_.erase(things_.begin());
  things_.push_back(thing);
}

void RefutedPlaces::Correct(std::size_t thing, double bearing_rad) {
  if (thing < things_.size()) things_[thing].bearing_rad = bearing_rad;
}

bool Is(const RefutedThing& thing, double bearing_rad, double range_m) {
  const double aside = kBearing_rad + thing.radius_m / std::max(thing.range_m, thing.radius_m);
  return std::abs(WrapPi(thing.bearing_rad - bearing_rad)) < aside &&
         range_m < kRangeFactor * (thing.range_m + thing.radius_m) &&
         kRangeFactor * range_m > thing.range_m - thing.radius_m;
}

}  // namespace dockyard::raposa
