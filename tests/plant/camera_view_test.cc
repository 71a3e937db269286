// The images of single cameras in a room with a dock.
#include "sim/plant/camera_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include "plant/dock_room.h"
#include "render/exposure_rule.h"
#include "render/measure.h"
#include "render/optics.h"
#include "render/shutter.h"

namespace dockyard {
namespace {

CameraModel SmallCamera(bool colour = false) {
  CameraModel model;
  model.name = "front";
  model.colour = colour;
  model.nominal = {.width = 160,
                   .height = 120,
                   .lens = BrownPinhole{.fx = 120, .fy = 120, .cx = 79.5, .cy = 59.5}};
  model.X_LC = ForwardCamera(0.1, 0.0, 0.25);
  model.sensor.full_well_e = 5500.0;
  model.sensor.read_noise_e = 10.0;
  model.sensor.blur_sigma_px = 0.7;
  model.sensor.shutter_s = 0.01;
  return model;
}

ColourTable Grey() {
  SceneSpectra spectra;
  spectra.materials = {EvenGrey(0.4)};
  return MakeColourTable(spectra, CheapCamera());
}

struct Shot {
  DockRoom room;
  StereoRenderer renderer;
  CameraImage Take(SimulatedCamera& view, const CameraMotion& motion, Tick now = 0,
                   const SimulatedCamera::Conditions& conditions = {}) {
    static const ColourTable colours = Grey();
    return view.Take(
        renderer, [&](double) { return room.SceneAt(motion.X_WC); }, &colours, motion, now,
        conditions);
  }
};

const GrayImage& GreyOf(const CameraImage& image) { return std::get<GrayImage>(image.pixels); }

TEST(SimulatedCamera, GivesTheSameBitsForTheSameSeedAndOtherNoiseInEachImage) {
  Shot shot;
  const CameraMotion motion{shot.room.CameraAt(1.0)};
  SimulatedCamera one(SmallCamera(), 7, 2), again(SmallCamera(), 7, 2), other(SmallCamera(), 8, 2);
  const CameraImage first = shot.Take(one, motion, 30);
  EXPECT_EQ(first.camera, 2);
  EXPECT_EQ(first.exposed, 30);
  EXPECT_EQ(first.exposure_s, 0.01);
  EXPECT_EQ(GreyOf(first), GreyOf(shot.Take(again, motion)));
  EXPECT_NE(GreyOf(first), GreyOf(shot.Take(one, motion)));
  EXPECT_NE(GreyOf(first), GreyOf(shot.Take(other, motion)));
}

double Sharpness(const GrayImage& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 1; x < image.width; ++x) {
      sum += std::pow(image.at(x, y) - image.at(x - 1, y), 2.0);
    }
  }
  return sum;
}

TEST(SimulatedCamera, ATurningCameraBlursAsItsShutterIsOpen) {
  Shot shot;
  CameraMotion motion{shot.room.CameraAt(0.6)};
  CameraModel model = SmallCamera();
  model.sensor.full_well_e = 1e6;  // hardly any noise
  SimulatedCamera still(model, 7, 0), turning(model, 7, 0);
  const double sharp = Sharpness(GreyOf(shot.Take(still, motion)));
  motion.w_WC_W = {0.0, 0.0, 3.0};  // 3.6 px
  EXPECT_LT(Sharpness(GreyOf(shot.Take(turning, motion))), 0.7 * sharp);
}

TEST(SimulatedCamera, ACentreOffTheLinksOriginMovesByItsTurning) {
  const CameraMotion motion =
      CameraOnLink(Pose3::Translation(0.5, 0.0, 0.0), {RotZ(kPi / 2), {1.0, 2.0, 0.0}}, {0.1, 0, 0},
                   {0.0, 0.0, 2.0});
  EXPECT_TRUE(motion.X_WC.p.isApprox(Eigen::Vector3d(1.0, 2.5, 0.0), 1e-12));
  EXPECT_TRUE(motion.v_WC_W.isApprox(Eigen::Vector3d(0.1 - 1.0, 0.0, 0.0), 1e-12));
}

