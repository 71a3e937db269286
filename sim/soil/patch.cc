#include "sim/soil/patch.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

// Shear damping as a time by which the displacement is led by its rate; it stops the shaking of a
// wheel on elastic shear and never exceeds the strength. Assumed, range 0.005-0.03 s on the way;
// twice that at rest, where loaded sand damps small strains by some per cent of critical.
constexpr double kShearLead_s = 0.015;
// A patch of a resting wheel that slides along its own plane takes the soil below along, over about
// this distance, and so does not press it: pressure acts along the normal, and were it to change
// with sliding as well, a rocking wheel would draw energy from the soil. Assumed, range 2-10 mm.
constexpr double kRide_m = 0.005;

Mobilisation LedBy(const Mobilisation& m, double v_t, double v_a, double lead) {
  const Mobilisation led{m.t + lead * v_t, m.a + lead * v_a};
  const double square = led.t * led.t + led.a * led.a;
  if (square <= 1.0) return led;
  const double scale = 1.0 / std::sqrt(square);
  return {led.t * scale, led.a * scale};
}

/// Share of a patch's sliding that drives the wheel on its way, 0..1.
double DrivingShare(const Mobilisation& m, double going) {
  const double drive = std::max(0.0, m.t * going);
  return drive * drive / (m.t * m.t + m.a * m.a + 1e-3);  // some per cent of mobilisation count
}

/// Elastic from the floor, limited by yield, which lowers the floor [Pa].
double Pressure(const SoilLaws& laws, double yield_pa, const PatchPlace& at, Patch& patch) {
  const double floor = std::min(at.surface_m, patch.floor_m);
  const double pressed = floor + patch.ride_m - at.z_m;
  if (pressed <= 0.0) return 0.0;
  const double elastic = laws.elastic_pa_per_m * pressed;
  if (elastic >= yield_pa) {
    patch.floor_m = at.z_m + yield_pa / laws.elastic_pa_per_m - patch.ride_m;
    return yield_pa;
  }
  patch.floor_m = floor;
  // Yielding soil dissipates by itself; damping is for the elastic rest, and never pulls.
  const double damped = elastic + laws.damping_pa_s_per_m * at.v.r;
  return std::clamp(damped, 0.0, std::min(2.0 * elastic, yield_pa));
}

}  // namespace

SpokeLoad LoadPatch(const SoilLaws& laws, const WheelTravel& travel, double contact_depth_m,
                    const PatchPlace& at, double area_m2, double dt_s, Patch& patch) {
  const double into = at.v.r * dt_s, slide_t = at.v.t * dt_s, slide_a = at.v.a * dt_s;
  const double slide2 = slide_t * slide_t + slide_a * slide_a;
  if (patch.floor_m < kNoFloor_m) {
    const double ride = kRide_m * std::max(travel.resting, 1e-6);
    const double keep = Decay(std::sqrt(slide2) / ride);
    patch.ride_m = keep * (patch.ride_m + at.climb_m_s * dt_s);
  }
  const double sinkage = at.sinkage_m();
  double pressure = 0.0;
  if (sinkage > 0.0) {
    const double depth = sinkage - travel.excavated_m;
    const double strength = std::max(YieldPressure(laws, depth), BladePressure(laws, sinkage));
    const double share = BearingShare(laws, patch.into, DrivingShare(patch.shear, travel.going.t));
    pressure = Pressure(laws, share * strength, at, patch);
  }
  if (pressure <= 0.0) {
    // Lifted off its own floor, a patch forgets only once it is clear of the rut as well.
    if (at.z_m >= at.surface_m || sinkage <= 0.0) patch = {};
    return {};
  }
  const double way = std::sqrt(slide2 + into * into);
  if (way > 0.0) {
    const double keep = Decay(way / (kDirectionMemory * contact_depth_m));
    patch.into = patch.into * keep + (1.0 - keep) * into / way;
  }
  const double shear_modulus_m = ShearModulus(laws, contact_depth_m);
  patch.shear = Shear(patch.shear, slide_t, slide_a, shear_modulus_m);
  const double lead = kShearLead_s * (1.0 + travel.resting) / shear_modulus_m;
  const Mobilisation m = LedBy(patch.shear, at.v.t, at.v.a, lead);
  const double driving = laws.tan_caught > 0.0 ? DrivingShare(patch.shear, travel.going.t) : 0.0;
  const double strength = area_m2 * ShearStrength(laws, pressure, driving);
  return {-area_m2 * pressure, -strength * m.t, -strength * m.a};
}

}  // namespace dockyard
