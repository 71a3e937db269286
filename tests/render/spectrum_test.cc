// Spectra against published tables, and the colours of RAPOSA's kind of marks under four lights.
#include "render/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/blackbody.h"

namespace dockyard {
namespace {

double At(const Spectrum& s, double nm) {
  return s.values[static_cast<std::size_t>(std::lround((nm - kFirstBand_nm) / kBand_nm))];
}

double Bell(double nm, double middle, double below, double above) {
  const double u = (nm - middle) / (nm < middle ? below : above);
  return std::exp(-0.5 * u * u);
}

// CIE 1931 by the fit of Wyman, Sloan and Shirley (Journal of Computer Graphics Techniques 2,
// 2013), multi-lobe.
Eigen::Vector3d Xyz(const Spectrum& power) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < kBands; ++i) {
    const double nm = Spectrum::Wavelength_nm(i);
    sum +=
        power.values[i] *
        Eigen::Vector3d(1.056 * Bell(nm, 599.8, 37.9, 31.0) + 0.362 * Bell(nm, 442.0, 16.0, 26.7) -
                            0.065 * Bell(nm, 501.1, 20.4, 26.2),
                        0.821 * Bell(nm, 568.8, 46.9, 40.5) + 0.286 * Bell(nm, 530.9, 16.3, 31.1),
                        1.217 * Bell(nm, 437.0, 11.8, 36.0) + 0.681 * Bell(nm, 459.0, 26.0, 13.8));
  }
  return sum;
}

Eigen::Vector2d Chromaticity(const Spectrum& power) {
  const Eigen::Vector3d xyz = Xyz(power);
  return xyz.head<2>() / xyz.sum();
}

// CIE 15: relative power of D65.
TEST(Daylight, IsThePublishedD65) {
  const Spectrum d65 = DaylightLight(6504.0);
  const double at_560 = At(d65, 560.0);
  const std::pair<double, double> kTable[] = {{400, 82.755},  {450, 117.008}, {500, 109.354},
                                              {550, 104.046}, {600, 90.006},  {650, 80.027},
                                              {700, 71.609}};
  for (const auto& [nm, power] : kTable) {
    EXPECT_NEAR(100.0 * At(d65, nm) / at_560, power, 0.15) << nm;
  }
  EXPECT_DEATH(DaylightLight(3900.0), "check failed");
}

// CIE 15: relative power of illuminant A, a black body at 2856 K.
TEST(Planck, IsThePublishedIlluminantA) {
  const Spectrum a = PlanckLight(2856.0);
  const std::pair<double, double> kTable[] = {{400, 14.708}, {450, 33.086},  {500, 59.861},
                                              {550, 92.912}, {600, 129.043}, {650, 165.028},
                                              {700, 198.261}};
  for (const auto& [nm, power] : kTable) {
    EXPECT_NEAR(100.0 * At(a, nm) / At(a, 560.0), power, 0.002 * power) << nm;
  }
}

TEST(Planck, HasTheChromaticityOfItsLocus) {
  for (const double t : {3000.0, 4000.0, 5000.0, 6500.0}) {
    EXPECT_LT((Chromaticity(PlanckLight(t)) - BlackbodyChromaticity(t)).norm(), 0.004) << t;
  }
}

// McCamy 1992: correlated colour temperature from the chromaticity.
TEST(WhiteDiode, IsAboutAsBlueAsItIsSaidToBe) {
  const auto temperature = [](double blue) {
    const Eigen::Vector2d xy = Chromaticity(WhiteDiodeLight(blue));
    const double n = (xy.x() - 0.3320) / (0.1858 - xy.y());
    return ((449.0 * n + 3525.0) * n + 6823.3) * n + 5520.33;
  };
  EXPECT_NEAR(temperature(1.8), 6000.0, 300.0);
  EXPECT_LT(temperature(1.4), temperature(1.8));
  EXPECT_GT(temperature(2.4), temperature(1.8));
}

// Linear sRGB of the paints in daylight, as the reference has it.
TEST(Paints, HaveTheLinearColoursOfTheReference) {
  Eigen::Matrix3d rgb_from_xyz;  // IEC 61966-2-1
  rgb_from_xyz << 3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570;
  const Spectrum day = DaylightLight(6504.0);
  const Eigen::Vector3d white = rgb_from_xyz * Xyz(day);
  const std::pair<Spectrum, Eigen::Vector3d> kTable[] = {
      {OrangePaint(), {0.71, 0.12, 0.02}},   {BluePaint(), {0.01, 0.09, 0.34}},
      {FloorCovering(), {0.32, 0.25, 0.20}}, {Soil(), {0.22, 0.13, 0.09}},
      {Grass(), {0.05, 0.10, 0.04}},         {Brick(), {0.33, 0.10, 0.06}}};
  for (const auto& [paint, rgb] : kTable) {
    Spectrum reflected = day;
    for (int i = 0; i < kBands; ++i) reflected.values[i] *= paint.values[i];
    const Eigen::Vector3d seen = (rgb_from_xyz * Xyz(reflected)).cwiseQuotient(white);
    EXPECT_LT((seen - rgb).cwiseAbs().maxCoeff(), 0.03) << seen.transpose();
  }
}

