// What a spectator reads back is what the run was.
#include "sim/log/logged_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim/log/ground_over_time.h"
#include "sim/log/take_messages.h"
#include "sim/mcap/mcap_reader.h"
#include "support/edited_log.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

Pose3 PoseAt(int i) {
  return {ToRotation({0.01 * i, -0.02 * i, 0.1 * i}), Eigen::Vector3d(1.0 - 0.01 * i, 0.2, 0.3)};
}

SightingSample SomeSighting() {
  SightingSample sighting{
      .time_s = 0.7, .X_DR = {1, 2, 3}, .report = {}, .X_DR_measured = {4, 5, 6}};
  SightingReport& report = sighting.report;
  report.accepted = true;
  report.method = "stereo";
  report.detected = {8, 7};
  report.marks = {{3, 1, 12.5, -0.25}};
  report.predicted = {{4, 0, 1.0, 2.0}};
  report.reprojection_px = 0.125;
  report.X_RB = PoseAt(3);
  report.covariance(2, 3) = 1e-7;
  return sighting;
}

/// Twenty samples of a robot with a wheel, a cable, a ground that changes, an image.
void WriteRun(const std::filesystem::path& dir, bool with_solids = false) {
  RunLogWriter log(dir, {.run = 3,
                         .system = "toy",
                         .motors = {{"wheel", 0.5}},
                         .cameras = {{"left", EquidistantCamera(8, 6, 1.0), PoseAt(4)}},
                         .channels = {{"depth_m", "m", "how deep"}},
                         .beliefs = {{"tries", "", "how often"}}});
  std::vector<double> heights(12, 0.01);
  const std::vector<Eigen::Vector3d> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  for (int i = 0; i < 20; ++i) {
    const Tick tick = 100 * i;
    SensorFrame frame{.tick = tick, .motors = {{2 * i, 0.1 * i}}};
    if (i == 7) frame.images = {{0, GrayImage{2, 1, {5, 250}}}};
    log.Append(frame, {});
    HistorySample sample;
    sample.X_DR = {0.1 * i, 0.0, 1.0};
    sample.channels = {0.5 * i};
    sample.beliefs = {2.0};
    sample.phase = i < 5 ? "look" : "drive";
    sample.located = i >= 10;
    sample.X_DR_believed = {0.1 * i + 0.25, 0.0, 1.0 - Radians(1.0)};
    Stage stage;
    stage.bodies = {{"robot", PoseAt(i)}, {"wheel", PoseAt(2 * i)}};
    stage.lines = {
        {.name = "cable", .diameter_m = 0.006, .points_W = {{0, 0, 0}, {i * 1.0, 0, 0}}}};
    if (with_solids) stage.solids = {{.name = "stones", .rgb = {1, 0, 0}, .corners_W = &corners}};
    if (i == 10) heights[5] = -0.02;
    stage.ground = {
        .cell_m = 0.1, .nx = 4, .ny = 3, .heights_m = heights.data(), .revision = i < 10 ? 0u : 1u};
    stage.X_WD = PoseAt(1);
    log.Append(sample, stage, tick);
    log.AppendGround(stage.ground, tick);
    if (i == 7) log.Append(SomeSighting(), tick);
    if (i == 8) log.Append(PlanSample{0.8, {{{2.0, 0.0, 0.0}, -1.0, 0.5}}}, tick);
  }
  log.Finish({{"outcome", "docked"}});
}

