// The judge on a rover that rests: a controller reports what a test gives it.
#include <gtest/gtest.h>

#include "rocky7/sim/test_scenario.h"
#include "sim/rocky7/load_models.h"
#include "sim/rocky7/rocky7_columns.h"
#include "sim/rocky7/rocky7_system.h"
#include "sim/rocky7/target_view.h"
#include "sim/run/loop.h"

namespace dockyard::rocky7 {
namespace {

struct Before {
  double from_m = 1.0, up_m = 0.015;  // of the target, over the ground
};
constexpr Before kStone, kFace{2.8, 0.33};

Scenario Resting(const Before& before, const std::string& keys,
                 const std::vector<GivenRock>& rocks = {}) {
  Scenario scenario = OnGravel("{" + keys + "}", before.from_m, 4.0);
  scenario.controller = "given";
  scenario.rocks.given = rocks;
  scenario.time_limit_s = 5.0;
  scenario.seed = 3;
  return scenario;
}

/// What a controller reports of one image pair.
struct Pair {
  bool found = true;
  double off_m = 0.0;        // of the detection, ahead
  double aside_m = 0.0;      // of it, to the left
  double predicted_m = 0.0;  // off the target, ahead, before the pair
  double grasps = 0.0;
};

// Reports the pairs one by one, in every second period, and gives up.
class Given final : public Controller {
 public:
  Given(const Before& before, const std::vector<Pair>& pairs, const Nominal& nominal)
      : before_(before), pairs_(pairs), nominal_(nominal) {}
  Commands Step(const SensorFrame& sensed) override {
    Commands commands;
    commands.motors.resize(nominal_.motors.size());
    const bool reports = period_ % 2 == 1;
    const Pair& pair = pairs_.at(static_cast<std::size_t>(period_++ / 2));
    belief_.values = {{"target_x_m", before_.from_m + (reports ? pair.off_m : pair.predicted_m)},
                      {"target_y_m", 0.0},
                      {"grasps", pair.grasps}};
    if (!reports) return commands;
    const Eigen::Matrix3d R_ER = RotY(sensed.imu.pitch_rad) * RotX(sensed.imu.roll_rad);
    SightingReport report;
    report.accepted = pair.found;
    const Eigen::Vector3d p_E(before_.from_m + pair.off_m, pair.aside_m,
                              before_.up_m - nominal_.rolling_radius_m);
    report.X_RB = {R_ER.transpose(), R_ER.transpose() * p_E};
    belief_.last_sighting = report;
    ++belief_.sighting_count;
    if (period_ == 2 * static_cast<int>(pairs_.size())) commands.verdict = Verdict::kGivenUp;
    return commands;
  }
  const Belief& belief() const override { return belief_; }

 private:
  Before before_;
  std::vector<Pair> pairs_;
  Nominal nominal_;
  int period_ = 0;
  Belief belief_;
};

RunResult After(const Before& before, const std::vector<Pair>& pairs, const std::string& keys,
                const std::vector<GivenRock>& rocks = {}) {
  CampaignRun run;
  run.scenario = Resting(before, keys, rocks);
  const System system = Rocky7System({{"given", [&](const Nominal& nominal) {
                                         return std::make_unique<Given>(before, pairs, nominal);
                                       }}});
  return Simulate(system, run, {}).result;
}

double LossOf(const RunResult& result) {
  const std::vector<Column> columns = Measures();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name == "loss") return result.measures.at(i);
  }
  return -1.0;
}

double LossAfter(const std::vector<Pair>& pairs, const std::string& keys = "task: reach",
                 const std::vector<GivenRock>& rocks = {}) {
  return LossOf(After(kStone, pairs, keys, rocks));
}

TEST(JudgedLoss, IsNoneWhileTheTargetIsDetected) {
  EXPECT_EQ(LossAfter({{}, {.off_m = 0.03}}), 0.0);  // less than its width of 4 cm
}

TEST(JudgedLoss, IsNoneOnceTheTargetIsFoundAgain) {
  EXPECT_EQ(LossAfter({{}, {.found = false}, {.off_m = 0.2}, {}}), 0.0);
}

TEST(JudgedLoss, OfATargetNeverFoundIsTheRangeData) {
  EXPECT_EQ(LossAfter({{.found = false}}), 2.0);
  EXPECT_EQ(LossAfter({{.found = false}}, "task: reach, stone_albedo: 1"), 5.0);
}

// What was expected before the first detection means nothing.
TEST(JudgedLoss, IsOdometrysWhereThePredictionIsOffByMoreThanTheWindow) {
  EXPECT_EQ(LossAfter({{.found = false, .predicted_m = 0.1}}), 2.0);
  EXPECT_EQ(LossAfter({{}, {.found = false, .predicted_m = 0.1}}), 4.0);
  EXPECT_EQ(LossAfter({{}, {.found = false, .predicted_m = 0.05}}), 2.0);
  EXPECT_EQ(LossAfter({{}, {.found = false, .predicted_m = 0.05}},
                      "task: reach, nesnas: {window_m: 0.04}"),
            4.0);
}

