#include "sim/soil/patch.h"

#include <algorithm>

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

template <typename Real>
MobilisationOf<Real> LedBy(const MobilisationOf<Real>& m, Real v_t, Real v_a, double lead) {
  const MobilisationOf<Real> led{m.t + lead * v_t, m.a + lead * v_a};
  const Real scale = 1.0 / Sqrt(Max(led.t * led.t + led.a * led.a, Real(1.0)));
  return {led.t * scale, led.a * scale};
}

/// Share of a patch's sliding that drives the wheel on its way, 0..1.
template <typename Real>
Real DrivingShare(const MobilisationOf<Real>& m, double going) {
  const Real drive = Max(m.t * going, Real(0.0));
  return drive * drive / (m.t * m.t + m.a * m.a + 1e-3);  // some per cent of mobilisation count
}

/// Elastic from the floor, limited by yield, which lowers the floor [Pa].
template <typename Real>
Real Pressure(const SoilLaws& laws, Real yield_pa, const PatchPlaceOf<Real>& at,
              PatchOf<Real>& patch) {
  const Real floor = Min(at.surface_m, patch.floor_m);
  const Real pressed = floor + patch.ride_m - at.z_m;
  const Real elastic = laws.elastic_pa_per_m * pressed;
  const auto touches = pressed > 0.0;
  const auto yields = touches & (elastic >= yield_pa);
  const Real lowered = at.z_m + yield_pa * (1.0 / laws.elastic_pa_per_m) - patch.ride_m;
  patch.floor_m = Select(yields, lowered, Select(touches, floor, patch.floor_m));
  // Yielding soil dissipates by itself; damping is for the elastic rest, and never pulls.
  const Real damped = elastic + laws.damping_pa_s_per_m * at.v.r;
  const Real rest = Max(Min(damped, Min(2.0 * elastic, yield_pa)), Real(0.0));
  return Select(yields, yield_pa, Select(touches, rest, Real(0.0)));
}

}  // namespace

template <typename Real>
SpokeLoadOf<Real> LoadPatch(const SoilLaws& laws, const WheelTravel& travel, double contact_depth_m,
                            const PatchPlaceOf<Real>& at, double area_m2, double dt_s,
                            PatchOf<Real>& patch) {
  const Real sinkage = at.sinkage_m();
  const auto sunk = sinkage > 0.0;
  if (!Any(sunk)) {
    patch = {};
    return {};
  }
  const Real into = at.v.r * dt_s, slide_t = at.v.t * dt_s, slide_a = at.v.a * dt_s;
  const Real slide2 = slide_t * slide_t + slide_a * slide_a;
  const double per_ride_m = 1.0 / (kRide_m * std::max(travel.resting, 1e-6));
  const Real ridden = Decay<Real>(Sqrt(slide2) * per_ride_m) * (patch.ride_m + at.climb_m_s * dt_s);
  patch.ride_m = Select(patch.floor_m < kNoFloor_m, ridden, patch.ride_m);

  const Real depth = sinkage - travel.excavated_m;
  const Real soil_pa = Max(YieldPressure(laws, depth), BladePressure(laws, sinkage));
  const Real share = BearingShare(laws, patch.into, DrivingShare(patch.shear, travel.going.t));
  const Real yield_pa = Select(sunk, share * soil_pa, Real(0.0));
  const Real pressure = Select(sunk, Pressure(laws, yield_pa, at, patch), Real(0.0));
  const auto pressed = pressure > 0.0;

  PatchOf<Real> on = patch;
  const double per_memory_m = 1.0 / (kDirectionMemory * contact_depth_m);
  const Real way = per_memory_m * Sqrt(slide2 + into * into);
  on.into = Decay(way) * (patch.into + per_memory_m * Gain(way) * into);
  const double shear_modulus_m = ShearModulus(laws, contact_depth_m);
  on.shear = Shear(patch.shear, slide_t, slide_a, shear_modulus_m);
  Put<Real>(pressed, on, patch);
  // Lifted off its own floor, a patch forgets only once it is clear of the rut as well.
  const auto clear = (at.z_m >= at.surface_m) | (sinkage <= 0.0);
  Put<Real>((pressure <= 0.0) & clear, {}, patch);

  const double lead = kShearLead_s * (1.0 + travel.resting) / shear_modulus_m;
  const MobilisationOf<Real> m = LedBy(on.shear, at.v.t, at.v.a, lead);
  const Real driving = laws.tan_caught > 0.0 ? DrivingShare(on.shear, travel.going.t) : Real(0.0);
  const Real strength = area_m2 * ShearStrength(laws, pressure, driving);
  return {-area_m2 * pressure, -(strength * m.t), -(strength * m.a)};
}

template SpokeLoad LoadPatch(const SoilLaws&, const WheelTravel&, double, const PatchPlace&, double,
                             double, Patch&);
template SpokeLoadOf<Four> LoadPatch(const SoilLaws&, const WheelTravel&, double,
                                     const PatchPlaceOf<Four>&, double, double, PatchOf<Four>&);

}  // namespace dockyard