TEST(SimulatedCamera, ColourCameraOfAGreyRoomGivesGreyAndSettlesItsExposure) {
  Shot shot;
  SimulatedCamera view(SmallCamera(true), 7, 1);
  const CameraImage image = shot.Take(view, {shot.room.CameraAt(1.0)});
  const RgbImage& rgb = std::get<RgbImage>(image.pixels);
  ASSERT_EQ(rgb.pixels.size(), 3u * 160 * 120);
  double sums[3] = {};
  for (std::size_t i = 0; i < rgb.pixels.size(); ++i) sums[i % 3] += rgb.pixels[i];
  const double mean = (sums[0] + sums[1] + sums[2]) / (3.0 * 160 * 120);
  EXPECT_GT(mean, 50.0);
  EXPECT_LT(mean, 200.0);
  for (const double sum : sums) EXPECT_NEAR(sum / (160 * 120), mean, 6.0);
}

TEST(SimulatedCamera, BuiltCameraIsOffByItsSigmas) {
  CameraModel model = SmallCamera();
  model.errors = {.rotation_sigma_rad = 0.01,
                  .place_sigma_m = 0.002,
                  .lens = {.focal_sigma = 0.003, .centre_sigma_px = 2.0, .radial_sigma_px = 0.0}};
  constexpr int kSeeds = 2000;
  Eigen::Vector3d turns = Eigen::Vector3d::Zero(), shifts = turns;
  double focal = 0.0, centre = 0.0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const BuiltOne built = BuiltCamera(model, seed, "camera front");
    const Eigen::Matrix3d off = model.X_LC.R.transpose() * built.X_LC.R;
    turns += Eigen::Vector3d(off(2, 1), off(0, 2), off(1, 0)).cwiseAbs2();
    shifts += (built.X_LC.p - model.X_LC.p).cwiseAbs2();
    focal += std::pow(built.camera.focal_px().x() / 120.0 - 1.0, 2.0);
    centre += std::pow(built.camera.centre_px().x() - 79.5, 2.0);
  }
  const auto rms = [](double sum) { return std::sqrt(sum / kSeeds); };
  for (int i = 0; i < 3; ++i) {  // 2 000 draws tell a sigma within 1.6 % (1 sigma)
    EXPECT_NEAR(rms(turns[i]), 0.01, 0.0007);
    EXPECT_NEAR(rms(shifts[i]), 0.002, 0.00014);
  }
  EXPECT_NEAR(rms(focal), 0.003, 0.0002);
  EXPECT_NEAR(rms(centre), 2.0, 0.14);
}

TEST(SimulatedCamera, FaultsChangeTheSensor) {
  Shot shot;
  SimulatedCamera view(SmallCamera(), 7, 0);
  const CameraMotion motion{shot.room.CameraAt(1.0)};
  const auto mean = [&](const SimulatedCamera::Conditions& conditions) {
    double sum = 0.0;
    const GrayImage image = GreyOf(shot.Take(view, motion, 0, conditions));
    for (const std::uint8_t p : image.pixels) sum += p;
    return sum / (160 * 120);
  };
  const double clean = mean({});
  const auto half = [](SensorOptions& sensor) {
    sensor.fixed_exposure_e = 5000.0;
    sensor.windows[0] = {.distance_m = 0.01, .pupil_m = 0.002, .cover_share = 0.5};
  };
  const auto open = [](SensorOptions& sensor) { sensor.fixed_exposure_e = 5000.0; };
  EXPECT_GT(clean, 0.0);
  EXPECT_NEAR(mean({.faults = half}) / mean({.faults = open}), 0.5, 0.15);
}

