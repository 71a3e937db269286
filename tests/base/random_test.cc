#include "sim/base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string_view>

#include "controller/base/split_mix.h"

namespace dockyard {
namespace {

// The reference sequences of SplitMix64 for the seeds 0 and 1234567, as its published C code gives
// them; the rest by a few lines of Python that share nothing with the source.
TEST(RandomStream, DrawsTheReferenceSequenceOfSplitMix64) {
  RandomStream zero(0), seeded(1234567);
  for (const std::uint64_t bits :
       {0xe220a8397b1dcdafull, 0x6e789e6aa1b965f4ull, 0x06c45d188009454full}) {
    EXPECT_EQ(zero.NextBits(), bits);
  }
  for (const std::uint64_t bits :
       {6457827717110365317ull, 3203168211198807973ull, 9817491932198370423ull,
        4593380528125082431ull, 16408922859458223821ull}) {
    EXPECT_EQ(seeded.NextBits(), bits);
  }
}

TEST(RandomStream, DrawsTheSameNumbersAsAnIndependentProgram) {
  RandomStream unit(1234567), scaled(1234567), normal(1234567);
  for (const double u : {0.3500795420214081, 0.17364409667091263, 0.5322073040624192}) {
    EXPECT_EQ(unit.Uniform(), u);
    EXPECT_DOUBLE_EQ(scaled.Uniform(-2.0, 3.0), -2.0 + 5.0 * u);
  }
  for (const double z : {-0.3851057284348681, -0.9398623079942611, 0.08081963600853463,
                         -0.677615816951901, 1.2240297132741078}) {
    EXPECT_NEAR(normal.Normal(), z, 1e-15);
  }
}

TEST(StreamKey, IsThatOfAnIndependentProgram) {
  EXPECT_EQ(StreamKey(7, "imu"), 0x72979f5c0d56402eull);
  EXPECT_EQ(StreamKey(0, ""), 0xaebe53f85cdc3c4cull);
  EXPECT_EQ(StreamKey(0xffffffffffffffffull, "yard"), 0x0be4496cc861c8eaull);
}

TEST(WorldSeed, AndPlaceSeedAreThoseOfAnIndependentProgram) {
  EXPECT_EQ(PlaceSeed(1, 0), 0x5e41ab087439611eull);
  EXPECT_EQ(PlaceSeed(20131109, 40), 0x3be648065aa0ee99ull);
  EXPECT_EQ(WorldSeed(1, 0, 0), 0xb18a02f46d8d86c3ull);
  EXPECT_EQ(WorldSeed(1, 0, 1), 0xf8c5b62c83f707e8ull);
  EXPECT_EQ(WorldSeed(1, 1, 0), 0x9edbe9bd18ad781dull);
  EXPECT_EQ(WorldSeed(20131109, 40, 7), 0x2504f60129ab0f0eull);
}

TEST(WorldSeed, IsAnotherForEachPlaceAndRepeat) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t place = 0; place < 100; ++place) {
    for (std::uint64_t repeat = 0; repeat < 100; ++repeat) {
      seeds.insert(WorldSeed(1, place, repeat));
    }
  }
  EXPECT_EQ(seeds.size(), 10000u);
}

std::uint64_t Unshifted(std::uint64_t z, int shift) {
  std::uint64_t r = z;
  for (int i = 0; i < 64 / shift + 1; ++i) r = z ^ r >> shift;
  return r;
}
/// The number whose SplitMix64 output is z.
std::uint64_t Unmixed(std::uint64_t z) {
  z = Unshifted(z, 31) * 0x319642b2d24d8ec3ull;  // the inverses of its factors modulo 2^64
  z = Unshifted(z, 27) * 0x96de1b173f119089ull;
  return Unshifted(z, 30);
}
/// Of the key of one plain stream.
std::uint64_t SeedFromKey(std::uint64_t key, std::string_view stream) {
  const std::uint64_t of_name = Unmixed(StreamKey(0, stream)) ^ SplitMix(0, 0);
  return Unmixed(Unmixed(key) ^ of_name) - 0x9e3779b97f4a7c15ull;
}

