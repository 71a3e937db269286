// Compact soil carries the paddles on their tips, so that the rover rocks from side to side and its
// heading swings; loose sand takes the paddles in (Tsai et al., V-B). scripts/rocking_plot draws
// it.
#include "axel/sim/rocking.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>

#include "axel/sim/product.h"

namespace dockyard::axel {
namespace {

TEST(Spectrum, GivesAToneItsHalfSquareAndAllOfItTheRms) {
  std::vector<double> signal;
  for (int i = 0; i < 2000; ++i) {  // 40 s: 0.375 and 1.5 Hz are multiples of a fortieth
    const double t = i * kRockingSample_s;
    signal.push_back(5.0 + 0.1 * t + 3.0 * std::cos(2.0 * kPi * 0.375 * t) +
                     std::sin(2.0 * kPi * 1.5 * t));
  }
  const Spectrum spectrum = SpectrumOf(signal, 2.5);
  EXPECT_NEAR(spectrum.PowerNear(0.375), 4.5, 0.05);
  EXPECT_NEAR(spectrum.PowerNear(1.5), 0.5, 0.01);
  EXPECT_NEAR(std::accumulate(spectrum.power.begin(), spectrum.power.end(), 0.0), 5.0, 0.05);
}

TEST(Rocking, PaddlesRockTheRoverOnCompactSoilAndNotOnLoose) {
  const RockingSpectra loose = MeanSpectra(LooseSand()), compact = MeanSpectra(CompactGravel());
  const auto report = [](const char* what, const Spectrum& on_loose, const Spectrum& on_compact) {
    std::printf("%s, power [deg^2] within 12.5 %% of n times the paddles' %.2f Hz\n", what,
                kPaddles_hz);
    for (double n : {0.5, 1.0, 2.0, 3.0}) {
      const double a = on_loose.PowerNear(n * kPaddles_hz),
                   b = on_compact.PowerNear(n * kPaddles_hz);
      std::printf("  n %.1f: loose %.5f, compact %.5f, ratio %.1f\n", n, a, b, b / a);
    }
  };
  report("roll", loose.roll, compact.roll);
  report("heading", loose.heading, compact.heading);
  std::printf("at most: roll %.2f and %.2f deg, heading %.1f and %.1f deg\n", loose.most_roll_deg,
              compact.most_roll_deg, loose.most_heading_deg, compact.most_heading_deg);
  EXPECT_GT(compact.roll.PowerNear(kPaddles_hz), 2.0 * loose.roll.PowerNear(kPaddles_hz));
  EXPECT_GT(compact.heading.PowerNear(kPaddles_hz), 2.0 * loose.heading.PowerNear(kPaddles_hz));
  // The paper's "exceed the 5 deg heading tolerances", on compact soil alone.
  EXPECT_GT(compact.most_heading_deg, 5.0);
  EXPECT_LT(loose.most_heading_deg, 5.0);
  // Tips half a pitch apart on hard ground: each wheel's height is R cos(x), |x| <= 15 deg, whose
  // first harmonic is 2 R (15 deg)^2 / pi^2 = 4.2 mm; over a track of 0.85 m and every phase the
  // roll's power is (4.2 / 850)^2 = 0.080 deg^2. Wheels that fall from tip to tip have no more.
  EXPECT_GT(compact.roll.PowerNear(kPaddles_hz), 0.1 * 0.080);
  EXPECT_LT(compact.roll.PowerNear(kPaddles_hz), 0.080);
}

}  // namespace
}  // namespace dockyard::axel
