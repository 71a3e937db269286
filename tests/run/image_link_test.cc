// Late and lost pictures, and a scenario's faults as the sensor's options.
#include <gtest/gtest.h>

#include "sim/run/camera_faults.h"
#include "sim/statistics/intervals.h"

namespace dockyard {
namespace {

constexpr Tick kPeriod = 20;

std::vector<CameraImage> Picture(int number) {
  return {{0, GrayImage{1, 1, {static_cast<std::uint8_t>(number)}}}};
}
CameraFaults Late(double delay_s) {
  CameraFaults faults;
  faults.delay_s = delay_s;
  return faults;
}
CameraFaults Losing(double lost) {
  CameraFaults faults;
  faults.lost = lost;
  return faults;
}
int NumberOf(const std::vector<CameraImage>& images) {
  return std::get<GrayImage>(images.at(0).pixels).pixels.at(0);
}

TEST(ImageLink, WithoutFaultsAPictureArrivesInTheFrameOfItsExposure) {
  ImageLink link({}, 1);
  for (int i = 0; i < 200; ++i) {
    ASSERT_TRUE(link.Send(Picture(i), i * kPeriod));
    ASSERT_EQ(NumberOf(link.Receive(i * kPeriod)), i);
    ASSERT_TRUE(link.Receive(i * kPeriod).empty());  // once
  }
}

// By the millisecond: 1.237 s late is 1237 ticks late, and in no frame before.
TEST(ImageLink, DelayIsExactToTheTick) {
  for (const Tick delay : {0, 1, 19, 20, 21, 350, 1237, 9999}) {
    ImageLink link(Late(static_cast<double>(delay) * kTickSeconds), 1);
    constexpr Tick kExposed = 4321;
    ASSERT_TRUE(link.Send(Picture(7), kExposed));
    Tick now = kExposed;
    while (link.Receive(now).empty()) ++now;
    EXPECT_EQ(now - kExposed, delay);
  }
}

// In a loop of control periods the pictures come with the first frame that is late enough.
TEST(ImageLink, ArrivesWithTheFirstFrameAfterTheDelay) {
  ImageLink link(Late(0.101), 1);
  link.Send(Picture(7), 40);
  for (Tick now = 40; now < 160; now += kPeriod) ASSERT_TRUE(link.Receive(now).empty()) << now;
  EXPECT_EQ(NumberOf(link.Receive(160)), 7);
}

TEST(ImageLink, APictureTellsWhenItWasExposed) {
  ImageLink link(Late(0.101), 1);
  link.Send(Picture(7), 40);
  EXPECT_EQ(link.Receive(160).at(0).exposed, 40);
}

// Offset at power-on and share of the time since, to the nearest millisecond; the arrival is as it
// was.
TEST(ImageLink, StampsByTheCamerasClock) {
  struct Case {
    double offset_s, drift_ppm;
    Tick now, stamp;
  };
  for (const Case& each : {Case{0.02, 0.0, 1000, 1020}, Case{-0.0123, 0.0, 1000, 988},
                           Case{0.0, 100.0, 200'000, 200'020}, Case{0.01, -50.0, 400'000, 399'990},
                           Case{0.0, 0.0, 123'456, 123'456}, Case{-0.02, 0.0, 0, -20}}) {
    CameraFaults faults = Late(0.1);
    faults.clock_offset_s = each.offset_s;
    faults.clock_drift_ppm = each.drift_ppm;
    ImageLink link(faults, 1);
    link.Send({{0, GrayImage{1, 1, {7}}}}, each.now);
    EXPECT_TRUE(link.Receive(each.now + 99).empty());
    EXPECT_EQ(link.Receive(each.now + 100).at(0).exposed, each.stamp) << each.now;
  }
}

TEST(ImageLink, CamerasAskedAgainBeginAnew) {
  ImageLink link(Late(0.1), 1);
  link.Send(Picture(1), 0);
  link.Send(Picture(2), 60);
  for (Tick now = 60; now < 160; ++now) ASSERT_TRUE(link.Receive(now).empty()) << now;
  EXPECT_EQ(NumberOf(link.Receive(160)), 2);
  for (Tick now = 160; now < 1000; ++now) ASSERT_TRUE(link.Receive(now).empty()) << now;
}

TEST(ImageLink, LostShareIsTheProbability) {
  constexpr int kTakes = 20000;
  for (const double lost : {0.02, 0.2, 0.5, 0.9}) {
    ImageLink link(Losing(lost), 11);
    int count = 0;
    for (int i = 0; i < kTakes; ++i) {
      const bool sent = link.Send(Picture(1), i * kPeriod);
      ASSERT_EQ(link.Receive(i * kPeriod).empty(), !sent);
      count += !sent;
    }
    const Interval interval = ClopperPearson(count, kTakes, 0.999);
    EXPECT_LE(interval.low, lost);
    EXPECT_GE(interval.high, lost);
  }
}

TEST(ImageLink, NoneAndAllAreLostAtTheEnds) {
  ImageLink none(Losing(0.0), 3), all(Losing(1.0), 3);
  for (int i = 0; i < 5000; ++i) {
    ASSERT_TRUE(none.Send(Picture(1), i));
    ASSERT_FALSE(all.Send(Picture(1), i));
    ASSERT_TRUE(all.Receive(i).empty());
  }
}

std::vector<bool> Losses(double lost, std::uint64_t seed) {
  ImageLink link(Losing(lost), seed);
  std::vector<bool> losses;
  for (int i = 0; i < 500; ++i) losses.push_back(!link.Send(Picture(1), i));
  return losses;
}

// What is lost at a low probability is lost at a higher one too: runs compare pair by pair.
TEST(ImageLink, LossesFollowFromTheSeed) {
  EXPECT_EQ(Losses(0.2, 5), Losses(0.2, 5));
  EXPECT_NE(Losses(0.2, 5), Losses(0.2, 6));
  const std::vector<bool> few = Losses(0.2, 5), many = Losses(0.4, 5);
  EXPECT_NE(few, many);
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_TRUE(!few[i] || many[i]) << i;
}

TEST(CameraFaults, EachEyeHasItsOwn) {
  CameraFaults faults;
  faults.window_m = 0.03;
  faults.pupil_m = 1e-3;
  faults.left.cover_share = 0.4;
  faults.left.cover_side_rad = 1.5;
  faults.right.dust_share = 0.2;
  faults.right.dust_clump_m = 5e-4;
  faults.right.dust_scatter = 0.1;
  faults.left.picture = EyeFaults::Picture::kDark;
  faults.right.picture = EyeFaults::Picture::kNone;
  const SensorOptions sensor = WithFaults({.read_noise_e = 3.0}, faults, 1);
  EXPECT_EQ(sensor.read_noise_e, 3.0);
  const WindowOptions &left = sensor.windows[0], &right = sensor.windows[1];
  EXPECT_EQ(left.cover_share, 0.4);
  EXPECT_EQ(left.cover_side_rad, 1.5);
  EXPECT_EQ(left.dust_share, 0.0);
  EXPECT_EQ(right.cover_share, 0.0);
  EXPECT_EQ(right.dust_share, 0.2);
  EXPECT_EQ(right.dust_clump_m, 5e-4);
  EXPECT_EQ(right.dust_scatter, 0.1);
  for (const WindowOptions& window : sensor.windows) {
    EXPECT_EQ(window.distance_m, 0.03);
    EXPECT_EQ(window.pupil_m, 1e-3);
  }
  EXPECT_EQ(sensor.eyes[0], EyeState::kDark);
  EXPECT_EQ(sensor.eyes[1], EyeState::kSilent);
}

TEST(CameraFaults, DustDiffersFromEyeToEyeAndFromRunToRun) {
  const SensorOptions one = WithFaults({}, {}, 1), same = WithFaults({}, {}, 1);
  const SensorOptions other = WithFaults({}, {}, 2);
  EXPECT_EQ(one.windows[0].dust_key, same.windows[0].dust_key);
  EXPECT_NE(one.windows[0].dust_key, one.windows[1].dust_key);
  EXPECT_NE(one.windows[0].dust_key, other.windows[0].dust_key);
}

}  // namespace
}  // namespace dockyard
