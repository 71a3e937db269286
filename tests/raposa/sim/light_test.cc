// Light, balance and bands in rendered pictures.
#include <gtest/gtest.h>

#include <cmath>

#include "controller/raposa/pyramid_finder.h"
#include "controller/raposa/tune_bands.h"
#include "raposa/sim/eye_pictures.h"
#include "raposa/sim/pictures.h"

namespace dockyard::raposa {
namespace {

std::string Light(double k) { return "light_k: " + std::to_string(k); }

/// Of 12 pictures about the pyramid in a light, those in which g and c are right.
int RightIn(double light_k, const HsvBand& orange, const HsvBand& blue,
            const std::shared_ptr<KeptRenderer>& renderer) {
  int right = 0;
  for (const double r_m : {0.7, 1.0, 1.3}) {
    for (const double alpha_deg : {-60.0, -30.0, 30.0, 60.0}) {
      const Picture picture =
          PictureOf(ScenarioAt(r_m, Radians(alpha_deg), Light(light_k)), renderer);
      right += FindIn(picture, orange, blue).right();
    }
  }
  return right;
}

/// Of 12 images from near by in such light, those in which our detector finds the guide where it
/// is.
int FoundIn(double light_level, bool lamps, const std::shared_ptr<KeptRenderer>& renderer) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const TakenImage taken = ExposeColourViewOf({.r_m = 0.26 + 0.01 * static_cast<double>(seed % 4),
                                                 .light_level = light_level,
                                                 .lamps = lamps,
                                                 .arm_rad = Radians(8.0),
                                                 .seed = seed},
                                                renderer);
    const PyramidSighting sighting =
        PyramidFinder(taken.nominal).Find(taken.image, taken.pitch_rad);
    found += sighting.guide && (sighting.guide->centre_px - *taken.guide_px).norm() < 8.0;
  }
  return found;
}

// Within 0.3 m of the guide, in the light of a room and in almost none. Nearer than 0.25 m the
// lamps dazzle a camera that meters the dark about them; at 0.27 m some images are on that edge: 20
// of 24 have the guide, 23 of 24 before a change of the start by 0.5 um and 0.001 deg.
TEST(RaposaLight, InTheDarkTheLampsAloneShowTheGuide) {
  const auto renderer = std::make_shared<KeptRenderer>();
  EXPECT_EQ(FoundIn(1.0, false, renderer), 12);
  EXPECT_GE(FoundIn(1e-5, true, renderer), 9);
  EXPECT_EQ(FoundIn(1e-5, false, renderer), 0);
}

// The sky ends close above the square, whose rows it half fills: it is no blue thing that goes on
// beyond the marks, and the square is not taken for a smaller one farther off.
TEST(RaposaLight, SkyCloseAboveTheSquareChangesNoRange) {
  const auto renderer = std::make_shared<KeptRenderer>();
  int posed = 0, right = 0;
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    const double step = 1e-2 * static_cast<double>(seed);
    const TakenImage taken = ExposeColourViewOf({.r_m = 1.95 + step,
                                                 .alpha_rad = Radians(-16.0 - 40.0 * step),
                                                 .light_k = 4200.0,
                                                 .ground = "sand",
                                                 .seed = seed},
                                                renderer);
    const PyramidSighting sighting =
        PyramidFinder(taken.nominal).Find(taken.image, taken.pitch_rad);
    if (sighting.fits.empty()) continue;
    ++posed;
    const Pose2& X_VD = sighting.fits.front().X_VD;
    const double range_m = std::hypot(taken.X_VD.x, taken.X_VD.y);
    right += std::abs(std::hypot(X_VD.x, X_VD.y) / range_m - 1.0) < 0.12;
  }
  EXPECT_GE(posed, 22);
  EXPECT_GE(right, posed - 1);
}

// F, C.3: the user adjusts the thresholds when the light changes. How good they are then depends on
// the one image that they are made on: over eight of them 79 of 96 are right, 87 of 96 before a
// change of the start by 0.5 um.
TEST(RaposaLight, BandsOfOneLightFailInAnotherAndThoseTunedThereDoNot) {
  const auto renderer = std::make_shared<KeptRenderer>();
  const FerreiraVision usual;
  EXPECT_GE(RightIn(5000.0, usual.orange, usual.blue, renderer), 11);
  for (const double light_k : {3000.0, 10000.0}) {
    EXPECT_LE(RightIn(light_k, usual.orange, usual.blue, renderer), 7) << light_k;
  }
  const int samples = 4;
  int right = 0;
  for (std::uint64_t seed = 1000; seed < 1000 + samples; ++seed) {
    const Picture sample =
        PictureOf(ScenarioAt(0.8, Radians(30.0), Light(6500.0), {}, seed), renderer);
    const auto tuned = TuneBands(sample.image, sample.nominal);
    ASSERT_TRUE(tuned) << seed;
    right += RightIn(6500.0, tuned->orange, tuned->blue, renderer);
  }
  EXPECT_GE(right, samples * 9);
}

/// Mean red over blue of the floor in the lower part of the disc that the hole leaves.
double FloorRedOverBlue(const RgbImage& image) {
  double red = 0.0, blue = 0.0;
  for (int v = 300; v < 370; ++v) {
    for (int u = 260; u < 380; ++u) {
      const std::size_t at =
          3 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
               static_cast<std::size_t>(u));
      red += image.pixels[at];
      blue += image.pixels[at + 2];
    }
  }
  return red / blue;
}

TEST(RaposaLight, FillLightTintsLessThanWhenAllLightIsOfItsColour) {
  const auto renderer = std::make_shared<KeptRenderer>();
  const auto floor = [&](const std::string& keys) {
    return FloorRedOverBlue(PictureOf(ScenarioAt(1.5, 0.0, keys), renderer).image);
  };
  const double cold = floor("light_k: 6500"), warm = floor("light_k: 3000"),
               mixed = floor("light_k: 6500, fill_light_k: 3000");
  EXPECT_LT(1.1 * cold, mixed);
  EXPECT_LT(1.1 * mixed, warm);
}

TEST(RaposaLight, CameraThatBalancesItselfTakesMostOfTheLightsColourAway) {
  const auto renderer = std::make_shared<KeptRenderer>();
  // What the light's colour does to the floor's.
  const auto change = [&](const std::string& keys) {
    const auto floor = [&](double light_k) {
      return FloorRedOverBlue(
          PictureOf(ScenarioAt(1.5, 0.0, Light(light_k) + keys), renderer).image);
    };
    return std::log(floor(3000.0) / floor(6500.0));
  };
  EXPECT_GT(change(""), 0.3);
  EXPECT_LT(change(", auto_balance: true"), 0.4 * change(""));
}

TEST(RaposaClutter, IsSeenAndThePyramidCanBeLeftOut) {
  const auto renderer = std::make_shared<KeptRenderer>();
  const auto picture = [&](const std::string& keys) {
    return PictureOf(ScenarioAt(1.5, 0.0, keys, {}, 3), renderer).image.pixels;
  };
  const auto differing = [](const std::vector<std::uint8_t>& a,
                            const std::vector<std::uint8_t>& b) {
    int n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) n += std::abs(a[i] - b[i]) > 40;
    return n;
  };
  const auto plain = picture("clutter: 0");
  EXPECT_EQ(differing(plain, picture("clutter: 0")), 0);
  EXPECT_GT(differing(plain, picture("clutter: 30")), 500);
  EXPECT_GT(differing(plain, picture("hide_pyramid: true")), 50);
}

}  // namespace
}  // namespace dockyard::raposa
