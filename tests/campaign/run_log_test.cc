#include "sim/log/run_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include "campaign/fake_runs.h"
#include "models/random.h"
#include "sim/log/sheet_json.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

GrayImage NoisyImage(int width, int height, std::uint64_t key) {
  RandomStream draw(key);
  GrayImage image{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    image.pixels.push_back(static_cast<std::uint8_t>(draw.NextBits()));
  }
  return image;
}

RoverSheet SomeSheet() {
  RandomStream draw(5);
  RoverSheet sheet;
  sheet.rig.left = EquidistantCamera(640, 480, Radians(90.0));
  sheet.rig.right = sheet.rig.left;
  std::get<KannalaBrandt>(sheet.rig.right.lens).k = {draw.Normal(), 1e-300, -0.0, 1.0 / 3.0};
  sheet.rig.X_RL.R = RotZ(draw.Normal()) * RotX(draw.Normal());
  sheet.rig.X_RL.p = Eigen::Vector3d(0.1, 0.2, draw.Normal());
  sheet.board.width_m = 0.9;
  sheet.board.fiducials = {{Eigen::Vector2d(0.1, -0.2), kPi / 4}, {Eigen::Vector2d(0.3, 0.1), 0.0}};
  for (MotorSheet& motor : sheet.motors) motor.rad_per_count = draw.Uniform();
  sheet.track_m = 0.85;
  return sheet;
}

SensorFrame SomeFrame(Tick tick) {
  RandomStream draw(static_cast<std::uint64_t>(tick) + 1);
  SensorFrame frame;
  frame.tick = tick;
  frame.imu.roll_rad = draw.Normal();
  frame.imu.specific_force_R = Eigen::Vector3d(draw.Normal(), -0.0, 9.81);
  frame.encoder_counts = {-5, 1ll << 62, 0, tick};
  frame.current_a = {draw.Uniform(), 5e-324, 0.0, 1.0};
  if (tick % 60 == 0) {
    const auto key = static_cast<std::uint64_t>(tick);
    frame.images = StereoImages{NoisyImage(64, 48, key), NoisyImage(64, 48, key + 1)};
  }
  return frame;
}

/// Answers from all it has seen so far, images included.
class MixingController : public Controller {
 public:
  Commands Step(const SensorFrame& sensed) override {
    sum_ += sensed.imu.roll_rad + sensed.current_a[0];
    if (sensed.images) sum_ += 1e-3 * sensed.images->right.pixels[17];
    Commands commands;
    commands.motors[2] = {MotorMode::kPosition, sum_, 1.0, 0.5, 2.0};
    commands.take_images = sensed.tick % 60 == 40;
    return commands;
  }
  const Belief& belief() const override { return belief_; }

 private:
  double sum_ = 0.0;
  Belief belief_;
};

void WriteLog(const std::filesystem::path& dir, int entries, bool keep_images = true,
              bool finish = true) {
  RunLogWriter writer(dir, {17, 0xffffffffffffffffull, "axel", keep_images, SomeSheet()});
  MixingController controller;
  for (int i = 0; i < entries; ++i) {
    const SensorFrame frame = SomeFrame(20 * i);
    writer.Append(frame, controller.Step(frame));
  }
  if (finish) writer.Finish();
}

std::string FrameBytes(const SensorFrame& frame) {
  std::string bytes;
  PutFrame(bytes, frame, true);
  return bytes;
}

std::string ErrorOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

TEST(RunLog, GivesBackEveryFrameBitForBit) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 30);
  const RunLog log = ReadRunLog(folder.path());
  ASSERT_EQ(log.entries.size(), 30u);
  EXPECT_TRUE(log.complete);
  for (std::size_t i = 0; i < log.entries.size(); ++i) {
    const SensorFrame frame = SomeFrame(static_cast<Tick>(20 * i)), &read = log.entries[i].sensed;
    EXPECT_EQ(FrameBytes(read), FrameBytes(frame));
    EXPECT_EQ(read.images, frame.images);
    EXPECT_EQ(read.encoder_counts, frame.encoder_counts);
    EXPECT_EQ(read.imu.roll_rad, frame.imu.roll_rad);
    EXPECT_TRUE(std::signbit(read.imu.specific_force_R.y()));
  }
}

