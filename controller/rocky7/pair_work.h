// An image pair while the processor works on it: what it shows is known some time after it came.
#pragma once

#include <optional>

#include "controller/io/sensors.h"

namespace dockyard::rocky7 {

class PairWork {
 public:
  /// compute_s: for a pair; 0: its result is there at once.
  explicit PairWork(double compute_s);

  bool busy() const { return sensed_.has_value(); }
  /// The frame that brought the pair. Not while it is busy.
  void Begin(const SensorFrame& sensed);
  /// That frame once its time is over. It is no longer busy then.
  std::optional<SensorFrame> Done(Tick now);

 private:
  const Tick lasts_;
  std::optional<SensorFrame> sensed_;
};

}  // namespace dockyard::rocky7
