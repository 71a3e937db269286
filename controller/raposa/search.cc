#include "controller/raposa/search.h"

#include <algorithm>

namespace dockyard::raposa {

void WideningSearch::Begin(double last_turn_rad) {
  begun_ = true;
  side_ = last_turn_rad > 0.0 ? -1.0 : 1.0;  // without a last one to the left; assumed
  leg_rad_ = options_.first_search_rad;
  done_rad_ = 0.0;
}

double WideningSearch::Step(double turned_rad) {
  done_rad_ += side_ * turned_rad;
  if (done_rad_ >= leg_rad_) {
    side_ = -side_;
    leg_rad_ = std::min(2.0 * leg_rad_, options_.most_search_rad);
    done_rad_ = 0.0;
  }
  return side_ * options_.search_turn_rad_s;
}

}  // namespace dockyard::raposa