TEST(SimulatedCamera, LinesOfInterlacedVideoAreThoseOfItsPosesAHalfFieldBeforeAndAfter) {
  Shot shot;
  CameraMotion motion{shot.room.CameraAt(0.6)};
  motion.v_WC_W = {0.0, 0.3, 0.0};
  motion.w_WC_W = {0.0, 0.0, 0.5};  // 1 px from field to field
  CameraModel model = SmallCamera();
  model.sensor.shutter_s = 0.0;
  model.sensor.blur_sigma_px = 0.0;
  model.sensor.exposure = {.rule = ExposureRule::kFixed, .fixed_e = 4000.0};
  const auto at = [&](double seconds) {
    SimulatedCamera whole(model, 7, 0);
    const Pose3 X_WC = MovedOn(motion.X_WC, motion.v_WC_W, motion.w_WC_W, seconds);
    return GreyOf(shot.Take(whole, {X_WC}));
  };
  const GrayImage before = at(-1.0 / 120.0), after = at(1.0 / 120.0);
  model.sensor.video.fields = VideoFields::kInterlaced;
  SimulatedCamera video(model, 7, 0);
  const GrayImage image = GreyOf(shot.Take(video, motion));
  EXPECT_NE(before, after);
  for (int y = 0; y < image.height; ++y) {
    const GrayImage& whole = y % 2 == 0 ? before : after;
    for (int x = 0; x < image.width; ++x)
      ASSERT_EQ(image.at(x, y), whole.at(x, y)) << x << " " << y;
  }
}

TEST(SimulatedCamera, OfACameraAtRestInterlacedVideoIsTheWholeImage) {
  Shot shot;
  const CameraMotion motion{shot.room.CameraAt(0.6)};
  CameraModel model = SmallCamera();
  SimulatedCamera whole(model, 7, 0);
  model.sensor.video.fields = VideoFields::kInterlaced;
  SimulatedCamera video(model, 7, 0);
  EXPECT_EQ(GreyOf(shot.Take(video, motion)), GreyOf(shot.Take(whole, motion)));
}

TEST(SimulatedCamera, ItsSecondImageHasTheExposureOfTheRuleOnTheFirst) {
  Shot shot;
  const CameraMotion near{shot.room.CameraAt(0.4)}, far{shot.room.CameraAt(2.0)};
  CameraModel model = SmallCamera();
  const CameraModel same = model;
  model.sensor.exposure.by = ExposureBy::kBefore;
  SimulatedCamera before(model, 7, 0), itself(same, 7, 0);
  EXPECT_EQ(GreyOf(shot.Take(before, near)), GreyOf(shot.Take(itself, near)));
  // The rule on the first image's light.
  const SensorOptions sensor = CameraSensor(model, 7, 0, "camera front");
  RadianceImage light =
      shot.renderer.RenderGrey(shot.room.SceneAt(near.X_WC), before.built(), near.X_WC);
  ApplyOptics(before.built(), sensor, light);
  CameraModel fixed = model;
  fixed.sensor.exposure = {.rule = ExposureRule::kFixed,
                           .fixed_e = ElectronsOfRadiance({&light, 1}, sensor)};
  SimulatedCamera by_hand(fixed, 7, 0);
  shot.Take(by_hand, near);
  const GrayImage second = GreyOf(shot.Take(before, far));
  EXPECT_EQ(second, GreyOf(shot.Take(by_hand, far)));
  EXPECT_NE(second, GreyOf(shot.Take(itself, far)));
}