TEST(LoggedRun, GivesBackWhatTheRunWas) {
  const TemporaryFolder folder;
  WriteRun(folder.path());
  const LoggedRun run = ReadLoggedRun(folder.path());
  EXPECT_TRUE(run.complete);
  EXPECT_EQ(run.header.run, 3);
  EXPECT_EQ(run.outcome["outcome"], "docked");
  ASSERT_EQ(run.times_s.size(), 20u);
  EXPECT_NEAR(run.times_s[13], 1.3, 1e-9);
  EXPECT_THAT(run.body_names, testing::ElementsAre("robot", "wheel"));
  EXPECT_TRUE(run.X_WO[1][7].R.isApprox(PoseAt(14).R, 1e-12));
  EXPECT_EQ(run.X_WO[0][7].p, PoseAt(7).p);
  EXPECT_EQ(run.X_WD[19].p, PoseAt(1).p);
  EXPECT_EQ(run.lines.at("cable")[9].points_W[1].x(), 9.0);
  EXPECT_EQ(run.lines.at("cable")[9].diameter_m, 0.006);
  EXPECT_EQ(run.truth.at("depth_m")[9], 4.5);
  EXPECT_EQ(run.truth.at("heading_rad")[9], 1.0);
  EXPECT_EQ(run.belief.at("tries")[9], 2.0);
  EXPECT_EQ(run.currents_a.at("wheel")[9], 0.1 * 9);
}

/// Frame, parent and pose of each transform in the log's messages on /tf.
struct Transform {
  std::string parent, name;
  Pose3 X;
};
std::vector<Transform> TransformsIn(const std::filesystem::path& dir) {
  std::vector<Transform> all;
  McapReader file(dir / kRunLogFile);
  while (const auto message = file.Next()) {
    if (file.channel(message->channel_id).topic != topic::kTransforms) continue;
    CdrReader in(message->data);
    for (std::uint32_t left = in.Count(kSmallestStamped); left > 0; --left) {
      const std::string parent = TakeHeader(in).frame, name = in.Text();
      all.push_back({parent, name, TakePose(in)});
    }
  }
  return all;
}

TEST(RunLog, NamesTheFramesOfItsImagesInEverySampleOfTheTransforms) {
  const TemporaryFolder folder;
  WriteRun(folder.path());
  int found = 0;
  for (const Transform& each : TransformsIn(folder.path())) {
    if (each.name != "left") continue;
    ++found;
    EXPECT_EQ(each.parent, "robot");
    EXPECT_EQ(each.X.p, PoseAt(4).p);
    EXPECT_TRUE(each.X.R.isApprox(PoseAt(4).R, 1e-12));
  }
  EXPECT_EQ(found, 20);
}

TEST(RunLog, HasACameraInfoOfTheSameTimeForEachImage) {
  const TemporaryFolder folder;
  WriteRun(folder.path());
  std::vector<std::pair<std::uint64_t, std::string>> infos, images;
  McapReader file(folder.path() / kRunLogFile);
  while (const auto message = file.Next()) {
    const std::string& topic = file.channel(message->channel_id).topic;
    const bool info = topic == "/camera/left/camera_info";
    if (!info && topic != "/camera/left/image/compressed") continue;
    CdrReader in(message->data);
    (info ? infos : images).push_back({message->log_time_ns, TakeHeader(in).frame});
  }
  ASSERT_EQ(images.size(), 1u);
  EXPECT_EQ(images[0].second, "left");
  EXPECT_EQ(infos, images);
}

TEST(LoggedRun, HasItsCamerasInTheirOrderWhetherTheyTookImagesOrNot) {
  const TemporaryFolder folder;
  RunLogWriter(folder.path(), {.run = 1,
                               .system = "toy",
                               .cameras = {{"left", EquidistantCamera(8, 6, 1.0), {}},
                                           {"right", EquidistantCamera(9, 7, 1.0), {}}}})
      .Finish();
  const LoggedRun run = ReadLoggedRun(folder.path());
  ASSERT_EQ(run.cameras.size(), 2u);
  EXPECT_EQ(run.cameras[1].name, "right");
  EXPECT_EQ(run.cameras[1].width, 9u);
}

TEST(LoggedRun, HasBeliefMinusTruthOverTime) {
  const TemporaryFolder folder;
  WriteRun(folder.path());
  const LoggedRun run = ReadLoggedRun(folder.path());
  EXPECT_TRUE(std::isnan(run.truth.at("error_x_m")[3]));
  EXPECT_DOUBLE_EQ(run.truth.at("error_x_m")[12], 0.25);
  EXPECT_NEAR(run.truth.at("error_yaw_deg")[12], -1.0, 1e-9);
}

