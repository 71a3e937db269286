#include "sim/soil/side_wall.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

// Where the heaped soil's pressure acts: this share of the depth above the wall's foot; 1/3 without
// a heap. Assumed, range 0.5-0.8.
constexpr double kPressureHeight = 2.0 / 3.0;
// Direction cosine at which a wall that slides along the soil has mobilised about half of the
// resistance. Fitted likewise; range 0.3-0.6.
constexpr double kHalfMobilised = 0.50;

}  // namespace

void AddSideWall(const SoilLaws& laws, double contact_depth_m, const SpokeAxes& axes,
                 const SideStrip& strip, double dt_s, SideWall& wall, LoadSum& sum) {
  const double down = -axes.r_G.z();
  if (down <= 0.0) {
    wall = {};
    return;
  }
  // The wall's way is that of the wheel's middle plane, where neither side is preferred.
  const double middle = std::max(0.0, 0.5 * (strip.depth_left_m + strip.depth_right_m));
  const double radius =
      strip.radius_m - std::min(strip.radius_m, kPressureHeight * middle / std::max(down, 1e-3));
  const SpokeVelocity v = VelocityAt(axes, radius, 0.0);
  const double way = dt_s * std::sqrt(v.r * v.r + v.t * v.t + v.a * v.a);
  if (way > 0.0) {
    const double keep = Decay(way / ShearModulus(laws, contact_depth_m)),
                 gain = (1.0 - keep) * dt_s / way;
    wall.r = wall.r * keep + v.r * gain;
    wall.t = wall.t * keep + v.t * gain;
    wall.a = wall.a * keep + v.a * gain;
  }
  const bool left_leads = wall.a > 0.0;
  const double depth = left_leads ? strip.depth_left_m : strip.depth_right_m;
  if (depth <= 0.0) return;
  const double y_m = left_leads ? strip.half_width_m : -strip.half_width_m;
  const double share = (1.0 + kHalfMobilised) / (std::fabs(wall.a) + kHalfMobilised);
  const double wall_n = share * strip.length_m * down * BulldozingResistance(laws, depth);
  const double push = wall_n * wall.a, rub = laws.tan_phi * std::fabs(push);
  sum.AddAt(axes, radius, y_m, {-rub * wall.r, -rub * wall.t, -push});
}

}  // namespace dockyard
