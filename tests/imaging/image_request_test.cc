#include "controller/imaging/image_request.h"

#include <gtest/gtest.h>

namespace dockyard {
namespace {

constexpr Tick kPeriod = 20;

struct Asked {
  std::vector<Tick> at;
  Tick ended = -1;
  bool answered = false;
};

/// Cameras that bring each image so long after its exposure, if at all.
Asked RunTo(const ImagePatience& patience, Tick delay, bool works) {
  Asked run;
  ImageRequest request;
  for (Tick now = 0; now < 100'000; now += kPeriod) {
    SensorFrame frame{.tick = now};
    for (const Tick exposed : run.at) {
      if (works && exposed + delay == now) frame.images.push_back({0, GrayImage{}, exposed});
    }
    run.answered = IsAnswered(request, frame);
    const RequestState state = StateOf(request, patience, now);
    if (run.answered || state == RequestState::kUnanswered) {
      run.ended = now;
      break;
    }
    if (state == RequestState::kAwaited) continue;
    Commands commands;
    Ask({0, 1}, now, &request, &commands);
    EXPECT_EQ(commands.take_images, (std::vector<int>{0, 1}));
    run.at.push_back(now);
  }
  return run;
}

TEST(ImageRequest, IsRepeatedAfterEachWaitAndEndsAfterTheLast) {
  const Asked run = RunTo({.wait = 1000, .most_asks = 3}, 0, false);
  EXPECT_EQ(run.at, (std::vector<Tick>{0, 1000, 2000}));
  EXPECT_EQ(run.ended, 3000);
  EXPECT_FALSE(run.answered);
}

TEST(ImageRequest, WaitsTwiceAsLongEachTimeWhereAsked) {
  const Asked run = RunTo({.wait = 1000, .most_asks = 4, .doubles = true}, 0, false);
  EXPECT_EQ(run.at, (std::vector<Tick>{0, 1000, 3000, 7000}));
  EXPECT_EQ(run.ended, 15'000);
}

TEST(ImageRequest, IsAnsweredByImagesSinceTheLastAskAlone) {
  // An image that is three seconds late answers the ask with a patience of four.
  const Asked slow = RunTo({.wait = 1000, .most_asks = 6, .doubles = true}, 3000, true);
  EXPECT_EQ(slow.at, (std::vector<Tick>{0, 1000, 3000}));
  EXPECT_EQ(slow.ended, 6000);
  EXPECT_TRUE(slow.answered);
  // Without doubling all come too late.
  EXPECT_FALSE(RunTo({.wait = 1000, .most_asks = 6}, 3000, true).answered);
}

TEST(ImageRequest, IsAnsweredByNothingWhileNoneIsAwaited) {
  SensorFrame frame{.tick = 40};
  frame.images.push_back({0, GrayImage{}, 40});
  EXPECT_FALSE(IsAnswered({}, frame));
  EXPECT_TRUE(IsAnswered({.asked = 40, .asks = 1}, frame));
  EXPECT_FALSE(IsAnswered({.asked = 41 + kMostStampError, .asks = 1}, frame));
  EXPECT_FALSE(IsAnswered({.asked = 40, .asks = 1}, {.tick = 60}));
}

// A camera whose clock is behind the controller's stamps the answer with a time before the ask.
TEST(ImageRequest, IsAnsweredByAStampOfAClockThatIsBehind) {
  const ImageRequest request{.asked = 1000, .asks = 1};
  for (const Tick behind : {0, 20, 25, 50}) {
    EXPECT_TRUE(Answers(request, 1000 - behind)) << behind;
  }
  EXPECT_FALSE(Answers(request, 949));
  EXPECT_FALSE(Answers({}, 1000));
}

}  // namespace
}  // namespace dockyard
