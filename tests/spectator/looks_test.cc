#include "sim/spectator/looks.h"

#include <gtest/gtest.h>

#include "sim/images/png.h"
#include "spectator/some_run.h"

namespace dockyard {
namespace {

GrayImage Flat(std::uint8_t level) { return {4, 2, std::vector<std::uint8_t>(8, level)}; }

/// Both cameras at 1 s, the right one alone at 2 s; the first look is reported.
LoggedRun RunWithImages() {
  LoggedRun run = SomeRun();
  run.cameras = {{"left", 4, 2}, {"right", 4, 2}};
  run.images = {{1.0, {"left", EncodePng(Flat(10))}},
                {1.0, {"right", EncodePng(Flat(20))}},
                {2.0, {"right", EncodePng(Flat(30))}}};
  SightingSample sighting{};
  sighting.time_s = 1.0;
  sighting.report.accepted = false;
  sighting.report.reason = "too few discs";
  run.sightings = {sighting};
  return run;
}

TEST(LooksOf, GathersImagesByTimeAndCameraWithTheirReport) {
  const LoggedRun run = RunWithImages();
  const std::vector<Look> looks = LooksOf(run);
  ASSERT_EQ(looks.size(), 2u);
  EXPECT_EQ(PictureOf(looks[0], 0)->pixels[0], 10);
  EXPECT_EQ(PictureOf(looks[0], 1)->pixels[0], 20);
  EXPECT_EQ(WordOf(looks[0]), "too few discs");
  EXPECT_FALSE(PictureOf(looks[1], 0).has_value());
  EXPECT_EQ(PictureOf(looks[1], 1)->pixels[0], 30);
  EXPECT_EQ(WordOf(looks[1]), "not reported");
}

TEST(PictureOf, IsNoneForBytesThatAreNoImage) {
  LoggedRun run = RunWithImages();
  run.images[0].value.bytes = "nonsense";
  EXPECT_FALSE(PictureOf(LooksOf(run)[0], 0).has_value());
}

}  // namespace
}  // namespace dockyard
