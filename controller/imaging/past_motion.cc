#include "controller/imaging/past_motion.h"

#include <algorithm>
#include <cstdlib>

#include "controller/base/check.h"
#include "controller/imaging/image_request.h"

namespace dockyard {

void PastMotion::Add(const PastMoment& moment) {
  DOCKYARD_CHECK(moments_.empty() || moment.tick > moments_.back().tick);
  moments_.push_back(moment);
  while (moment.tick - moments_.front().tick > kept_) moments_.pop_front();
}

bool PastMotion::Holds(Tick tick) const {
  return !moments_.empty() && moments_.front().tick <= tick &&
         tick <= moments_.back().tick + kMostStampError;
}

const PastMoment& PastMotion::Nearest(Tick tick) const {
  DOCKYARD_CHECK(!moments_.empty());
  return *std::min_element(moments_.begin(), moments_.end(),
                           [&](const PastMoment& a, const PastMoment& b) {
                             return std::abs(a.tick - tick) < std::abs(b.tick - tick);
                           });
}

}  // namespace dockyard
