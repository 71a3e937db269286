#include "render/spectrum.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"

namespace dockyard {
namespace {

// Mean and first two components of daylight at 360, 370, ... 780 nm (CIE 15, table of the D
// series).
struct DayBand {
  double s0, s1, s2;
};
constexpr DayBand kDay[] = {
    {61.5, 38.0, 5.3},   {68.8, 42.4, 6.1},   {63.4, 38.5, 3.0},   {65.8, 35.0, 1.2},
    {94.8, 43.4, -1.1},  {104.8, 46.3, -0.5}, {105.9, 43.9, -0.7}, {96.8, 37.1, -1.2},
    {113.9, 36.7, -2.6}, {125.6, 35.9, -2.9}, {125.5, 32.6, -2.8}, {121.3, 27.9, -2.6},
    {121.3, 24.3, -2.6}, {113.5, 20.1, -1.8}, {113.1, 16.2, -1.5}, {110.8, 13.2, -1.3},
    {106.5, 8.6, -1.2},  {108.8, 6.1, -1.0},  {105.3, 4.2, -0.5},  {104.4, 1.9, -0.3},
    {100.0, 0.0, 0.0},   {96.0, -1.6, 0.2},   {95.1, -3.5, 0.5},   {89.1, -3.5, 2.1},
    {90.5, -5.8, 3.2},   {90.3, -7.2, 4.1},   {88.4, -8.6, 4.7},   {84.0, -9.5, 5.1},
    {85.1, -10.9, 6.7},  {81.9, -10.7, 7.3},  {82.6, -12.0, 8.6},  {84.9, -14.0, 9.8},
    {81.3, -13.6, 10.2}, {71.9, -12.0, 8.3},  {74.3, -13.3, 9.6},  {76.4, -12.9, 8.5},
    {63.3, -10.6, 7.0},  {71.7, -11.6, 7.6},  {77.0, -12.2, 8.0},  {65.2, -10.2, 6.7},
    {47.7, -7.8, 5.2},   {68.6, -11.2, 7.4},  {65.0, -10.4, 6.8}};

double Gaussian(double at, double middle, double sigma) {
  const double u = (at - middle) / sigma;
  return std::exp(-0.5 * u * u);
}

// From low to low + rise round a middle, by the logistic function.
Spectrum Edge(double low, double rise, double middle_nm, double width_nm) {
  return Spectrum::From(
      [&](double nm) { return low + rise / (1.0 + std::exp(-(nm - middle_nm) / width_nm)); });
}

Eigen::Vector3d PhotonSums(const CameraResponse& camera, const auto& power) {
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  for (int i = 0; i < kBands; ++i) {
    const double photons = power(i) * Spectrum::Wavelength_nm(i);
    for (int c = 0; c < 3; ++c) sums[c] += photons * camera.channels[c].values[i];
  }
  return sums;
}

double GreenOfWhite(const Spectrum& light, const CameraResponse& camera) {
  return PhotonSums(camera, [&](int i) { return light.values[i]; }).y();
}

}  // namespace

Spectrum PlanckLight(double temperature_k) {
  constexpr double kSecond_nm_k = 1.438777e7;  // h c / k
  return Spectrum::From([&](double nm) {
    return std::pow(nm / 560.0, -5.0) / std::expm1(kSecond_nm_k / (nm * temperature_k)) *
           std::expm1(kSecond_nm_k / (560.0 * temperature_k));
  });
}

Spectrum DaylightLight(double t) {
  DOCKYARD_CHECK(t >= 4000.0 && t <= 25000.0);
  const double u = 1e3 / t;
  const double x = t <= 7000.0 ? ((-4.6070 * u + 2.9678) * u + 0.09911) * u + 0.244063
                               : ((-2.0064 * u + 1.9018) * u + 0.24748) * u + 0.237040;
  const double y = (-3.000 * x + 2.870) * x - 0.275;
  const double per = 1.0 / (0.0241 + 0.2562 * x - 0.7341 * y);
  const double m1 = per * (-1.3515 - 1.7703 * x + 5.9114 * y);
  const double m2 = per * (0.0300 - 31.4424 * x + 30.0717 * y);
  return Spectrum::From([&](double nm) {
    const double at = (nm - 360.0) / 10.0;
    const int i = std::min(static_cast<int>(at), 41);
    const auto value = [&](const DayBand& d) { return d.s0 + m1 * d.s1 + m2 * d.s2; };
    return value(kDay[i]) + (at - i) * (value(kDay[i + 1]) - value(kDay[i]));
  });
}

Spectrum WhiteDiodeLight(double blue) {
  constexpr double kPerHalfWidth = 1.0 / 2.354820045;  // sigma of a full width at half height
  return Spectrum::From([&](double nm) {
    return blue * Gaussian(nm, 450.0, 20.0 * kPerHalfWidth) +
           Gaussian(nm, 560.0, 120.0 * kPerHalfWidth);
  });
}

Spectrum OrangePaint() { return Edge(0.04, 0.56, 575.0, 12.0); }
Spectrum BluePaint() {
  return Spectrum::From([](double nm) { return 0.05 + 0.30 * Gaussian(nm, 460.0, 38.0); });
}
Spectrum FloorCovering() { return Edge(0.18, 0.16, 560.0, 60.0); }
Spectrum Brick() { return Edge(0.07, 0.28, 590.0, 20.0); }
Spectrum Soil() { return Edge(0.08, 0.17, 580.0, 50.0); }
Spectrum Grass() {
  return Spectrum::From([](double nm) { return 0.04 + 0.08 * Gaussian(nm, 550.0, 30.0); });
}
Spectrum Denim() {
  return Spectrum::From([](double nm) { return 0.05 + 0.11 * Gaussian(nm, 455.0, 48.0); });
}
Spectrum ConeOrange() { return Edge(0.04, 0.62, 592.0, 10.0); }
Spectrum EvenGrey(double reflectance) {
  return Spectrum::From([&](double) { return reflectance; });
}

CameraResponse CheapCamera(const Eigen::Vector3d& shift_nm) {
  const auto channel = [](double middle_nm, double sigma_nm) {
    return Spectrum::From([&](double nm) { return Gaussian(nm, middle_nm, sigma_nm); });
  };
  return {{channel(600.0 + shift_nm.x(), 35.0), channel(540.0 + shift_nm.y(), 38.0),
           channel(460.0 + shift_nm.z(), 30.0)}};
}

Eigen::Vector3d ColourOf(const Spectrum& light, const Spectrum& reflectance,
                         const CameraResponse& camera) {
  return PhotonSums(camera, [&](int i) { return light.values[i] * reflectance.values[i]; }) /
         GreenOfWhite(light, camera);
}

Eigen::Vector3d ColourOff(const Spectrum& light, const Spectrum& first, const Spectrum& second,
                          const CameraResponse& camera) {
  return PhotonSums(camera,
                    [&](int i) { return light.values[i] * first.values[i] * second.values[i]; }) /
         GreenOfWhite(light, camera);
}

Eigen::Vector3d BalanceFor(const Spectrum& light, const CameraResponse& camera) {
  const Eigen::Vector3d white = ColourOf(light, EvenGrey(1.0), camera);
  return white.y() * white.cwiseInverse();
}

}  // namespace dockyard
