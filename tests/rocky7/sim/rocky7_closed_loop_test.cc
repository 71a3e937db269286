// Rocky 7 drives to a stone by its pictures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/base/number_text.h"
#include "controller/rocky7/dockyard.h"
#include "controller/rocky7/nesnas2000.h"
#include "controller/rocky7/phases.h"
#include "models/read/yaml_tree.h"
#include "sim/rocky7/rocky7_columns.h"
#include "sim/rocky7/rocky7_system.h"
#include "sim/run/loop.h"
#include "support/bad_files.h"

namespace dockyard::rocky7 {
namespace {

RunRecord RunFrom(const System& system, const std::string& controller, const std::string& soil,
                  std::uint64_t seed, const std::string& task = "reach", double from_m = 1.3,
                  double slope_deg = 0.0, double downhill_deg = 0.0) {
  CampaignRun run;
  Scenario& scenario = run.scenario;
  scenario.name = "test";
  scenario.system = "rocky7";
  scenario.controller = controller;
  scenario.robot_file = SourceFile("models/rocky7/rocky7.yaml");
  scenario.soil_file = SourceFile("models/soils/" + soil + ".yaml");
  scenario.of_system = ParseYaml("{task: " + task + "}", "test");
  scenario.start = {from_m, 0.0, Radians(5.0)};
  scenario.yard.length_m = scenario.yard.width_m = 3.0 + from_m;
  scenario.yard.cell_m = 0.01;
  scenario.yard.undulation_rms_m = 0.003;
  scenario.yard.slope_rad = Radians(slope_deg);
  scenario.yard.downhill_rad = Radians(downhill_deg);
  scenario.time_limit_s = 200.0;
  scenario.seed = seed;
  return Simulate(system, run, {});
}

/// The controller, with a count of the images that came while its wheels turned, and that did not,
/// and of its periods after the grasp.
struct LooksSeen {
  int driving = 0, standing = 0, inspecting = 0;
};
class Watched final : public Controller {
 public:
  Watched(std::unique_ptr<Controller> inner, std::shared_ptr<LooksSeen> looks)
      : inner_(std::move(inner)), looks_(std::move(looks)) {}
  Commands Step(const SensorFrame& sensed) override {
    const std::int64_t wheel = sensed.motors.at(2).encoder_counts;
    if (!sensed.images.empty()) ++(wheel != before_ ? looks_->driving : looks_->standing);
    before_ = wheel;
    Commands commands = inner_->Step(sensed);
    looks_->inspecting += inner_->belief().phase == Name(Phase::kInspect);
    return commands;
  }
  const Belief& belief() const override { return inner_->belief(); }

 private:
  std::unique_ptr<Controller> inner_;
  std::shared_ptr<LooksSeen> looks_;
  std::int64_t before_ = 0;
};

double MeasureOf(const RunRecord& record, const std::string& name) {
  const std::vector<Column> columns = Measures();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name == name) return record.result.measures.at(i);
  }
  throw std::out_of_range(name);
}

TEST(Rocky7ClosedLoop, ThePapersTrackerBringsThePointToAStoneTheSameWayTwice) {
  const System system = Rocky7System({{"nesnas2000", MakeNesnas2000Controller}});
  const RunRecord a = RunFrom(system, "nesnas2000", "compact_gravel", 1),
                  b = RunFrom(system, "nesnas2000", "compact_gravel", 1);
  EXPECT_LT(MeasureOf(a, "point_off_m"), 0.03) << a.failure_note;
  EXPECT_GE(MeasureOf(a, "looks"), 8);
  EXPECT_EQ(a.result.state_hash, b.result.state_hash);
}

TEST(Rocky7ClosedLoop, OursGraspsALooseStoneAndKeepsItWhileItDrivesAway) {
  const auto looks = std::make_shared<LooksSeen>();
  const System system =
      Rocky7System({{"dockyard", [&](const Nominal& nominal) {
                       return std::make_unique<Watched>(MakeDockyardController(nominal), looks);
                     }}});
  const RunRecord record = RunFrom(system, "dockyard", "loose_sand", 2, "grasp");
  EXPECT_EQ(record.result.outcome, "grasped") << record.failure_note;
  EXPECT_LT(MeasureOf(record, "point_off_m"), 0.035);  // the arm rolls to it by up to 3 cm
  EXPECT_GT(MeasureOf(record, "rise_m"), 0.1);
  // It takes images while it drives, each 12 cm of 0.7 m to the stone but for the last 15 cm and 12
  // cm.
  EXPECT_GE(looks->driving, 3);
  EXPECT_GE(looks->standing, 2);
}

// A slow processor: each pair costs its time, and the rover rests for it.
TEST(Rocky7ClosedLoop, WithASlowProcessorOursRestsForEachPairAndGraspsTheStone) {
  const auto taken = std::make_shared<LooksSeen>();
  const System system =
      Rocky7System({{"dockyard", [&](const Nominal& nominal) {
                       return std::make_unique<Watched>(MakeDockyardController(nominal), taken);
                     }}});
  constexpr double kCompute_s = 5.0;
  const RunRecord record =
      RunFrom(system, "dockyard", "loose_sand", 2, "grasp, compute_s: " + NumberText(kCompute_s));
  EXPECT_EQ(record.result.outcome, "grasped") << record.failure_note;
  EXPECT_EQ(taken->driving, 0);
  EXPECT_GE(taken->standing, 4);
  EXPECT_GT(record.result.sim_time_s, kCompute_s * MeasureOf(record, "looks"));
  EXPECT_GE(taken->inspecting, std::llround(kCompute_s / (kControlPeriod * kTickSeconds)));
}

// The ground ahead is not level, and the rover drifts down it.
TEST(Rocky7ClosedLoop, OursGraspsOnASlope) {
  const System system = Rocky7System({{"dockyard", MakeDockyardController}});
  const RunRecord record =
      RunFrom(system, "dockyard", "compact_gravel", 1, "grasp", 1.6, 9.0, 127.0);
  EXPECT_EQ(record.result.outcome, "grasped") << record.failure_note;
}

// Two metres to a boulder whose face points past the rover, so that it must come by two arcs.
TEST(Rocky7ClosedLoop, OursPlacesItsInstrumentOnAFace) {
  const System system = Rocky7System({{"dockyard", MakeDockyardController}});
  const RunRecord record =
      RunFrom(system, "dockyard", "compact_gravel", 3,
              "place, target_up_m: 0.33, face_up_deg: 30, face_turn_deg: 15, reach_m: 0.02", 2.8);
  EXPECT_EQ(record.result.outcome, "placed") << record.failure_note;
  EXPECT_LT(MeasureOf(record, "tilt_deg"), 5.0);
  EXPECT_LT(MeasureOf(record, "face_force_n"), 10.0);
}

}  // namespace
}  // namespace dockyard::rocky7
