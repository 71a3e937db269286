#include "controller/raposa/refuted_places.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dockyard::raposa {
namespace {

TEST(RefutedPlaces, StayWhereTheyAreWhileTheCameraMoves) {
  RefutedPlaces places;
  places.Add({.bearing_rad = 0.0, .range_m = 1.0, .radius_m = 0.1});
  // Half a metre on, then a quarter turn to the left, in ten parts.
  for (int i = 0; i < 10; ++i) places.Move({0.05, 0.0, 0.0});
  EXPECT_NEAR(places.things()[0].range_m, 0.5, 1e-12);
  for (int i = 0; i < 10; ++i) places.Move({0.0, 0.0, kPi / 20.0});
  EXPECT_NEAR(places.things()[0].bearing_rad, -kPi / 2, 1e-12);
  EXPECT_NEAR(places.things()[0].range_m, 0.5, 1e-12);
  EXPECT_GT(places.things()[0].radius_m, 0.1);  // belts drift
}

TEST(RefutedPlaces, AreKnownAgainByBearingAndRange) {
  const RefutedThing thing{.bearing_rad = 0.1, .range_m = 1.0, .radius_m = 0.1};
  EXPECT_TRUE(Is(thing, 0.1, 1.0));
  EXPECT_TRUE(Is(thing, 0.2, 0.8));    // 0.1 m aside
  EXPECT_FALSE(Is(thing, 0.35, 1.0));  // 0.25 m aside
  EXPECT_FALSE(Is(thing, 0.1, 2.2));
  EXPECT_FALSE(Is(thing, 0.1, 0.4));
  EXPECT_TRUE(Is({.bearing_rad = kPi, .range_m = 1.0, .radius_m = 0.1}, -kPi + 0.02, 1.0));
}

TEST(RefutedPlaces, DropTheOldestAndNeverGrowWithoutEnd) {
  RefutedPlaces places;
  for (int i = 0; i < 100; ++i) places.Add({.bearing_rad = 0.01 * i, .range_m = 1.0});
  EXPECT_LE(places.things().size(), 40u);
  EXPECT_NEAR(places.things().back().bearing_rad, 0.99, 1e-12);
}

}  // namespace
}  // namespace dockyard::raposa