TEST(SealedSeed, DoesNotFollowFromItsStreams) {
  const std::uint64_t world = WorldSeed(1, 2, 3);
  EXPECT_EQ(SeedFromKey(StreamKey(world, "imu"), "imu"), world);  // a plain one has
  const Seed sealed = WorldSeed(Seed(1, NewSecret()), 2, 3);
  EXPECT_NE(SeedFromKey(StreamKey(sealed, "imu"), "imu"), sealed.number);
  EXPECT_NE(sealed.number, world);
}

// Seeds of campaigns are small numbers: a loop over them finds a plain world.
TEST(SealedSeed, IsFoundByNoGuess) {
  const Seed sealed = WorldSeed(Seed(1, NewSecret()), 2, 0), plain = WorldSeed(Seed(1), 2, 0);
  int found = 0, found_plain = 0;
  for (std::uint64_t campaign = 0; campaign < 10000; ++campaign) {
    for (std::uint64_t place = 0; place < 1000; ++place) {
      const std::uint64_t guess = StreamKey(WorldSeed(campaign, place, 0), "imu");
      found += guess == StreamKey(sealed.number, "imu");
      found_plain += guess == StreamKey(plain, "imu");
    }
  }
  EXPECT_EQ(found_plain, 1);
  EXPECT_EQ(found, 0);
}

TEST(SealedSeed, DrawsAreOthersForEachSecretPlaceRepeatAndStream) {
  std::set<std::uint64_t> keys;
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const Seed sealed(1, NewSecret());
    for (std::uint64_t place = 0; place < 10; ++place) {
      for (const char* stream : {"draw/a", "draw/b"}) {
        keys.insert(PlaceKey(sealed, place, stream));
        ++count;
        for (std::uint64_t repeat = 0; repeat < 10; ++repeat) {
          keys.insert(RunKey(sealed, place, repeat, stream));
          keys.insert(StreamKey(WorldSeed(sealed, place, repeat), stream));
          count += 2;
        }
      }
    }
  }
  EXPECT_EQ(static_cast<int>(keys.size()), count);
}

TEST(OpenUnit, LeavesBothEndsOutByHalfACell) {
  EXPECT_EQ(OpenUnit(0), 0x1.0p-53);
  EXPECT_EQ(OpenUnit(~0ull), 1.0 - 0x1.0p-53);
  EXPECT_EQ(OpenUnit(1ull << 63), 0.5 + 0x1.0p-53);
}

TEST(RandomStream, IsTheSameForTheSameKeyAndOtherForAnother) {
  RandomStream a(StreamKey(7, "imu")), b(StreamKey(7, "imu")), c(StreamKey(7, "light"));
  const std::uint64_t first = a.NextBits();
  EXPECT_EQ(first, b.NextBits());
  EXPECT_NE(first, c.NextBits());
}

TEST(RandomStream, UniformHasItsMomentsAndBounds) {
  RandomStream random(3);
  constexpr int kDraws = 100000;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.Uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  // Standard errors: 0.00091 of the mean, 0.00094 of the second moment; four of them.
  EXPECT_NEAR(sum / kDraws, 0.5, 0.0037);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 0.0038);
}

TEST(RandomStream, NormalFollowsItsDistributionFunction) {
  RandomStream random(4);
  constexpr int kDraws = 100000;
  for (const double z : {-2.0, -1.0, 0.0, 0.5, 1.5}) {
    int below = 0;
    for (int i = 0; i < kDraws; ++i) below += random.Normal() < z;
    const double p = 0.5 * std::erfc(-z / std::sqrt(2.0));
    EXPECT_NEAR(static_cast<double>(below) / kDraws, p, 4.0 * std::sqrt(p * (1 - p) / kDraws));
  }
}

}  // namespace
}  // namespace dockyard
