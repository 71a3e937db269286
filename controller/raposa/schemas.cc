#include "controller/raposa/schemas.h"

#include <algorithm>

namespace dockyard::raposa {
namespace {

double Steer(const MarksSeen& seen, const FerreiraMotion& options) {
  return seen.orange ? -options.k_angular_rad_s_px * seen.deviation_px.x() : 0.0;
}

}  // namespace

Twist Approach(const MarksSeen& seen, const FerreiraMotion& options) {
  if (!seen.orange) return {};
  const double far_m = std::min(seen.orange->distance_m, options.slow_below_m);
  return {options.k_linear_per_s * far_m, Steer(seen, options)};
}

Twist FinalApproach(const MarksSeen& seen, const FerreiraMotion& options) {
  return {options.final_speed_m_s, options.steer_final ? Steer(seen, options) : 0.0};
}

Twist CreepToOrange(const MarksSeen& seen, const FerreiraMotion& options) {
  return {options.creep_m_s, Steer(seen, options)};
}

bool NearGuide(const MarksSeen& seen, const FerreiraMotion& options) {
  return seen.orange && seen.orange->distance_m < options.arm_below_m;
}

double ArmFor(const MarksSeen& seen, const FerreiraMotion& options) {
  return std::clamp(options.k_arm_rad_px * seen.deviation_px.y(), options.least_arm_rad,
                    options.most_arm_rad);
}

double TurnAboutBlue::Step(double blue_px, double half_view_px, const FerreiraMotion& options) {
  // A turn to the left moves the picture to the right.
  if (side_ == 0.0) side_ = blue_px > 0.0 ? -1.0 : 1.0;
  if (side_ * blue_px > options.blue_sweep * half_view_px) side_ = -side_;
  return side_ * options.search_turn_rad_s;
}

}  // namespace dockyard::raposa
