// Images in a run: asked for in one control period, given in a later one, or lost.
#include "run/scripted_run.h"
#include "sim/statistics/intervals.h"

namespace dockyard {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class LoopImages : public ScriptedRun {
 protected:
  LoopImages() { script_.cameras = 2; }
  /// The ticks of the frames with images.
  std::vector<Tick> Arrivals() const {
    std::vector<Tick> ticks;
    for (const SensorFrame& frame : diary_.frames) {
      if (!frame.images.empty()) ticks.push_back(frame.tick);
    }
    return ticks;
  }
  void AskAlways() {
    script_.step = [](const SensorFrame&, Commands& commands, Belief&) {
      commands.take_images = {0, 1};
    };
  }
};

TEST_F(LoopImages, AreExposedAndGivenInThePeriodAfterTheCommand) {
  Ask(40, {1, 0}, 2.0);
  const RunRecord record = Run();
  EXPECT_THAT(diary_.exposures, ElementsAre(Exposure{60, {1, 0}, 2.0}));
  ASSERT_THAT(Arrivals(), ElementsAre(60));
  const std::vector<CameraImage>& images = diary_.frames.at(3).images;
  ASSERT_EQ(images.size(), 2u);
  EXPECT_EQ(images[0].camera, 1);
  EXPECT_EQ(images[0].exposed, 60);
  EXPECT_EQ(images[1].camera, 0);
  EXPECT_EQ(record.result.images, 2);
}

TEST_F(LoopImages, OfASilentCameraAreNeitherGivenNorCounted) {
  script_.pixels = [](int camera) { return std::vector<std::uint8_t>(camera == 0 ? 0 : 2, 9); };
  Ask(40, {0, 1});
  const RunRecord record = Run();
  ASSERT_EQ(diary_.frames.at(3).images.size(), 1u);
  EXPECT_EQ(diary_.frames.at(3).images[0].camera, 1);
  EXPECT_EQ(record.result.images, 1);
}

// Asked for at 40 ms, exposed at 60 ms.
TEST_F(LoopImages, ComeWithTheFirstPeriodThatIsLateEnough) {
  Ask(40, {0});
  for (const Tick delay : {0, 1, 19, 20, 21, 79, 80}) {
    scenario_.camera_faults.delay_s = static_cast<double>(delay) * kTickSeconds;
    Run();
    const Tick arrival = 60 + (delay + 19) / 20 * 20;
    ASSERT_THAT(Arrivals(), ElementsAre(arrival)) << delay;
    EXPECT_EQ(diary_.frames.at(static_cast<std::size_t>(arrival / 20)).images[0].exposed, 60);
  }
}

TEST_F(LoopImages, ThatComeAfterTheEndAreNotCounted) {
  Ask(40, {0});
  scenario_.camera_faults.delay_s = 0.121;
  EXPECT_EQ(Run().result.images, 0);
  EXPECT_THAT(Arrivals(), IsEmpty());
  EXPECT_EQ(diary_.exposures.size(), 1u);
}

// Cameras that are asked again begin anew, so late ones that are asked always never answer.
TEST_F(LoopImages, AskedForInEachPeriodNeverComeFromALateCamera) {
  AskAlways();
  EXPECT_EQ(Run().result.images, 2 * 9);  // of ten periods the first has asked for none yet
  scenario_.camera_faults.delay_s = 0.03;
  EXPECT_EQ(Run().result.images, 0);
  EXPECT_EQ(diary_.exposures.size(), 9u);
}

TEST_F(LoopImages, ThatAreLostAreKnownToTheJudge) {
  Ask(40, {0});
  scenario_.camera_faults.lost = 1.0;
  EXPECT_EQ(Run().result.images, 0);
  EXPECT_THAT(diary_.TicksOf("lost"), ElementsAre(60));
  EXPECT_THAT(Arrivals(), IsEmpty());
}

TEST_F(LoopImages, AreLostAtTheScenariosRate) {
  AskAlways();
  scenario_.camera_faults.lost = 0.3;
  scenario_.time_limit_s = 40.0;
  const RunRecord record = Run();
  const auto asked = static_cast<int>(diary_.exposures.size());
  ASSERT_EQ(asked, 1999);
  const int lost = diary_.Count("lost");
  EXPECT_EQ(record.result.images, 2 * (asked - lost));  // both cameras or neither
  const Interval interval = ClopperPearson(lost, asked, 0.999);
  EXPECT_LE(interval.low, 0.3);
  EXPECT_GE(interval.high, 0.3);
}

}  // namespace
}  // namespace dockyard
