#include "controller/rocky7/pair_work.h"

#include <cmath>
#include <utility>

#include "controller/base/check.h"

namespace dockyard::rocky7 {

PairWork::PairWork(double compute_s) : lasts_(std::llround(compute_s / kTickSeconds)) {
  DOCKYARD_CHECK(compute_s >= 0.0);
}

void PairWork::Begin(const SensorFrame& sensed) {
  DOCKYARD_CHECK(!busy());
  sensed_ = sensed;
}

std::optional<SensorFrame> PairWork::Done(Tick now) {
  if (!sensed_ || now - sensed_->tick < lasts_) return std::nullopt;
  return std::exchange(sensed_, std::nullopt);
}

}  // namespace dockyard::rocky7