TEST(RunLog, GivesBackTheCommands) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 5);
  MixingController controller;
  for (const RunLogEntry& entry : ReadRunLog(folder.path()).entries) {
    EXPECT_EQ(entry.commands, controller.Step(entry.sensed));
  }
}

TEST(RunLog, HoldsTheSheetThatTheControllerWasGiven) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 1);
  const RunLogHeader header = ReadRunLog(folder.path()).header;
  EXPECT_EQ(header.run, 17);
  EXPECT_EQ(header.seed, 0xffffffffffffffffull);
  EXPECT_EQ(header.controller, "axel");
  EXPECT_EQ(ToJson(header.sheet).dump(), ToJson(SomeSheet()).dump());
  EXPECT_EQ(header.sheet.rig.X_RL.R, SomeSheet().rig.X_RL.R);
  EXPECT_EQ(header.sheet.rig.right, SomeSheet().rig.right);
}

TEST(RoverSheetJson, ReadsBackEachLensModelAndPipeline) {
  RoverSheet sheet = SomeSheet();
  sheet.vision = {VisionPipeline::kTsai2013, 5};
  for (const Lens& lens : {Lens(KannalaBrandt{.fx = 1.0}), Lens(BrownPinhole{.k3 = 2.0}),
                           Lens(Cahvore{.linearity = 0.5})}) {
    sheet.rig.left.lens = lens;
    const RoverSheet read = SheetFromJson(ToJson(sheet));
    EXPECT_EQ(read.rig.left, sheet.rig.left);
    EXPECT_EQ(read.vision, sheet.vision);
  }
}

TEST(RoverSheetJson, RefusesALensModelOrPipelineThatItDoesNotKnow) {
  const auto error_of = [](const char* part, const char* key, const char* name) {
    Json json = ToJson(SomeSheet());
    json[part][key] = name;
    return ErrorOf([&] { SheetFromJson(json); });
  };
  EXPECT_EQ(error_of("left_camera", "model", "mei"),
            "lens model: expected kannala_brandt, brown or cahvore, found 'mei'");
  EXPECT_EQ(error_of("vision", "pipeline", "tsai2014"),
            "vision pipeline: expected dockyard or tsai2013, found 'tsai2014'");
  EXPECT_EQ(error_of("vision", "pipeline", "dockyard"), "no error");
}

TEST(RunLog, WithAHeaderOfUnknownNamesIsRefusedWithItsPath) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 1);
  std::string bytes = ReadText(folder.path() / "frames.bin");
  const std::size_t at = bytes.find("kannala_brandt");
  ASSERT_NE(at, std::string::npos);
  bytes[at] = 'K';
  WriteText(folder.path() / "frames.bin", bytes);
  EXPECT_THAT(ErrorOf([&] { ReadRunLog(folder.path()); }),
              testing::AllOf(HasSubstr("frames.bin: "), HasSubstr("found 'Kannala_brandt'")));
}

TEST(RunLog, CutShortEndsAtTheLastWholeEntry) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 3);
  const std::string whole = ReadText(folder.path() / "frames.bin");
  std::size_t most = 0;
  for (std::size_t cut = 1; cut < whole.size(); cut += 97) {
    WriteText(folder.path() / "frames.bin", whole.substr(0, whole.size() - cut));
    try {
      const RunLog log = ReadRunLog(folder.path());
      EXPECT_FALSE(log.complete);
      most = std::max(most, log.entries.size());
    } catch (const LogError&) {  // cut into the header
    }
  }
  EXPECT_EQ(most, 3u);
}

TEST(RunLog, WithoutFinishIsNotComplete) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 4, true, /*finish=*/false);
  const RunLog log = ReadRunLog(folder.path());
  EXPECT_EQ(log.entries.size(), 4u);
  EXPECT_FALSE(log.complete);
}

