#include "controller/custom/camera_requests.h"

#include <gtest/gtest.h>

#include "custom/controller/test_robot.h"

namespace dockyard::custom {
namespace {

TEST(CameraRequests, FollowAnswersNoFasterThanTenASecond) {
  CameraRequests requests(NominalOf(), {0});
  int asked = 0;
  Tick exposed = -1;  // of an image to come
  for (Tick now = 0; now < 10000; now += 20) {
    SensorFrame frame;
    frame.tick = now;
    if (exposed >= 0) frame.images.push_back({0, GrayImage{}, exposed, 0.0});
    exposed = -1;
    requests.Read(frame);
    Commands commands;
    requests.AskDue(now, &commands);
    if (commands.take_images.empty()) continue;
    ++asked;
    exposed = now;
  }
  EXPECT_EQ(asked, 100);
  EXPECT_FALSE(requests.unanswered(10000));
}

TEST(CameraRequests, AreUnansweredAfterSomeRepetitions) {
  CameraRequests requests(NominalOf(), {0});
  int asked = 0;
  Tick now = 0;
  for (; now < 20000 && !requests.unanswered(now); now += 20) {
    Commands commands;
    requests.AskDue(now, &commands);
    asked += static_cast<int>(commands.take_images.size());
  }
  EXPECT_LT(now, 6000);
  EXPECT_GT(asked, 2);
  requests.Restart();
  EXPECT_FALSE(requests.unanswered(now));
}

}  // namespace
}  // namespace dockyard::custom
