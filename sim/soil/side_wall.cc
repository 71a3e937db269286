#include "sim/soil/side_wall.h"

namespace dockyard {
namespace {

// Where the heaped soil's pressure acts: this share of the depth above the wall's foot; 1/3 without
// a heap. Assumed, range 0.5-0.8.
constexpr double kPressureHeight = 2.0 / 3.0;
// Direction cosine at which a wall that slides along the soil has mobilised about half of the
// resistance. Fitted likewise; range 0.3-0.6.
constexpr double kHalfMobilised = 0.50;

}  // namespace

void AddSideWalls(const SoilLaws& laws, double contact_depth_m, const SpokeAxesOf<Four>& axes,
                  const SideStrips& strips, FourMask in_soil, double dt_s, SideWalls& walls,
                  LoadSumOf<Four>& sum) {
  const Four none = 0.0, down = -axes.r_z;
  const FourMask on = in_soil & (down > 0.0);
  // The wall's way is that of the wheel's middle plane, where neither side is preferred.
  const Four middle = Max(0.5 * (strips.depth_left_m + strips.depth_right_m), none);
  const Four radius =
      strips.radius_m - Min(strips.radius_m, kPressureHeight * middle / Max(down, Four(1e-3)));
  const SpokeVelocityOf<Four> v = VelocityAt(axes, radius, 0.0);
  const double over_modulus = 1.0 / ShearModulus(laws, contact_depth_m);
  const Four way = (dt_s * over_modulus) * Sqrt(v.r * v.r + v.t * v.t + v.a * v.a);
  const Four keep = Decay(way), gain = (dt_s * over_modulus) * Gain(way);
  walls.r = Select(on, keep * (walls.r + gain * v.r), none);
  walls.t = Select(on, keep * (walls.t + gain * v.t), none);
  walls.a = Select(on, keep * (walls.a + gain * v.a), none);
  const FourMask left_leads = walls.a > 0.0;
  const Four depth = Max(Select(left_leads, strips.depth_left_m, strips.depth_right_m), none);
  const Four y_m = Select(left_leads, strips.half_width_m, -strips.half_width_m);
  const Four share = (1.0 + kHalfMobilised) / (Abs(walls.a) + kHalfMobilised);
  const Four wall_n = share * strips.length_m * down * BulldozingResistance(laws, depth);
  const Four push = wall_n * walls.a, rub = laws.tan_phi * Abs(push);
  sum.AddAt(axes, radius, y_m, {-(rub * walls.r), -(rub * walls.t), -push});
}

}  // namespace dockyard
