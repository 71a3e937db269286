// Light of the sun and the sky through an air of some optical depth.
#pragma once

namespace dockyard {

/// Path through the air over that at the zenith. F. Kasten and A. T. Young, Applied Optics 28, 4735
/// (1989), for the Earth's air; 1 / sin(elevation) within 1 % above 14 deg. elevation_rad >= 0.
double AirMass(double elevation_rad);

/// Irradiances over that of the sun outside the air.
struct AirLight {
  double sun = 0.0;  // on a surface that faces the sun: exp(-depth AirMass)
  double sky = 0.0;  // on a level surface, from the whole sky
};
/// Sun and sky over a black ground. The sky has what the air scatters down: the delta-Eddington
/// solution for one layer less the direct light. J. H. Joseph, W. J. Wiscombe and J. A. Weinman, J.
/// Atmos. Sci. 33, 2452 (1976), as closed form of W. E. Meador and W. R. Weaver, J. Atmos. Sci. 37,
/// 630 (1980), eq. 15. depth >= 0.
AirLight LightThroughAir(double depth, double elevation_rad);
/// The same total on a level surface over that outside, for a cosine of the sun's zenith angle, an
/// albedo of single scattering below 1 and an asymmetry of scattering.
double TotalTransmission(double depth, double cosine, double albedo, double asymmetry);

/// The sun's irradiance outside the air in units of the renderer: 1361 W/m2. The clear sky of
/// `hard_shadow` has 1.3 and 0.22, some 930 and 160 W/m2. Assumed, 1.7-2.2.
inline constexpr double kOutsideIrradiance = 1.9;

}  // namespace dockyard
