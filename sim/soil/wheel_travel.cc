#include "sim/soil/wheel_travel.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

// Way after which a wheel counts as going and no more as rocking. Assumed, range 2-20 mm.
constexpr double kGoing_m = 0.005;
// Share of a paddle's buried height that it carries along. Fitted to the single-wheel data, see
// docs/results/soil.md; range 0.4-0.7.
constexpr double kCarriedShare = 0.50;
// Length over which the dug and the fresh soil balance: about the contact's. Assumed, 0.15-0.6.
constexpr double kBalance_radii = 0.3;
// A wheel that has dug itself in this deep digs no further: lifted soil falls back. Assumed, range
// 0.5-2.
constexpr double kDeepest_radii = 1.0;

}  // namespace

void Follow(WheelTravel& travel, const WheelWay& way, const PaddleCut& cut) {
  const double on_m = way.rolled_m + way.ahead_m;
  travel.going = Shear(travel.going, 0.5 * on_m, way.up_m, kGoing_m);
  travel.resting = 1.0 - (travel.going.t * travel.going.t + travel.going.a * travel.going.a);
  const double forward = on_m >= 0.0 ? 1.0 : -1.0;
  const double slid = std::max(0.0, forward * (way.rolled_m - way.ahead_m));
  const double travelled = std::sqrt(way.ahead_m * way.ahead_m + way.left_m * way.left_m);
  const double length = kBalance_radii * cut.rim_radius_m;
  const double dug = kCarriedShare * cut.depth_m * slid / length;
  travel.excavated_m = (travel.excavated_m + dug) /
                       (1.0 + travelled / length + dug / (kDeepest_radii * cut.rim_radius_m));
}

}  // namespace dockyard
