#include "sim/page/images_part.h"

#include <gtest/gtest.h>

#include "sim/images/png.h"

namespace dockyard {
namespace {

/// A controller that takes an image every 0.5 s with both cameras and reports no sighting.
LoggedRun RunWithImages(int times) {
  LoggedRun run;
  const std::string png = EncodePng(GrayImage{8, 6, std::vector<std::uint8_t>(48, 90)});
  run.cameras = {{"left", 8, 6}, {"right", 8, 6}};
  for (int i = 0; i < 5 * times; ++i) run.times_s.push_back(0.1 * i);
  for (int i = 0; i < times; ++i) {
    for (const char* camera : {"left", "right"}) run.images.push_back({0.5 * i, {camera, png}});
  }
  return run;
}

TEST(ImagesPart, KeepsEveryImageWhereThereAreFew) {
  Payload payload;
  const Json json = ImagesPart(RunWithImages(103), 240, payload);
  EXPECT_EQ(json["taken"], 103);
  ASSERT_EQ(json["shown"].size(), 103u);
  for (std::size_t i = 0; i < 103; ++i) {
    EXPECT_EQ(json["shown"][i]["sample"], 5 * i);
    EXPECT_EQ(json["shown"][i]["cameras"].size(), 2u);
    EXPECT_GT(json["shown"][i]["cameras"][0]["picture"]["length"], 20);
  }
}

TEST(ImagesPart, ThinsThemEvenlyAndSaysHowManyThereWere) {
  Payload payload;
  const Json json = ImagesPart(RunWithImages(101), 42, payload);
  EXPECT_EQ(json["taken"], 101);
  ASSERT_EQ(json["shown"].size(), 21u);
  for (std::size_t i = 0; i < 21; ++i) EXPECT_EQ(json["shown"][i]["sample"], 25 * i);
}

TEST(ImagesPart, LeavesOutThoseOfASighting) {
  Payload payload;
  LoggedRun run = RunWithImages(3);
  run.sightings.push_back({.time_s = 0.5, .X_DR = {}, .report = {}, .X_DR_measured = {}});
  const Json json = ImagesPart(run, 240, payload);
  ASSERT_EQ(json["shown"].size(), 2u);
  EXPECT_EQ(json["shown"][0]["sample"], 0);
  EXPECT_EQ(json["shown"][1]["sample"], 10);
  for (const double time_s : {0.0, 1.0}) {
    run.sightings.push_back({.time_s = time_s, .X_DR = {}, .report = {}, .X_DR_measured = {}});
  }
  EXPECT_TRUE(ImagesPart(run, 240, payload).is_null());
}

}  // namespace
}  // namespace dockyard