// Damage may go unnoticed in a number, but it must never crash the reader or eat the memory.
TEST(RunLog, DamagedAnywhereIsReadOrRefused) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 4);
  const std::string whole = ReadText(folder.path() / "frames.bin");
  RandomStream draw(99);
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    const double at = draw.Uniform(0.0, static_cast<double>(whole.size()));
    damaged[static_cast<std::size_t>(at)] ^= static_cast<char>(1 + draw.NextBits() % 255);
    WriteText(folder.path() / "frames.bin", damaged);
    try {
      (void)ReadRunLog(folder.path());
    } catch (const LogError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 10);
}

TEST(RunLog, OfAnotherKindIsRefusedWithASentence) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "frames.bin").string();
  const auto read = [&] { (void)ReadRunLog(folder.path()); };
  EXPECT_EQ(ErrorOf(read), "cannot read " + file + ": No such file or directory");
  WriteText(file, "");
  EXPECT_EQ(ErrorOf(read), file + ": it is not a run log");
  WriteText(file, std::string("DOCKLOG\n") + '\2' + std::string(3, '\0'));
  EXPECT_EQ(ErrorOf(read), file + ": its version is 2, this program reads 1");
}

TEST(RunLog, OnAFullDiskSaysSo) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/full", folder.path() / "frames.bin");
  const std::string error = ErrorOf([&] { WriteLog(folder.path(), 60); });
  EXPECT_THAT(error, HasSubstr("No space left on device"));
}

TEST(RunLog, InAnUnwritableFolderSaysSo) {
  EXPECT_THAT(ErrorOf([] { WriteLog("/proc/no/such", 1); }),
              HasSubstr("cannot make folder /proc/no/such"));
}

TEST(ControllerReplay, OfTheSameControllerGivesTheSameCommands) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 30);
  RunLogReader log(folder.path());
  MixingController controller;
  const ControllerReplay replay = ReplayController(log, controller);
  EXPECT_TRUE(replay.same());
  EXPECT_EQ(replay.compared, 30u);
}

TEST(ControllerReplay, NamesTheFirstTickThatDiffers) {
  class Hesitant : public MixingController {
   public:
    Commands Step(const SensorFrame& sensed) override {
      Commands commands = MixingController::Step(sensed);
      if (sensed.tick >= 200)
        commands.motors[2].target = std::nextafter(commands.motors[2].target, 9);
      return commands;
    }
  };
  const TemporaryFolder folder;
  WriteLog(folder.path(), 30);
  RunLogReader log(folder.path());
  Hesitant controller;
  const ControllerReplay replay = ReplayController(log, controller);
  EXPECT_FALSE(replay.same());
  EXPECT_EQ(replay.differs_at, 200);
  EXPECT_EQ(replay.compared, 10u);
}

TEST(ControllerReplay, StopsWhereTheLogLeftTheImagesOut) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 30, /*keep_images=*/false);
  RunLogReader log(folder.path());
  MixingController controller;
  const ControllerReplay replay = ReplayController(log, controller);
  EXPECT_FALSE(replay.same());
  EXPECT_EQ(replay.blind_at, 0);
}

TEST(ControllerReplay, TakesACommandThatIsNotANumberForEqualToItself) {
  class Lost : public MixingController {
   public:
    Commands Step(const SensorFrame&) override {
      Commands commands;
      commands.motors[0].target = std::numeric_limits<double>::quiet_NaN();
      return commands;
    }
  };
  const TemporaryFolder folder;
  Lost lost;
  {
    RunLogWriter writer(folder.path(), {1, 1, "lost", true, SomeSheet()});
    writer.Append(SomeFrame(20), lost.Step({}));
    writer.Finish();
  }
  RunLogReader log(folder.path());
  EXPECT_TRUE(ReplayController(log, lost).same());
}

}  // namespace
}  // namespace dockyard
