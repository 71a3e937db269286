// The bracket of exposures: when the machine takes one, what it asks for, and when it stops.
#include "controller/axel/bracket.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "axel/controller/kinematic_rover.h"
#include "controller/axel/machine.h"

namespace dockyard::axel {
namespace {

using testing::ElementsAre;

/// A picture of even light.
GrayImage Plain(const Nominal& nominal, std::uint8_t value) {
  const int w = nominal.rig.left.width, h = nominal.rig.left.height;
  const auto count = static_cast<std::size_t>(w) * static_cast<std::size_t>(h);
  return {w, h, std::vector<std::uint8_t>(count, value)};
}

/// Its left half has another number.
GrayImage Halves(const Nominal& nominal, std::uint8_t left, std::uint8_t right) {
  GrayImage image = Plain(nominal, right);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width / 2; ++x) {
      image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                   static_cast<std::size_t>(x)] = left;
    }
  }
  return image;
}

LocateOutput SeenBy(const char* method, bool stereo) {
  LocateOutput out{PoseFailure::kTooFewFiducials, {}};
  DockSighting sighting;
  sighting.stereo = stereo;
  // Three metres ahead, facing the rover.
  sighting.X_RB.R << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  sighting.X_RB.p = {3.0, 0.0, 0.3};
  out.sighting = sighting;
  out.report.method = method;
  return out;
}

struct Asked {
  Tick tick = 0;
  double stops = 0.0;
};

/// The machine at rest before cameras that give this picture. `located` tells from the pair's left
/// picture whether it shows the board. `answers` tells which asks, from 1, are answered.
struct Bench {
  Nominal nominal = TestNominal();
  GrayImage picture = Halves(nominal, 3, 120);
  std::function<bool(const GrayImage&)> located = [](const GrayImage&) { return false; };
  std::function<bool(int)> answers = [](int) { return true; };

  std::vector<Asked> asked;
  std::vector<GrayImage> seen;
  bool found = false;  // the machine's belief at the end

  /// The asks until the machine leaves its first stop, or for so long.
  void Run(double seconds = 60.0) {
    const auto locate = [&](const StereoImages& images, const LocateHints&) {
      seen.push_back(images.left);
      LocateOutput out{PoseFailure::kTooFewFiducials, {}};
      if (!located(images.left)) return out;
      return SeenBy("stereo", true);
    };
    const auto machine = MakeAxelMachine(nominal, {}, locate);
    bool due = false;
    const auto periods = static_cast<int>(seconds * 1000.0 / kControlPeriod);
    for (int i = 0; i < periods; ++i) {
      SensorFrame frame;
      frame.motors.resize(kMotorCount);
      frame.imu.specific_force_R.z() = 9.81;
      frame.tick = i * kControlPeriod;
      if (due && answers(static_cast<int>(asked.size()))) {
        frame.images = {{kLeftCamera, picture, frame.tick}, {kRightCamera, picture, frame.tick}};
      }
      const Commands commands = machine->Step(frame);
      due = !commands.take_images.empty();
      if (due) asked.push_back({frame.tick, commands.exposure_stops});
      found = machine->belief().located;
      const std::string& phase = machine->belief().phase;
      if (!asked.empty() && phase != "look") break;
    }
  }
  std::vector<double> Stops() const {
    std::vector<double> stops;
    for (const Asked& ask : asked) stops.push_back(ask.stops);
    return stops;
  }
};

TEST(Bracket, OneIsTakenWhereDarkHidesTheBoard) {
  Bench bench;
  bench.Run();
  EXPECT_THAT(bench.Stops(), ElementsAre(0.0, -2.0, 2.0));
  // The pair, and the merge of the three: each once.
  ASSERT_EQ(bench.seen.size(), 2u);
  EXPECT_FALSE(bench.found);
  EXPECT_EQ(bench.seen[0], bench.picture);
  EXPECT_NE(bench.seen[1], bench.picture);
}

TEST(Bracket, OneIsTakenWhereLightSaturates) {
  Bench bench;
  bench.picture = Halves(bench.nominal, 255, 120);
  bench.Run();
  EXPECT_THAT(bench.Stops(), ElementsAre(0.0, -2.0, 2.0));
}

TEST(Bracket, NoneIsTakenOfAPictureThatHoldsItsLight) {
  Bench bench;
  bench.picture = Halves(bench.nominal, 30, 120);
  bench.Run();
  EXPECT_THAT(bench.Stops(), ElementsAre(0.0));
}

TEST(Bracket, NoneIsTakenInTheDark) {
  Bench bench;
  bench.picture = Plain(bench.nominal, 2);
  bench.Run();
  EXPECT_THAT(bench.Stops(), ElementsAre(0.0));
}

TEST(Bracket, NoneIsTakenWhereTheNominalParametersHaveNone) {
  Bench bench;
  bench.nominal.vision.bracket_stops = 0.0;
  bench.Run();
  EXPECT_THAT(bench.Stops(), ElementsAre(0.0));
}

TEST(Bracket, ItsStopsAreTheNominalOnes) {
  Bench bench;
  bench.nominal.vision.bracket_stops = 3.0;
  bench.Run();
  EXPECT_THAT(bench.Stops(), ElementsAre(0.0, -3.0, 3.0));
}