TEST(LoggedRun, HasTheValuesOfABeliefAtTheirSamples) {
  const TemporaryFolder folder;
  {
    RunLogWriter log(folder.path(), {.run = 1, .system = "toy"});
    const double none = std::nan("");
    const std::vector<std::vector<double>> rows{{}, {1.5}, {none, 7.0}, {none, none}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto tick = static_cast<Tick>(100 * i);
      log.Append(HistorySample{}, Stage{}, tick);
      log.AppendValues({"first", "x_m"}, rows[i], tick);
    }
    log.Finish();
  }
  const LoggedRun run = ReadLoggedRun(folder.path());
  using testing::ElementsAre, testing::IsNan;
  ASSERT_EQ(run.values.size(), 2u);
  EXPECT_THAT(run.values.at("first"), ElementsAre(IsNan(), 1.5, IsNan(), IsNan()));
  EXPECT_THAT(run.values.at("x_m"), ElementsAre(IsNan(), IsNan(), 7.0, IsNan()));
  EXPECT_THAT(run.belief.at("x_m"), ElementsAre(0.0, 0.0, 0.0, 0.0));  // the robot's place
}

TEST(RunLog, HasATopicOfValuesOnlyWhereThereAreSome) {
  const TemporaryFolder folder;
  WriteRun(folder.path());
  McapReader file(folder.path() / kRunLogFile);
  while (const auto message = file.Next()) {
    EXPECT_NE(file.channel(message->channel_id).topic, topic::kValues);
  }
  EXPECT_TRUE(ReadLoggedRun(folder.path()).values.empty());
}

TEST(LoggedRun, KeepsAllSamplesBesideSolidsThatAreWrittenOnce) {
  const TemporaryFolder folder;
  WriteRun(folder.path(), true);
  const LoggedRun run = ReadLoggedRun(folder.path());
  EXPECT_EQ(run.times_s.size(), 20u);
  EXPECT_EQ(run.lines.size(), 1u);
  EXPECT_EQ(run.lines.at("cable").size(), 20u);
}

TEST(LoggedRun, HasWhatHappenedAtItsTime) {
  const TemporaryFolder folder;
  WriteRun(folder.path());
  const LoggedRun run = ReadLoggedRun(folder.path());
  ASSERT_EQ(run.notes.size(), 2u);
  EXPECT_EQ(run.notes[1].value.text, "drive");
  EXPECT_NEAR(run.notes[1].time_s, 0.5, 1e-9);
  ASSERT_EQ(run.sightings.size(), 1u);
  const SightingReport &read = run.sightings[0].report, wrote = SomeSighting().report;
  EXPECT_NEAR(run.sightings[0].time_s, 0.7, 1e-9);
  EXPECT_EQ(run.sightings[0].X_DR, (Pose2{1, 2, 3}));
  EXPECT_EQ(run.sightings[0].X_DR_measured, (Pose2{4, 5, 6}));
  EXPECT_EQ(read.detected, wrote.detected);
  EXPECT_EQ(read.marks[0].v_px, -0.25);
  EXPECT_EQ(read.predicted[0].id, 4);
  EXPECT_EQ(read.covariance, wrote.covariance);
  EXPECT_TRUE(read.X_RB.R.isApprox(wrote.X_RB.R, 1e-12));
  ASSERT_EQ(run.plans.size(), 1u);
  // An arc of 1 m backwards that turns by 0.5: its end, by the circle's equations.
  const Pose2 end = run.plans[0].value.back();
  EXPECT_NEAR(end.x, 2.0 - 2.0 * std::sin(0.5), 1e-12);
  EXPECT_NEAR(end.y, -2.0 * (1.0 - std::cos(0.5)), 1e-12);
  EXPECT_NEAR(end.heading, 0.5, 1e-12);
  ASSERT_EQ(run.images.size(), 1u);
  EXPECT_EQ(run.images[0].value.camera, "left");
  ASSERT_EQ(run.cameras.size(), 1u);
  EXPECT_EQ(run.cameras[0].width, 8u);
  EXPECT_EQ(run.cameras[0].height, 6u);
  EXPECT_THAT(run.images[0].value.bytes, testing::StartsWith("\x89PNG"));
}

