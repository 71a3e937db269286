#include "sim/log/run_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <bit>
#include <cmath>
#include <functional>
#include <limits>

#include "sim/base/random.h"
#include "sim/log/logged_run.h"
#include "support/edited_log.h"
#include "support/fake_runs.h"
#include "support/foreign_log.h"

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

/// Nominal parameters of a robot that does not exist, with numbers that must keep their bits.
Json SomeNominal() {
  RandomStream draw(5);
  return {{"track_m", draw.Normal()}, {"tiny", 1e-300}, {"minus_zero", -0.0}, {"third", 1.0 / 3.0}};
}

SensorFrame SomeFrame(Tick tick) {
  RandomStream draw(static_cast<std::uint64_t>(tick) + 1);
  SensorFrame frame;
  frame.tick = tick;
  frame.imu.roll_rad = draw.Normal();
  frame.imu.specific_force_R = Eigen::Vector3d(draw.Normal(), -0.0, 9.81);
  frame.motors = {{-5, draw.Uniform()}, {1ll << 62, 5e-324}, {0, 0.0}, {tick, 1.0}};
  frame.values = {draw.Normal(), -0.0, static_cast<double>(tick)};
  if (tick % 60 == 0) {
    const auto key = static_cast<std::uint64_t>(tick);
    const GrayImage other = NoisyImage(3 * 64, 48, key + 1);
    frame.images = {{0, NoisyImage(64, 48, key), tick, 0.02},
                    {2, RgbImage{64, 48, other.pixels}, tick - 1234}};
  }
  return frame;
}

constexpr RobotShape kSomeRobot{.motors = 4, .cameras = 3, .sensors = 3};

struct WholeLog {
  RunLogHeader header;
  std::vector<RunLogEntry> entries;
  bool complete = false;
};
WholeLog ReadWholeLog(const std::filesystem::path& dir) {
  RunLogReader reader(dir);
  WholeLog log;
  log.header = reader.header();
  while (auto entry = reader.Next()) log.entries.push_back(std::move(*entry));
  log.complete = reader.complete();
  return log;
}

/// Answers from all it has seen so far, images included.
class MixingController : public Controller {
 public:
  Commands Step(const SensorFrame& sensed) override {
    sum_ += sensed.imu.roll_rad + sensed.motors[0].current_a;
    if (const RgbImage* image = RgbImageOf(sensed, 2)) sum_ += 1e-3 * image->pixels[17];
    Commands commands;
    commands.motors.resize(4);
    commands.switches = {1, 0};
    commands.motors[2] = {MotorMode::kPosition, sum_, 1.0, 0.5, 2.0};
    if (sensed.tick % 60 == 40) commands.take_images = {0, 2};
    if (sensed.tick % 120 == 100) commands.exposure_stops = -2.5;
    return commands;
  }
  const Belief& belief() const override { return belief_; }

 private:
  double sum_ = 0.0;
  Belief belief_;
};

void WriteLog(const std::filesystem::path& dir, int entries, bool keep_images = true,
              bool finish = true) {
  RunLogWriter writer(dir,
                      {17, 0xffffffffffffffffull, "toy", "mixing", keep_images, SomeNominal()});
  MixingController controller;
  for (int i = 0; i < entries; ++i) {
    const SensorFrame frame = SomeFrame(20 * i);
    writer.Append(frame, controller.Step(frame));
  }
  if (finish) writer.Finish();
}

std::string FrameBytes(const SensorFrame& frame) {
  std::string bytes;
  PutFrame(bytes, frame, ImageCoding::kRaw);
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
  const WholeLog log = ReadWholeLog(folder.path());
  ASSERT_EQ(log.entries.size(), 30u);
  EXPECT_TRUE(log.complete);
  for (std::size_t i = 0; i < log.entries.size(); ++i) {
    const SensorFrame frame = SomeFrame(static_cast<Tick>(20 * i)), &read = log.entries[i].sensed;
    EXPECT_EQ(FrameBytes(read), FrameBytes(frame));
    ASSERT_EQ(read.images.size(), frame.images.size());
    for (std::size_t k = 0; k < frame.images.size(); ++k) {
      EXPECT_EQ(read.images[k].exposed, frame.images[k].exposed);
    }
    ASSERT_EQ(read.images.size(), frame.images.size());
    EXPECT_EQ(read.motors[1].encoder_counts, frame.motors[1].encoder_counts);
    EXPECT_EQ(read.imu.roll_rad, frame.imu.roll_rad);
    EXPECT_TRUE(std::signbit(read.imu.specific_force_R.y()));
  }
}

TEST(RunLog, GivesBackTheCommands) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 10);
  MixingController controller;
  for (const RunLogEntry& entry : ReadWholeLog(folder.path()).entries) {
    EXPECT_EQ(entry.commands, controller.Step(entry.sensed));
  }
}

