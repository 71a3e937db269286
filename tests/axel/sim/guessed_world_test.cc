// What a controller of a run gets at first, against 10^7 guesses of the campaign's seed and of the
// run's place in it.
#include <gtest/gtest.h>

#include <cmath>

#include "axel/sim/scenarios.h"
#include "sim/base/random.h"

namespace dockyard::axel {
namespace {

constexpr std::uint64_t kSeeds = 10000, kPlaces = 1000;
constexpr int kRun = 3;

/// What the noise of the first motor's current is drawn from.
double FirstNoise(const Seed& world) { return RandomStream(StreamKey(world, "current")).Normal(); }

/// The first reading of a motor at rest: its noise, where that is positive.
double FirstReading(const Seed& world) {
  const std::vector<System> systems = Systems();
  Scenario scenario = TypicalScenario();
  scenario.seed = world;
  return systems.front().make_ready(scenario).plant->Sense().motors.at(0).current_a;
}

struct Found {
  int by_hello = 0, by_frame = 0;
};

Found Guess(std::uint64_t hello_seed, double reading, double sigma) {
  Found found;
  for (std::uint64_t campaign = 0; campaign < kSeeds; ++campaign) {
    for (std::uint64_t place = 0; place < kPlaces; ++place) {
      const Seed world = WorldSeed(campaign, place, 0);
      found.by_hello += hello_seed == world.number ||
                        hello_seed == StreamKey(world, "controller") ||
                        hello_seed == SeedOfProgram(world.number, kRun);
      found.by_frame += std::abs(sigma * FirstNoise(world) - reading) < 1e-12;
    }
  }
  return found;
}

TEST(GuessedWorld, OfAPlainRunIsFoundByItsFirstFrameAndOfASealedOneByNothing) {
  // Worlds whose first noise is positive, so that the reading shows it.
  const Seed campaign(271);
  std::uint64_t place = 0;
  while (FirstNoise(WorldSeed(campaign, place, 0)) < 0.1) ++place;
  const Seed plain = WorldSeed(campaign, place, 0);
  Seed sealed_campaign(271, Secret{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}});
  place = 0;
  while (FirstNoise(WorldSeed(sealed_campaign, place, 0)) < 0.1) ++place;
  const Seed sealed = WorldSeed(sealed_campaign, place, 0);

  const double sigma = FirstReading(plain) / FirstNoise(plain);
  ASSERT_GT(sigma, 0.0);
  ASSERT_NEAR(FirstReading(sealed), sigma * FirstNoise(sealed), 1e-12);
  const std::uint64_t hello = SeedOfProgram(TypicalScenario().controller_seed, kRun);
  const Found of_plain = Guess(hello, FirstReading(plain), sigma);
  EXPECT_EQ(of_plain.by_hello, 0);
  EXPECT_EQ(of_plain.by_frame, 1);
  const Found of_sealed = Guess(hello, FirstReading(sealed), sigma);
  EXPECT_EQ(of_sealed.by_hello, 0);
  EXPECT_EQ(of_sealed.by_frame, 0);
}

}  // namespace
}  // namespace dockyard::axel
