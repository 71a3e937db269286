#include "controller/axel/felt_rocks.h"

#include <algorithm>
#include <cmath>

namespace dockyard::axel {

void FeltRocks::Reset() {
  lifts_ = {};
  before_.reset();
}

std::optional<MappedRock> FeltRocks::Take(const Attitude& attitude, const Pose2& X_OR,
                                          const Pose2& X_DR) {
  const Pose2 moved = before_ ? Inverse(*before_) * X_OR : Pose2{};
  before_ = X_OR;
  std::optional<MappedRock> felt;
  for (const int side : {0, 1}) {
    const double left = side == 0 ? 1.0 : -1.0;
    const double height_m = left * 2.0 * half_track_m_ * std::sin(attitude.roll_rad);
    std::optional<Lift>& lift = lifts_[static_cast<std::size_t>(side)];
    if (lift) {
      lift->way_m += std::abs(moved.x - left * half_track_m_ * moved.heading);
      const double turned_rad = std::abs(WrapPi(X_OR.heading - lift->X_OR.heading));
      if (lift->way_m > options_.within_m || turned_rad > options_.within_rad) lift.reset();
    }
    if (lift && height_m < options_.down_share * lift->height_m) {
      // The wheel has stood on it, so wheels climb it.
      const double rock_m = std::min(lift->height_m, limits_.wheel_climbs_m);
      const Pose2 X_DL = X_DR * Inverse(X_OR) * lift->X_OR * Pose2{0.0, left * half_track_m_, 0.0};
      felt = MappedRock{X_DL.x, X_DL.y, options_.radius_of_height * lift->height_m, rock_m};
      lift.reset();
    }
    const double least_m = lift ? lift->height_m : limits_.body_clears_m;
    if (height_m > least_m) lift = Lift{height_m, X_OR, 0.0};
  }
  return felt;
}

}  // namespace dockyard::axel