TEST(RunLog, HoldsTheNominalParametersThatTheControllerWasGiven) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 1);
  const RunLogHeader header = ReadWholeLog(folder.path()).header;
  EXPECT_EQ(header.run, 17);
  EXPECT_EQ(header.seed, 0xffffffffffffffffull);
  EXPECT_EQ(header.system, "toy");
  EXPECT_EQ(header.controller, "mixing");
  const Json nominal = SomeNominal();
  for (const char* key : {"track_m", "tiny", "minus_zero", "third"}) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(header.nominal[key].get<double>()),
              std::bit_cast<std::uint64_t>(nominal[key].get<double>()));
  }
}

TEST(RunLog, CutShortEndsAtTheLastWholeEntry) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 3);
  const std::string whole = Slurp(folder.path() / kRunLogFile);
  std::size_t most = 0;
  for (std::size_t cut = 1; cut < whole.size(); cut += 97) {
    WriteText(folder.path() / kRunLogFile, whole.substr(0, whole.size() - cut));
    try {
      const WholeLog log = ReadWholeLog(folder.path());
      EXPECT_FALSE(log.complete);
      most = std::max(most, log.entries.size());
    } catch (const DataError&) {  // cut into the header
    }
  }
  EXPECT_EQ(most, 3u);  // cut behind its last chunk
}

TEST(RunLog, WithoutFinishIsNotComplete) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 4, true, /*finish=*/false);
  const WholeLog log = ReadWholeLog(folder.path());
  EXPECT_EQ(log.entries.size(), 4u);
  EXPECT_FALSE(log.complete);
}

// No changed byte goes unseen: a damaged log never replays as the same.
TEST(RunLog, DamagedAnywhereIsRefusedOrCutShort) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 4);
  const std::string whole = Slurp(folder.path() / kRunLogFile);
  RandomStream draw(99);
  for (int i = 0; i < 1000; ++i) {
    std::string damaged = whole;
    const double at = draw.Uniform(0.0, static_cast<double>(whole.size()));
    damaged[static_cast<std::size_t>(at)] ^= static_cast<char>(1 + draw.NextBits() % 255);
    WriteText(folder.path() / kRunLogFile, damaged);
    try {
      EXPECT_FALSE(ReadWholeLog(folder.path()).complete) << at;
    } catch (const DataError&) {
    }
  }
}

TEST(RunLog, OfAnotherKindIsRefusedWithASentence) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / kRunLogFile).string();
  const auto read = [&] { (void)ReadWholeLog(folder.path()); };
  EXPECT_EQ(ErrorOf(read), "cannot read " + file + ": No such file or directory");
  WriteText(file, "");
  EXPECT_EQ(ErrorOf(read), file + ": it is no MCAP file");
  WriteLog(folder.path(), 1);
  EditLog(file, [](McapAttachment& each) {
    each.data.replace(each.data.find("\"version\":6"), 11, "\"version\":4");
  });
  EXPECT_EQ(ErrorOf(read), file + ": its version is 4, this program reads 5 to 6");
  EditLog(file, [](McapAttachment& each) { each.name = "other"; });
  EXPECT_EQ(ErrorOf(read),
            file +
                ": its header is missing: the attachment header.json (mcap filter keeps it with "
                "--include-attachments)");
}

TEST(RunLog, RefusesReadingsThatAreNotFinite) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (const bool of_motor : {false, true}) {
      const TemporaryFolder folder;
      SensorFrame frame = SomeFrame(20);
      (of_motor ? frame.motors[1].current_a : frame.imu.rate_R.y()) = bad;
      {
        RunLogWriter writer(folder.path(), {1, 1, "toy", "none", true, SomeNominal()});
        writer.Append(frame, {});
        writer.Finish();
      }
      EXPECT_THAT(ErrorOf([&] { ReadWholeLog(folder.path()); }),
                  HasSubstr("entry 0: a reading is not a finite number"));
    }
  }
}

