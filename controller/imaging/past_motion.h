// Where a robot was when an image was exposed that comes later.
#pragma once

#include <deque>

#include "controller/geometry/pose.h"
#include "controller/io/sensors.h"

namespace dockyard {

struct PastMoment {
  Tick tick = 0;
  Pose2 X_OR{};  // by odometry, O fixed
  ImuSample imu{};
};

class PastMotion {
 public:
  /// kept: how far back.
  explicit PastMotion(Tick kept) : kept_(kept) {}
  /// Later than those before.
  void Add(const PastMoment& moment);
  void Clear() { moments_.clear(); }
  /// Whether it has moments from before and after that time, or of it. A stamp may be ahead of the
  /// last moment by what clocks differ (kMostStampError); the last one is the nearest then.
  bool Holds(Tick tick) const;
  /// There must be one.
  const PastMoment& Nearest(Tick tick) const;

 private:
  Tick kept_;
  std::deque<PastMoment> moments_;
};

}  // namespace dockyard
