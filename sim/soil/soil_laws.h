// Laws of one small patch of soil: pressure by sinkage and direction, shear by displacement,
// passive pressure on faces and sides. docs/reference/soil.md gives the equations with their
// sources.
#pragma once

#include <cmath>
#include <type_traits>

#include "models/parts/soil_model.h"
#include "sim/soil/four.h"

namespace dockyard {

/// Friction angle of soil on a wall or a wheel's metal over its own: two thirds (Terzaghi 1943),
/// range 0.6-0.8.
inline constexpr double kWallFriction = 2.0 / 3.0;

/// A soil's constants as the laws use them, for patches of one size.
struct SoilLaws {
  double k = 0.0;  // k_c / b + k_phi, of the wheel's width [N/m^(n+2)]
  double n = 1.0;
  double elastic_pa_per_m = 0.0;  // of unloading and reloading
  double damping_pa_s_per_m = 0.0;
  double weakening = 0.0;  // 0..1, how much a sliding patch loses of its bearing
  double cohesion_pa = 0.0, tan_phi = 0.0;
  double tan_rim = 0.0;            // friction of soil on a wheel's metal
  double tan_caught = 0.0;         // what driving adds where soil caught by paddles slides on soil
  double shear_over_depth = 0.0;   // K over the contact's depth
  double plate_over_blade = 0.0;   // the wheel's width over its paddles' thickness
  double blade_strength_pa = 0.0;  // bearing strength of a narrow blade at the surface
  double blade_strength_pa_m = 0.0;  // and its growth with depth
  double passive_pa_per_m = 0.0;     // gamma N_phi
  double passive_pa = 0.0;           // 2 c sqrt(N_phi)
  double sqrt_n_phi = 1.0;           // tan(45 deg + phi/2)
  double bulldoze_n_per_m3 = 0.0;    // per length and squared depth
};

/// Laws for the rim: a plate whose smaller side is plate_width_m.
SoilLaws MakeRimLaws(const SoilModel& soil, double plate_width_m);
/// Laws for a paddle's tip, a blade of this thickness on a wheel of this width.
SoilLaws MakeTipLaws(const SoilModel& soil, double thickness_m, double width_m);

/// Powers are taken of no less.
inline constexpr double kLeastSinkage_m = 1e-30;

/// Pressure that yields soil at this sinkage under a plate (Bekker 1969): k z^n [Pa]; 0 for z <= 0.
template <typename Real>
Real YieldPressure(const SoilLaws& laws, Real sinkage_m) {
  const Real pressure_pa = laws.k * Power(Max(sinkage_m, Real(kLeastSinkage_m)), laws.n);
  return Select(sinkage_m > 0.0, pressure_pa, Real(0.0));
}

/// Pressure that yields soil under a narrow blade: a hyperbola (Kondner 1963) that begins as a wide
/// plate's curve at the same sinkage over width and ends at the blade's bearing strength [Pa]. Zero
/// for laws that are not a tip's.
template <typename Real>
Real BladePressure(const SoilLaws& laws, Real sinkage_m) {
  if (laws.blade_strength_pa_m == 0.0) return 0.0;
  const Real sunk_m = Max(sinkage_m, Real(kLeastSinkage_m));
  const Real strength = laws.blade_strength_pa + laws.blade_strength_pa_m * sunk_m;
  const Real plate = YieldPressure<Real>(laws, sunk_m * laws.plate_over_blade);
  return Select(sinkage_m > 0.0, strength * plate / (strength + plate), Real(0.0));
}

/// A contact shallower than this counts as one so deep: shear bands are some ten grains thick
/// however thin the layer. Assumed, range 1-5 mm.
inline constexpr double kLeastDepth_m = 0.003;

/// Depth to which a contact presses soil down, as the lengths below count it.
inline double ContactDepth(double pressed_m) { return std::fmax(pressed_m, kLeastDepth_m); }

/// Share of the straight-in pressure that a driving patch, which slides back along the soil, still
/// bears. Fitted to the single-wheel data (docs/results/soil.md): 0.30, range 0.21-0.35.
constexpr double kDrivingShare = 0.30;
/// Share of it that any sliding patch still bears. Keeps a wheel dragged sideways from sinking
/// without end; the data up to 45 deg of side slip do not need it. Assumed, range 0-0.02.
constexpr double kDraggedShare = 0.005;
/// Distance over which a patch's direction is remembered, over the contact's depth. Fitted
/// likewise: 0.55, range 0.4-1.1.
constexpr double kDirectionMemory = 0.55;

/// Share of the yield pressure that soil bears under a patch whose motion has the direction cosine
/// `into` with its inward normal: all of it going straight in, less along the surface, as plates
/// pushed through sand in all directions show (Li, Zhang and Goldman 2013). `driving` (0..1) is the
/// share of the sliding that drives the wheel on.
template <typename Real>
Real BearingShare(const SoilLaws& laws, Real into, Real driving) {
  const Real along = kDraggedShare + (kDrivingShare - kDraggedShare) * driving;
  const Real in = Max(into, Real(0.0));
  return 1.0 - laws.weakening * (1.0 - along) * (1.0 - in * in);
}

/// Shear strength of soil on the wheel (Mohr and Coulomb). Cohesion needs contact: it counts only
/// up to the pressure, so the strength falls continuously to zero where a patch leaves the soil.
/// `driving` (0..1): a driving wheel takes the soil between its paddles along, so that it slides on
/// soil; when dragged, the soil stays and the rim slides under it.
template <typename Real>
Real ShearStrength(const SoilLaws& laws, Real pressure_pa,
                   std::type_identity_t<Real> driving = 0.0) {
  return Min(Real(laws.cohesion_pa), pressure_pa) +
         pressure_pa * (laws.tan_rim + driving * laws.tan_caught);
}

/// K of a contact this deep. The layer that shears is as thick as the contact is deep. So wheels of
/// all sizes roll alike, as measured pairs do (Slonaker et al. 2017), and a light wide wheel grips
/// at less slip (Ding et al. 2011; docs/results/soil.md).
inline double ShearModulus(const SoilLaws& laws, double contact_depth_m) {
  return laws.shear_over_depth * contact_depth_m;
}

/// exp(-x) to third order, bounded by 1 for every x >= 0.
template <typename Real>
Real Decay(Real x) {
  return 1.0 / (1.0 + x * (1.0 + 0.5 * x));
}
/// (1 - Decay(x)) / (x Decay(x)): what the part that is not kept makes of a way, without dividing
/// by the way.
template <typename Real>
Real Gain(Real x) {
  return 1.0 + 0.5 * x;
}

/// Share of the shear strength that is mobilised, a vector of length <= 1 in the patch's plane.
/// Under steady sliding it is Janosi and Hanamoto's 1 - exp(-j / K) along j; on reversal it first
/// unloads at up to twice the virgin stiffness, as sheared soil does (Wong and Preston-Thomas
/// 1983); at rest it stays. As an equation: dm = (dj - m |dj|) / K (the form of Dahl's friction).
template <typename Real>
struct MobilisationOf {
  Real t = 0.0, a = 0.0;  // along the wheel's turn, along the axle