TEST(RunLog, OnAFullDiskSaysSo) {
  const TemporaryFolder folder;
  // In the place of a full disk: a file that may not grow.
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{4096, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const std::string error = ErrorOf([&] { WriteLog(folder.path(), 60); });
  ::setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_THAT(error, HasSubstr("File too large"));
}

TEST(RunLog, TakesThePlaceOfALinkOrAPipe) {
  const TemporaryFolder folder;
  const std::filesystem::path log = folder.path() / kRunLogFile, other = folder.path() / "other";
  WriteText(other, "precious");
  std::filesystem::create_symlink(other, log);
  WriteLog(folder.path(), 3);
  EXPECT_TRUE(ReadWholeLog(folder.path()).complete);
  EXPECT_EQ(Slurp(other), "precious");
  std::filesystem::remove(log);
  ASSERT_EQ(::mkfifo(log.c_str(), 0600), 0);
  EXPECT_THAT(ErrorOf([&] { ReadWholeLog(folder.path()); }), HasSubstr("found a pipe; remove it"));
  WriteLog(folder.path(), 3);
  EXPECT_TRUE(ReadWholeLog(folder.path()).complete);
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
  const ControllerReplay replay = ReplayController(log, controller, kSomeRobot);
  EXPECT_TRUE(replay.same());
  EXPECT_EQ(replay.compared, 30u);
}

// As filters, compressors and `recover` leave a log.
TEST(ControllerReplay, OfALogThatAnotherProgramWroteAnewIsTheSame) {
  const TemporaryFolder folder, other;
  WriteLog(folder.path(), 30);
  for (const ForeignWriting& how :
       {ForeignWriting{.compression = ForeignCompression::kLz4, .check_values = false},
        ForeignWriting{.message_indexes = false, .summary = false, .chunk_bytes = 1u << 20},
        ForeignWriting{.compression = ForeignCompression::kZstdWithoutSize,
        .chunk_bytes = 100,
        .attachments_last = true,
        .private_records = true},
        ForeignWriting{.chunk_bytes = 0}}) {
    RewriteForeign(folder.path() / kRunLogFile, other.path() / kRunLogFile, how);
    RunLogReader log(other.path());
    MixingController controller;
    const ControllerReplay replay = ReplayController(log, controller, kSomeRobot);
    EXPECT_TRUE(replay.same());
    EXPECT_EQ(replay.compared, 30u);
    EXPECT_EQ(replay.guarded, how.check_values);
  }
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
  const ControllerReplay replay = ReplayController(log, controller, kSomeRobot);
  EXPECT_FALSE(replay.same());
  EXPECT_EQ(replay.differs_at, 200);
  EXPECT_EQ(replay.compared, 10u);
}

TEST(ControllerReplay, StopsWhereTheLogLeftTheImagesOut) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 30, /*keep_images=*/false);
  RunLogReader log(folder.path());
  MixingController controller;
  const ControllerReplay replay = ReplayController(log, controller, kSomeRobot);
  EXPECT_FALSE(replay.same());
  EXPECT_EQ(replay.blind_at, 0);
}

TEST(ControllerReplay, RefusesFramesOfAnotherRobot) {
  const TemporaryFolder folder;
  WriteLog(folder.path(), 3);
  const auto replay = [&](const RobotShape& robot) {
    return ErrorOf([&] {
      RunLogReader log(folder.path());
      MixingController controller;
      ReplayController(log, controller, robot);
    });
  };
  EXPECT_THAT(replay({.motors = 5, .cameras = 3, .sensors = 3}),
              HasSubstr("at tick 0: expected the readings of 5 motors, found 4"));
  EXPECT_THAT(replay({.motors = 4, .cameras = 2, .sensors = 3}),
              HasSubstr("at tick 0: expected images of cameras 0 to 1, found one of 2"));
  EXPECT_THAT(replay({.motors = 4, .cameras = 3, .sensors = 1}),
              HasSubstr("at tick 0: expected the values of 1 sensors, found 3"));
  EXPECT_EQ(replay(kSomeRobot), "no error");
}

TEST(ControllerReplay, TakesACommandThatIsNotANumberForEqualToItself) {
  class Lost : public MixingController {
   public:
    Commands Step(const SensorFrame&) override {
      Commands commands;
      commands.motors.resize(1);
      commands.motors[0].target = std::numeric_limits<double>::quiet_NaN();
      return commands;
    }
  };
  const TemporaryFolder folder;
  Lost lost;
  {
    RunLogWriter writer(folder.path(), {1, 1, "toy", "lost", true, SomeNominal()});
    writer.Append(SomeFrame(20), lost.Step({}));
    writer.Finish();
  }
  RunLogReader log(folder.path());
  EXPECT_TRUE(ReplayController(log, lost, kSomeRobot).same());
}

// A controller cannot be run again on images that are not those that it got.
TEST(RunLog, WithAnImageGapSaysThatFramesHadImagesAndKeepsThemForPeople) {
  const TemporaryFolder folder;
  RunLogHeader header;
  header.image_gap_s = 1.0;
  {
    RunLogWriter log(folder.path(), header);
    log.Append(SomeFrame(0), {}, false);
    log.Append(SomeFrame(20), {}, false);
    log.Append(SomeFrame(60), {}, true);
    log.Finish();
  }
  const WholeLog log = ReadWholeLog(folder.path());
  EXPECT_EQ(log.header.image_gap_s, 1.0);
  ASSERT_EQ(log.entries.size(), 3u);
  for (const auto& [entry, left_out] : {std::pair(0, true), {1, false}, {2, true}}) {
    EXPECT_EQ(log.entries[static_cast<std::size_t>(entry)].images_left_out, left_out) << entry;
    EXPECT_TRUE(log.entries[static_cast<std::size_t>(entry)].sensed.images.empty()) << entry;
  }
  const LoggedRun run = ReadLoggedRun(folder.path());
  ASSERT_EQ(run.images.size(), 2u);  // of the first frame's two cameras
  for (const Timed<LoggedImage>& image : run.images) {
    EXPECT_EQ(image.time_s, 0.0);
    EXPECT_THAT(image.value.bytes, testing::StartsWith("RIFF"));
  }
}

}  // namespace
}  // namespace dockyard