TEST(LoggedRun, HasTheGroundOnceAndThenWhatChanged) {
  const TemporaryFolder folder;
  WriteRun(folder.path());
  const LoggedRun run = ReadLoggedRun(folder.path());
  ASSERT_EQ(run.ground.size(), 2u);
  EXPECT_TRUE(run.ground[0].value.cells.empty());
  EXPECT_THAT(run.ground[0].value.heights, testing::Each(100));
  EXPECT_THAT(run.ground[1].value.cells, testing::ElementsAre(5u));
  EXPECT_THAT(run.ground[1].value.heights, testing::ElementsAre(-200));
  EXPECT_NEAR(run.ground[1].time_s, 1.0, 1e-9);
}

TEST(LoggedRun, CutShortHasWholeSamplesAlone) {
  const TemporaryFolder folder;
  WriteRun(folder.path());
  const std::filesystem::path file = folder.path() / kRunLogFile;
  const std::string bytes = Slurp(file);
  std::size_t most = 0;
  for (std::size_t cut = 1; cut < bytes.size(); cut += 211) {
    WriteText(file, bytes.substr(0, bytes.size() - cut));
    try {
      const LoggedRun run = ReadLoggedRun(folder.path());
      EXPECT_FALSE(run.complete);
      most = std::max(most, run.times_s.size());
      for (const auto& poses : run.X_WO) EXPECT_EQ(poses.size(), run.times_s.size());
      for (const auto& [name, values] : run.truth) EXPECT_EQ(values.size(), run.times_s.size());
    } catch (const DataError&) {  // cut into the header
    }
  }
  EXPECT_EQ(most, 20u);
}

TEST(GroundOverTime, TakesInChangesUpToATimeAndNoneAfter) {
  LoggedRun run;
  run.ground = {{0.0, {.nx = 2, .ny = 2, .cells = {}, .heights = {1, 2, 3, 4}}},
                {1.0, {.cells = {3, 9}, .heights = {40, 90}}},
                {2.0, {.cells = {0}, .heights = {10}}}};
  GroundOverTime ground(run);
  ASSERT_NE(ground.grid(), nullptr);
  ground.AdvanceTo(0.9);
  EXPECT_EQ(ground.heights(), (std::vector<std::int16_t>{1, 2, 3, 4}));
  ground.AdvanceTo(1.0);
  EXPECT_EQ(ground.heights(), (std::vector<std::int16_t>{1, 2, 3, 40}));
  ground.AdvanceTo(9.0);
  EXPECT_EQ(ground.heights(), (std::vector<std::int16_t>{10, 2, 3, 40}));
}

TEST(GroundOverTime, HasNoGridWithoutAWholeGroundAtFirst) {
  LoggedRun run;
  EXPECT_EQ(GroundOverTime(run).grid(), nullptr);
  run.ground = {{0.0, {.nx = 2, .ny = 2, .cells = {1}, .heights = {5}}}};
  EXPECT_EQ(GroundOverTime(run).grid(), nullptr);
}

TEST(RunLog, HasSolidsOnceAsTriangles) {
  const TemporaryFolder folder;
  const std::vector<Eigen::Vector3d> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  {
    RunLogWriter log(folder.path(), {.run = 1, .system = "toy"});
    Stage stage;
    stage.bodies = {{"robot", {}}};
    stage.solids = {{.name = "stones", .corners_W = &corners}};
    for (int i = 0; i < 5; ++i) log.Append(HistorySample{}, stage, 100 * i);
    log.Finish();
  }
  McapReader reader(folder.path() / "run.mcap");
  int count = 0;
  while (const std::optional<McapMessage> message = reader.Next()) {
    if (reader.channel(message->channel_id).topic != "/stones") continue;
    ++count;
    // Three corners of three doubles each stand in it.
    EXPECT_GT(message->data.size(), 72u);
  }
  EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace dockyard