TEST(SimulatedCamera, RowsOfARollingShutterAreThoseOfTheirTimes) {
  Shot shot;
  CameraMotion motion{shot.room.CameraAt(0.6)};
  motion.v_WC_W = {0.0, 0.3, 0.0};
  motion.w_WC_W = {0.0, 0.0, 2.0};  // 9 px in the readout
  CameraModel model = SmallCamera();
  model.sensor.shutter_s = 0.0;
  model.sensor.full_well_e = 1e6;
  model.sensor.exposure = {.rule = ExposureRule::kFixed, .fixed_e = 9e5};
  const auto at = [&](double seconds) {
    SimulatedCamera whole(model, 7, 0);
    const Pose3 X_WC = MovedOn(motion.X_WC, motion.v_WC_W, motion.w_WC_W, seconds);
    return GreyOf(shot.Take(whole, {X_WC}));
  };
  const GrayImage now = at(0.0);
  model.sensor.readout_s = 0.03;
  SimulatedCamera rolling(model, 7, 0);
  const GrayImage image = GreyOf(shot.Take(rolling, motion));
  model.sensor.readout_s = 0.0;
  // Of the board's upper and lower half: further up and down all is even.
  for (const int first : {30, 70}) {
    double off = 0.0, moved = 0.0;
    for (int y = first; y < first + 30; ++y) {
      const GrayImage then = at(0.03 * ((y + 0.5) / 120.0 - 0.5));
      for (int x = 0; x < image.width; ++x) {
        off += std::pow(image.at(x, y) - then.at(x, y), 2.0);
        moved += std::pow(now.at(x, y) - then.at(x, y), 2.0);
      }
    }
    EXPECT_LT(std::sqrt(off), 0.35 * std::sqrt(moved)) << "from row " << first;
  }
}

TEST(SimulatedCamera, OfACameraAtRestARollingShutterGivesTheWholeImage) {
  Shot shot;
  const CameraMotion motion{shot.room.CameraAt(0.6)};
  CameraModel model = SmallCamera();
  SimulatedCamera whole(model, 7, 0);
  model.sensor.readout_s = 0.05;
  SimulatedCamera rolling(model, 7, 0);
  EXPECT_EQ(GreyOf(shot.Take(rolling, motion)), GreyOf(shot.Take(whole, motion)));
}

TEST(SimulatedCamera, ItsHotPixelsShineWithTheShutter) {
  Shot shot;
  const CameraMotion motion{shot.room.CameraAt(1.0)};
  CameraModel model = SmallCamera();
  model.sensor.read_noise_e = 0.0;
  model.sensor.defects = {.hot_share = 0.02, .hot_rate_e_per_s = 1e5};
  model.sensor.exposure = {.rule = ExposureRule::kFixed, .fixed_e = 1e-6};  // no light
  const auto sum_of = [&](double shutter_s) {
    model.sensor.shutter_s = shutter_s;
    SimulatedCamera camera(model, 7, 0);
    double sum_e = 0.0;
    const GrayImage image = GreyOf(shot.Take(camera, motion));
    for (const std::uint8_t p : image.pixels) sum_e += p * model.sensor.full_well_e / 255.0;
    return sum_e;
  };
  // 384 hot pixels of 500 and 1000 electrons, each law's mean within 5 %, 1 sigma.
  EXPECT_NEAR(sum_of(0.005), 384.0 * 500.0, 0.25 * 384.0 * 500.0);
  EXPECT_NEAR(sum_of(0.01) / sum_of(0.005), 2.0, 0.1);
  EXPECT_EQ(sum_of(0.0), 0.0);
}

TEST(SimulatedCamera, ItsLensRipplesAsItIsBuilt) {
  Shot shot;
  const CameraMotion motion{shot.room.CameraAt(0.6)};
  CameraModel model = SmallCamera();
  SimulatedCamera plain(model, 7, 0);
  model.errors.lens.ripple_px = 0.4;
  SimulatedCamera rippled(model, 7, 0);
  EXPECT_TRUE(plain.ripple().none());
  EXPECT_FALSE(rippled.ripple().none());
  EXPECT_EQ(plain.built(), rippled.built());
  EXPECT_NE(GreyOf(shot.Take(plain, motion)), GreyOf(shot.Take(rippled, motion)));
}

}  // namespace
}  // namespace dockyard
