#include "controller/raposa/visual_turn.h"

#include <algorithm>
#include <cmath>

#include "controller/raposa/align_plan.h"

namespace dockyard::raposa {

VisualTurn::VisualTurn(double turn_rad, double bearing_rad, double range_m, double lever_m,
                       const FerreiraMotion& options)
    : turn_rad_(turn_rad),
      from_rad_(TurnOfBearing(bearing_rad, range_m, lever_m)),
      range_m_(range_m),
      lever_m_(lever_m),
      rate_rad_s_(turn_rad < 0.0 ? -options.visual_turn_rad_s : options.visual_turn_rad_s) {}

std::optional<Twist> VisualTurn::Step(const std::optional<Look>& look) {
  if (!look) {
    last_rad_.reset();
    return Twist{};
  }
  const double next_rad = look->bearing_rad + (last_rad_ ? look->bearing_rad - *last_rad_ : 0.0);
  last_rad_ = look->bearing_rad;
  turned_rad_ = TurnOfBearing(next_rad, range_m_, lever_m_) - from_rad_;
  const double side = turn_rad_ < 0.0 ? -1.0 : 1.0;
  if (side * turned_rad_ >= side * turn_rad_) return std::nullopt;
  if (side * next_rad >= look->edge_rad) return std::nullopt;
  return Twist{0.0, rate_rad_s_};
}

double EdgeBearing(double half_view_rad, double focal_px, double down_px, double radius_px) {
  const double view_px = focal_px * std::tan(half_view_rad);
  const double half_px = std::sqrt(std::max(view_px * view_px - down_px * down_px, 0.0));
  return std::atan(std::max(half_px - radius_px, 0.0) / focal_px);
}

}  // namespace dockyard::raposa
