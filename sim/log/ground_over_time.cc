#include "sim/log/ground_over_time.h"

namespace dockyard {

GroundOverTime::GroundOverTime(const LoggedRun& run) : changes_(run.ground) {
  if (changes_.empty()) return;
  const LoggedGround& first = changes_.front().value;
  if (!first.cells.empty() || first.nx < 2 || first.ny < 2) return;
  grid_ = &first;
  heights_ = first.heights;
}

void GroundOverTime::AdvanceTo(double time_s) {
  constexpr double kRounding_s = 1e-6;
  if (grid_ == nullptr) return;
  for (; next_ < changes_.size() && changes_[next_].time_s <= time_s + kRounding_s; ++next_) {
    const LoggedGround& change = changes_[next_].value;
    for (std::size_t i = 0; i < change.cells.size() && i < change.heights.size(); ++i) {
      if (change.cells[i] < heights_.size()) heights_[change.cells[i]] = change.heights[i];
    }
  }
}

}  // namespace dockyard