  bool operator==(const MobilisationOf&) const = default;
};
using Mobilisation = MobilisationOf<double>;

template <typename Real>
MobilisationOf<Real> Shear(const MobilisationOf<Real>& m, std::type_identity_t<Real> slide_t_m,
                           std::type_identity_t<Real> slide_a_m, double shear_modulus_m) {
  const Real slide_m = Sqrt(slide_t_m * slide_t_m + slide_a_m * slide_a_m);
  const Real keep = Decay(slide_m * (1.0 / shear_modulus_m));
  const Real gain = (1.0 - keep) / Max(slide_m, Real(1e-300));
  return {keep * m.t + gain * slide_t_m, keep * m.a + gain * slide_a_m};
}

/// The same along a line.
inline double Shear(double m, double slide_m, double shear_modulus_m) {
  const double keep = Decay(std::fabs(slide_m) / shear_modulus_m);
  return m * keep + std::copysign(1.0 - keep, slide_m);
}

/// Resistance of a short wall that heaps soil before it, a paddle's face or a wheel's side, over
/// that of a long wall without a heap. Fitted to the single-wheel data (docs/results/soil.md): 4.8,
/// range 3-5.5; tines a few depths wide show 2-4 (McKyes 1985). It multiplies only the resistance
/// by the soil's weight: a heap is a surcharge of loose soil, and has no cohesion.
constexpr double kHeap = 4.8;

/// Passive earth pressure on a paddle's face at this depth: Rankine's gamma z N_phi +
/// 2 c sqrt(N_phi) [Pa], the first part with the heap. `driving` (0..1): a driving paddle cuts and
/// heaps soil that rests; a dragged one (0) is in loosened soil that goes along with the wheel.
template <typename Real>
Real FacePressure(const SoilLaws& laws, Real depth_m, Real driving) {
  const Real heap = 1.0 + (kHeap - 1.0) * driving;
  return heap * laws.passive_pa_per_m * depth_m + driving * laws.passive_pa;
}

/// Bulldozing resistance of a wheel's side per length of rut (Wong 2008, after Hegedus), its
/// weight's part with the heap [N/m].
template <typename Real>
Real BulldozingResistance(const SoilLaws& laws, Real depth_m) {
  return depth_m * (kHeap * laws.bulldoze_n_per_m3 * depth_m + laws.passive_pa);
}

}  // namespace dockyard