TEST(JudgedLoss, AfterAGraspIsNone) {
  EXPECT_EQ(LossAfter({{}, {.found = false, .grasps = 1.0}}), 0.0);
}

// 10 cm behind the target; one of 9 cm reaches into the window of 6 cm, one of 6 cm does not.
TEST(JudgedLoss, IsAnotherStonesInTheWindowWhereThatWasDetected) {
  const auto with = [](double diameter_m) {
    return LossAfter({{}, {.off_m = 0.1}}, "task: reach", {{-0.1, 0.0, diameter_m}});
  };
  EXPECT_EQ(with(0.09), 3.0);
  EXPECT_EQ(with(0.06), 2.0);
  // Stones below 8 cm lie loose.
  EXPECT_EQ(LossAfter({{}, {.off_m = 0.1}}, "task: reach", {{-0.08, 0.0, 0.07}}), 3.0);
  EXPECT_EQ(LossAfter({{}, {.off_m = 0.1}}), 2.0);
}

// The instrument is 66 mm wide; the click is two centimetres off the face's middle.
TEST(JudgedLoss, OfABouldersPointIsAnotherPartOfItOrTheRangeData) {
  const std::string keys = "task: place, target_up_m: 0.33, face_up_deg: 30";
  const RunResult near = After(kFace, {{}, {.off_m = 0.03}}, keys);
  EXPECT_EQ(LossOf(near), 0.0);
  EXPECT_GT(near.measures.at(1), 0.035);  // further off than a lost stone
  EXPECT_EQ(near.outcome, "unstable");
  const RunResult aside = After(kFace, {{}, {.aside_m = 0.1}}, keys);
  EXPECT_EQ(LossOf(aside), 3.0);
  EXPECT_EQ(aside.outcome, "lost_target");
  EXPECT_EQ(LossOf(After(kFace, {{}, {.off_m = -0.15}}, keys)), 2.0);
}

class StoneInView : public testing::Test {
 protected:
  StoneInView()
      : plant_(scenario_, BuildRun(scenario_, LoadModels(scenario_)),
               std::make_shared<KeptRenderer>()) {}
  Eigen::Vector3d LeftCamera() const { return (plant_.truth().X_WR * plant_.built().front.X_RL).p; }
  Scenario scenario_ = Resting(kStone, "task: reach");
  Rocky7Plant plant_;
};

TEST_F(StoneInView, IsWhatTheClickShows) {
  EXPECT_TRUE(LeftImageShows(plant_, TargetInWorld(plant_)));
}

TEST_F(StoneInView, EndsBehindTheRoverAndBehindItsWheels) {
  const Pose3& X_WR = plant_.truth().X_WR;
  EXPECT_FALSE(LeftImageShows(plant_, X_WR * Eigen::Vector3d(-1.0, 0.0, -0.06)));
  const RoverPlan& plan = plant_.built().nominal.plan;
  int hidden = 0;
  for (const WheelPlan& wheel : plan.wheels) {
    const Eigen::Vector3d p_W = X_WR * Eigen::Vector3d(wheel.p_RW.x(), wheel.p_RW.y(), 0.0);
    const Eigen::Vector3d along = p_W - LeftCamera();
    const bool behind = LeftImageShows(plant_, LeftCamera() + 1.3 * along);
    const bool before = LeftImageShows(plant_, LeftCamera() + 0.5 * along);
    hidden += before && !behind;
  }
  EXPECT_GE(hidden, 1);
}

TEST(SegmentThroughAMesh, IsBlockedBetweenTheNearPlaneAndItsEnd) {
  const RenderMesh mesh{{{1, -1, -1}, {1, 1, -1}, {1, 0, 1}}, {{0, 1, 2}}};
  const Pose3 X_WM = Pose3::Translation(0.0, 5.0, 0.0);
  const auto blocks = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    return Blocks(mesh, X_WM, from, to);
  };
  EXPECT_TRUE(blocks({0, 5, 0}, {2, 5, 0}));
  EXPECT_TRUE(blocks({2, 5, 0}, {0, 5, 0}));
  EXPECT_FALSE(blocks({0, 5, 0}, {0.99, 5, 0}));
  EXPECT_FALSE(blocks({0.99, 5, 0}, {2, 5, 0}));  // within the near plane
  EXPECT_FALSE(blocks({0, 5, 0}, {2, 5, 2.1}));   // above its corner
}

}  // namespace
}  // namespace dockyard::rocky7
