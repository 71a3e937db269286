#include "sim/run/image_thinning.h"

#include <cmath>

namespace dockyard {

ImageThinning::ImageThinning(double gap_s)
    : gap_(static_cast<Tick>(std::llround(gap_s / kTickSeconds))) {}

bool ImageThinning::Keeps(Tick tick, const std::string& phase) {
  const bool keeps = gap_ == 0 || !kept_ || tick - *kept_ >= gap_ || phase != phase_;
  if (keeps) kept_ = tick;
  phase_ = phase;
  return keeps;
}

}  // namespace dockyard