struct Hsv {
  double hue_deg, saturation;
};
Hsv ToHsv(const Eigen::Vector3d& rgb) {
  const double most = rgb.maxCoeff(), span = most - rgb.minCoeff();
  if (span < 1e-9) return {0.0, 0.0};
  double hue = 0.0;
  if (most == rgb.x()) {
    hue = (rgb.y() - rgb.z()) / span;
  } else if (most == rgb.y()) {
    hue = 2.0 + (rgb.z() - rgb.x()) / span;
  } else {
    hue = 4.0 + (rgb.x() - rgb.y()) / span;
  }
  return {std::fmod(60.0 * hue + 360.0, 360.0), span / most};
}

Eigen::Vector2d LogChromaticity(const Eigen::Vector3d& rgb) {
  return {std::log(rgb.x() / rgb.y()), std::log(rgb.z() / rgb.y())};
}

/// A camera balanced for 5000 K sees this under a black body's light.
Eigen::Vector3d Balanced(double temperature_k, const Spectrum& paint) {
  const CameraResponse camera = CheapCamera();
  return ColourOf(PlanckLight(temperature_k), paint, camera)
      .cwiseProduct(BalanceFor(PlanckLight(5000.0), camera));
}

struct TableRow {
  double temperature_k;
  Hsv orange, blue, grey;
  Eigen::Vector2d orange_xy, blue_xy, grey_xy;
};
// docs: raposa.md, 5.3. Rows that a black body at that temperature gives.
const TableRow kColourTable[] = {
    {3000, {17, 0.97}, {223, 0.52}, {32, 0.60}, {1.18, -2.19}, {-0.26, 0.48}, {0.33, -0.59}},
    {4000, {18, 0.94}, {224, 0.73}, {36, 0.29}, {1.06, -1.72}, {-0.54, 0.77}, {0.13, -0.22}},
    {5000, {19, 0.91}, {225, 0.81}, {0, 0.00}, {0.99, -1.43}, {-0.72, 0.94}, {0, 0}},
    {6500, {19, 0.87}, {226, 0.86}, {220, 0.27}, {0.92, -1.16}, {-0.87, 1.09}, {-0.12, 0.20}}};

void ExpectColour(double temperature_k, const char* name, const Spectrum& paint, const Hsv& hsv,
                  const Eigen::Vector2d& xy) {
  const Eigen::Vector3d rgb = Balanced(temperature_k, paint);
  const Hsv seen = ToHsv(rgb);
  std::printf("%.0f K %-6s H %5.1f S %.3f x %.3f y %.3f\n", temperature_k, name, seen.hue_deg,
              seen.saturation, LogChromaticity(rgb).x(), LogChromaticity(rgb).y());
  if (hsv.saturation > 0.05) {
    EXPECT_NEAR(seen.hue_deg, hsv.hue_deg, 2.0) << name;
  }
  EXPECT_NEAR(seen.saturation, hsv.saturation, 0.02) << name << temperature_k;
  EXPECT_LT((LogChromaticity(rgb) - xy).cwiseAbs().maxCoeff(), 0.03) << name << temperature_k;
}

TEST(Marks, HaveTheColoursOfTheReference) {
  for (const TableRow& row : kColourTable) {
    ExpectColour(row.temperature_k, "orange", OrangePaint(), row.orange, row.orange_xy);
    ExpectColour(row.temperature_k, "blue", BluePaint(), row.blue, row.blue_xy);
    ExpectColour(row.temperature_k, "grey", EvenGrey(0.5), row.grey, row.grey_xy);
  }
}

// Under a product of colours every surface's (x, y) moves by the same with the light, and the
// difference of two paints stands still.
TEST(Marks, DifferAsNoProductOfColoursHasIt) {
  const auto difference = [](double temperature_k) -> Eigen::Vector2d {
    return LogChromaticity(Balanced(temperature_k, OrangePaint())) -
           LogChromaticity(Balanced(temperature_k, BluePaint()));
  };
  const auto product = [](double temperature_k) -> Eigen::Vector2d {
    const Eigen::Vector3d light = Balanced(temperature_k, EvenGrey(1.0));
    const auto seen = [&](const Spectrum& paint) {
      return LogChromaticity(light.cwiseProduct(Balanced(5000.0, paint)));
    };
    return seen(OrangePaint()) - seen(BluePaint());
  };
  const Eigen::Vector2d change = (difference(6500) - difference(3000)).cwiseAbs();
  std::printf("orange - blue changes by %.3f, %.3f\n", change.x(), change.y());
  EXPECT_GE(change.minCoeff(), 0.3);
  EXPECT_LE(change.maxCoeff(), 0.5);
  EXPECT_LT((product(6500) - product(3000)).norm(), 1e-12);
}

TEST(Light, OffAGreySurfaceIsDimmerAndOtherwiseTheSame) {
  const CameraResponse camera = CheapCamera();
  const Spectrum light = WhiteDiodeLight();
  const Eigen::Vector3d direct = ColourOf(light, BluePaint(), camera);
  const Eigen::Vector3d off = ColourOff(light, EvenGrey(0.4), BluePaint(), camera);
  EXPECT_LT((off - 0.4 * direct).norm(), 1e-12);
  // Off brick the same paint is redder than off grey, and not by the product of both colours.
  const Eigen::Vector3d red = ColourOff(light, Brick(), BluePaint(), camera);
  EXPECT_GT(red.x() / red.z(), 1.5 * off.x() / off.z());
}

}  // namespace
}  // namespace dockyard
