// Spectra of light, of materials and of a camera, and what the camera makes of one under another:
// the sum over the spectrum, not the product of colours, so that two colours that match under one
// light differ under the next. Plain arithmetic.
#pragma once

#include <Eigen/Core>
#include <array>

namespace dockyard {

/// Values at 360, 365, ... 780 nm.
inline constexpr int kBands = 85;
inline constexpr double kFirstBand_nm = 360.0, kBand_nm = 5.0;
struct Spectrum {
  std::array<double, kBands> values{};

  static double Wavelength_nm(int band) { return kFirstBand_nm + kBand_nm * band; }
  template <typename Law>  // value at a wavelength in nm
  static Spectrum From(const Law& law) {
    Spectrum spectrum;
    for (int i = 0; i < kBands; ++i) spectrum.values[i] = law(Wavelength_nm(i));
    return spectrum;
  }
  bool operator==(const Spectrum&) const = default;
};

// Light: power per wavelength, of any scale.

/// A black body's (Planck). Lamps with filaments 2700-3000 K, warm ones up to 4000 K.
Spectrum PlanckLight(double temperature_k);
/// Daylight of the CIE's D series, 4000 to 25000 K (CIE 15; Judd, MacAdam and Wyszecki 1964).
/// D65 is that of 6504 K.
Spectrum DaylightLight(double temperature_k);
/// A white light diode: a blue line at 450 nm, 20 nm wide at half its height (assumed, 445-460 and
/// 18-30), and a phosphor's broad yellow at 560 nm, 120 nm wide (assumed, 545-570 and 100-140).
/// blue: height of the line over that of the yellow; 1.8 is close to 6000 K (assumed, 1.4-2.4).
Spectrum WhiteDiodeLight(double blue = 1.8);

// Reflectances, 0 to 1, of matt surfaces. All assumed; the shapes are those of such pigments and
// soils in general, the numbers may be off by a fifth.

Spectrum OrangePaint();
Spectrum BluePaint();
Spectrum FloorCovering();  // light, warm vinyl or wood
Spectrum Brick();
Spectrum Soil();
Spectrum Grass();
Spectrum Denim();       // blue jeans
Spectrum ConeOrange();  // plastic of a traffic cone: redder than OrangePaint
Spectrum EvenGrey(double reflectance);

/// Share of the photons of a wavelength that a channel counts, red, green, blue; of any scale.
struct CameraResponse {
  std::array<Spectrum, 3> channels;
};
/// Gaussians at 600, 540 and 460 nm, sigma 35, 38, 30 nm: a cheap camera behind an infrared filter.
/// All assumed; middles shift by up to 10 nm between cameras.
CameraResponse CheapCamera(const Eigen::Vector3d& shift_nm = {0.0, 0.0, 0.0});

/// Red, green and blue of the camera for a surface in this light: sums over photons, so over power
/// times wavelength, without any balance. Scaled so that the green of a white surface (reflectance
/// 1) is 1: light is measured in the camera's green.
Eigen::Vector3d ColourOf(const Spectrum& light, const Spectrum& reflectance,
                         const CameraResponse& camera);
/// The same after the light came off another surface first, not scaled anew: what is lost there is
/// missing here.
Eigen::Vector3d ColourOff(const Spectrum& light, const Spectrum& first, const Spectrum& second,
                          const CameraResponse& camera);

/// Gains of the channels that make white under a light equal in all three; green's is 1.
Eigen::Vector3d BalanceFor(const Spectrum& light, const CameraResponse& camera);

}  // namespace dockyard