// A picture that does not come is waited for as long as the first pair was, 1 s, and what is there
// is merged.
TEST(Bracket, SilentCamerasEndIt) {
  Bench bench;
  bench.answers = [](int ask) { return ask == 1; };
  bench.Run();
  EXPECT_THAT(bench.Stops(), ElementsAre(0.0, -2.0));
  EXPECT_EQ(bench.seen.size(), 1u);

  Bench half;
  half.answers = [](int ask) { return ask <= 2; };
  half.Run();
  EXPECT_THAT(half.Stops(), ElementsAre(0.0, -2.0, 2.0));
  EXPECT_EQ(half.seen.size(), 2u);
}

TEST(Bracket, BoardThatTheMergeShowsIsTaken) {
  Bench bench;
  const GrayImage plain = bench.picture;
  bench.located = [plain](const GrayImage& image) { return image != plain; };
  bench.Run();
  EXPECT_THAT(bench.Stops(), ElementsAre(0.0, -2.0, 2.0));
  EXPECT_TRUE(bench.found);
}

StereoImages Pair(const GrayImage& left, const GrayImage& right) { return {left, right}; }

TEST(Bracket, BoardThatBothCamerasShowNeedsNone) {
  const Nominal nominal = TestNominal();
  const GrayImage dark = Halves(nominal, 3, 120);
  Bracket bracket({}, nominal);
  EXPECT_FALSE(bracket.Begins(Pair(dark, dark), SeenBy("stereo", true), {}));
}

// The camera that does not see the board decides, where the other one's sighting puts it.
TEST(Bracket, OfOneSightedPairOnlyTheBlindCameraCounts) {
  const Nominal nominal = TestNominal();
  const GrayImage good = Plain(nominal, 100), dark = Halves(nominal, 3, 120);
  EXPECT_TRUE(Bracket({}, nominal).Begins(Pair(good, dark), SeenBy("left", false), {}));
  EXPECT_FALSE(Bracket({}, nominal).Begins(Pair(dark, good), SeenBy("left", false), {}));
}

// A dark border of the picture is no reason when the board is known to stand elsewhere.
TEST(Bracket, OnlyAreasWhereTheBoardShouldBeCount) {
  const Nominal nominal = TestNominal();
  GrayImage image = Plain(nominal, 100);
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width / 8; ++x) {
      image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                   static_cast<std::size_t>(x)] = 2;
    }
  }
  const LocateOutput none{PoseFailure::kTooFewFiducials, {}};
  EXPECT_TRUE(Bracket({}, nominal).Begins(Pair(image, image), none, {}));
  LocateHints hints;
  hints.X_RB_expected = SeenBy("left", false).sighting->X_RB;
  EXPECT_FALSE(Bracket({}, nominal).Begins(Pair(image, image), none, hints));
}

TEST(Bracket, IsTakenOnceAStop) {
  const Nominal nominal = TestNominal();
  const GrayImage dark = Halves(nominal, 3, 120);
  const LocateOutput none{PoseFailure::kTooFewFiducials, {}};
  Bracket bracket({}, nominal);
  EXPECT_TRUE(bracket.Begins(Pair(dark, dark), none, {}));
  bracket.Stop();
  EXPECT_FALSE(bracket.Begins(Pair(dark, dark), none, {}));
  bracket.NewStop();
  EXPECT_TRUE(bracket.Begins(Pair(dark, dark), none, {}));
}

// A camera that gave no picture at first stands in the pair as black, which is no measurement.
TEST(Bracket, StandInOfAMissingPictureIsNotMerged) {
  const Nominal nominal = TestNominal();
  const LocateOutput none{PoseFailure::kTooFewFiducials, {}};
  const GrayImage dark = Halves(nominal, 3, 120), more = Halves(nominal, 12, 255);
  Bracket bracket({}, nominal);
  ASSERT_TRUE(bracket.Begins(Pair(dark, Plain(nominal, 0)), none, {}));
  bracket.Take(nullptr, nullptr);
  EXPECT_FALSE(bracket.HasMore());
  bracket.Take(&more, &more);
  EXPECT_FALSE(bracket.under_way());
  EXPECT_EQ(bracket.Merged().right, MergeExposures({{more, 2.0}}));
}

TEST(Bracket, MergedSightingByOneCameraDoesNotReplaceOne) {
  const Nominal nominal = TestNominal();
  const GrayImage good = Plain(nominal, 100), dark = Halves(nominal, 3, 120);
  Bracket bracket({}, nominal);
  ASSERT_TRUE(bracket.Begins(Pair(good, dark), SeenBy("left", false), {}));
  EXPECT_EQ(bracket.Better(SeenBy("right", false)).report.method, "left");
  EXPECT_EQ(bracket.Better(SeenBy("stereo", true)).report.method, "stereo");
  EXPECT_EQ(bracket.Better(LocateOutput{PoseFailure::kTooFewFiducials, {}}).report.method, "left");
  EXPECT_EQ(bracket.Better(std::nullopt).report.method, "left");
}

}  // namespace
}  // namespace dockyard::axel
