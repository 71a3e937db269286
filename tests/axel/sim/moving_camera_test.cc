// The image of a moving rover: what moves in it, and that a standing one sees as without shutter.
#include <gtest/gtest.h>

#include "axel/sim/scenarios.h"
#include "sim/axel/axel_plant.h"
#include "sim/axel/exposure.h"
#include "sim/axel/load_models.h"
#include "support/line_shift.h"

namespace dockyard::axel {
namespace {

std::unique_ptr<AxelPlant> Plant(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.end(),
                   {"start.r_m=2.5", "camera.width_px=320", "camera.height_px=240"});
  const Scenario scenario = TypicalScenario(overrides);
  return std::make_unique<AxelPlant>(scenario, Build(scenario), std::make_shared<KeptRenderer>());
}

Commands Rolling(double left_rad_s, double right_rad_s) {
  Commands commands = BrakedCommands();
  for (int i = 0; i < 2; ++i) {
    commands.motors[static_cast<std::size_t>(i)] = {.mode = MotorMode::kVelocity,
                                                    .target = i == 0 ? left_rad_s : right_rad_s,
                                                    .accel_rad_s2 = 0.3,
                                                    .current_limit_a = 3.0};
  }
  return commands;
}

void Hold(AxelPlant& plant, const Commands& commands, double seconds) {
  for (int i = 0; i < seconds / (kControlPeriod * kTickSeconds); ++i) plant.Advance(commands);
  plant.RefreshTruth();
}

double TurnBetween(const Pose3& a, const Pose3& b) {
  return Eigen::AngleAxisd(Eigen::Matrix3d(a.R.transpose() * b.R)).angle();
}

// Half a period on from before and half a period back from behind meet, far nearer than the
// rover has moved meanwhile.
TEST(MovingCamera, MovesOnAsTheWorldDoes) {
  const auto plant = Plant();
  const Commands turning = Rolling(0.1, 0.3);
  Hold(*plant, turning, 3.0);
  const Truth before = plant->truth();
  plant->Advance(turning);
  plant->RefreshTruth();
  const Truth after = plant->truth();
  const double half_s = 0.5 * kControlPeriod * kTickSeconds;
  const Truth on = MovedOn(before, half_s), back = MovedOn(after, -half_s);
  struct Part {
    Pose3 before, after, on, back;
  };
  for (const Part& part :
       {Part{before.X_WR, after.X_WR, on.X_WR, back.X_WR},
        Part{before.X_WA, after.X_WA, on.X_WA, back.X_WA},
        Part{before.X_W_left_wheel, after.X_W_left_wheel, on.X_W_left_wheel, back.X_W_left_wheel},
        Part{before.X_W_right_wheel, after.X_W_right_wheel, on.X_W_right_wheel,
             back.X_W_right_wheel}}) {
    const double moved_m = (part.after.p - part.before.p).norm();
    EXPECT_GT(moved_m, 1e-4);
    EXPECT_LT((part.on.p - part.back.p).norm(), 0.2 * moved_m);
    EXPECT_LT(TurnBetween(part.on, part.back), 0.2 * TurnBetween(part.before, part.after) + 2e-4);
  }
}

StereoImages PairOf(AxelPlant& plant) {
  StereoImages pair;
  for (CameraImage& image : plant.TakeImages({kLeftCamera, kRightCamera}, 0.0)) {
    (image.camera == kLeftCamera ? pair.left : pair.right) = std::get<GrayImage>(image.pixels);
  }
  return pair;
}

TEST(MovingCamera, StandingItSeesAsWithoutShutterToTheBit) {
  const auto fast = Plant({"changes.robot.cameras.sensor.shutter_s=0"});
  const auto slow = Plant({"changes.robot.cameras.sensor.shutter_s=0.02"});
  for (AxelPlant* plant : {fast.get(), slow.get()}) Hold(*plant, BrakedCommands(), 3.0);
  const StereoImages a = PairOf(*fast), b = PairOf(*slow);
  EXPECT_EQ(a.left.pixels, b.left.pixels);
  EXPECT_EQ(a.right.pixels, b.right.pixels);
}

TEST(MovingCamera, StandingARollingShutterGivesTheSameBits) {
  const auto whole = Plant();
  const auto rolling = Plant({"changes.robot.cameras.sensor.readout_s=0.05"});
  for (AxelPlant* plant : {whole.get(), rolling.get()}) Hold(*plant, BrakedCommands(), 3.0);
  EXPECT_EQ(PairOf(*whole), PairOf(*rolling));
}

// Upright edges lean: the upper rows are of earlier, the lower ones of later.
TEST(MovingCamera, TurningTheRowsOfARollingShutterAreThoseOfTheirTimes) {
  std::vector<std::string> keys{"changes.robot.cameras.sensor.shutter_s=0",
                                "changes.robot.cameras.sensor.full_well_e=1e6",
                                "changes.robot.cameras.sensor.exposure.rule=fixed",
                                "changes.robot.cameras.sensor.exposure.fixed_e=9e5"};
  const auto whole = Plant(keys);
  keys.emplace_back("changes.robot.cameras.sensor.readout_s=0.05");
  const auto rolling = Plant(keys);
  for (AxelPlant* plant : {whole.get(), rolling.get()}) Hold(*plant, Rolling(-0.3, 0.3), 3.0);
  const double rows_px =
      rolling->built().built_rig.left.focal_px().x() * rolling->truth().w_WR_W.z() * 0.05;
  ASSERT_GT(rows_px, 0.5);
  const GrayImage now = PairOf(*whole).left, image = PairOf(*rolling).left;
  for (const int part : {1, 2, 3}) {  // the uppermost rows show sky
    const double time = (part + 0.5) / 4.0 - 0.5;
    EXPECT_NEAR(ShiftOfRows_px(image, now, part * 60, part * 60 + 60), time * rows_px,
                0.12 * rows_px)
        << part;
  }
}

TEST(MovingCamera, StandingThePairBeforeSetsTheSameExposure) {
  for (const std::string left : {"normal", "dark", "none"}) {
    const std::string fault = "camera.left.picture=" + left;
    const auto itself = Plant({fault});
    const auto before = Plant({fault, "changes.robot.cameras.sensor.exposure.by=before"});
    for (const double stops : {0.0, 2.0, -1.0, 0.0}) {
      const auto images = [&](AxelPlant& plant) {
        std::vector<GrayImage> all;
        for (CameraImage& image : plant.TakeImages({kLeftCamera, kRightCamera}, stops)) {
          all.push_back(std::get<GrayImage>(image.pixels));
        }
        return all;
      };
      EXPECT_EQ(images(*before), images(*itself)) << left << " " << stops;
    }
  }
}

TEST(MovingCamera, DrivingItSeesLessSharplyTheLongerTheShutterIsOpen) {
  const auto fast = Plant({"changes.robot.cameras.sensor.shutter_s=0"});
  const auto slow = Plant({"changes.robot.cameras.sensor.shutter_s=0.02"});
  for (AxelPlant* plant : {fast.get(), slow.get()}) Hold(*plant, Rolling(0.1, 0.3), 3.0);
  EXPECT_EQ(BoardMotion_px(fast->truth(), fast->built(), 0.0), 0.0);
  EXPECT_GT(BoardMotion_px(slow->truth(), slow->built(), 0.02), 0.25);
  EXPECT_NE(PairOf(*fast).left.pixels, PairOf(*slow).left.pixels);
}

TEST(MovingCamera, InterlacedItsEvenLinesAreAFieldBeforeItsOddOnesAndStandingAllAreOfNow) {
  std::vector<std::string> keys{"changes.robot.cameras.sensor.shutter_s=0",
                                "changes.robot.cameras.sensor.full_well_e=1e6",
                                "changes.robot.cameras.sensor.exposure.rule=fixed",
                                "changes.robot.cameras.sensor.exposure.fixed_e=9e5"};
  const auto whole = Plant(keys);
  keys.emplace_back("changes.robot.cameras.sensor.video.fields=interlaced");
  const auto video = Plant(keys);
  for (AxelPlant* plant : {whole.get(), video.get()}) Hold(*plant, BrakedCommands(), 1.0);
  EXPECT_EQ(PairOf(*video), PairOf(*whole));
  for (AxelPlant* plant : {whole.get(), video.get()}) Hold(*plant, Rolling(-0.3, 0.3), 3.0);
  // Of an equidistant lens that turns to the left: things go right by focal length times turn.
  const double turning_rad_s = video->truth().w_WR_W.z();
  const double field_px = video->built().built_rig.left.focal_px().x() * turning_rad_s / 60.0;
  ASSERT_GT(field_px, 0.2);
  const GrayImage now = PairOf(*whole).left, lines = PairOf(*video).left;
  EXPECT_NEAR(ShiftOfLines_px(lines, now, 0), -0.5 * field_px, 0.1 * field_px);
  EXPECT_NEAR(ShiftOfLines_px(lines, now, 1), 0.5 * field_px, 0.1 * field_px);
}

}  // namespace
}  // namespace dockyard::axel
