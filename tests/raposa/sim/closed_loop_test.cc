// One docking from start to end: pictures, controller, physics, judge.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "controller/raposa/dockyard.h"
#include "controller/raposa/ferreira2009.h"
#include "models/read/yaml_tree.h"
#include "sim/raposa/raposa_columns.h"
#include "sim/raposa/raposa_system.h"
#include "sim/run/loop.h"
#include "support/source_tree.h"

namespace dockyard::raposa {
namespace {

RunRecord RunFrom(const System& system, const std::string& controller, double r_m, double alpha_rad,
                  std::uint64_t seed) {
  const std::string models = SourceFile("models/raposa/");
  CampaignRun run;
  Scenario& scenario = run.scenario;
  scenario.name = "test";
  scenario.system = "raposa";
  scenario.controller = controller;
  scenario.robot_file = models + "raposa.yaml";
  scenario.soil_file = models + "grounds/hard_floor.yaml";
  scenario.of_system = ParseYaml("{pyramid: " + models + "pyramid/pyramid.yaml}", "test");
  scenario.start = {r_m, alpha_rad, alpha_rad};
  scenario.yard.undulation_rms_m = 0.0;
  scenario.time_limit_s = 120.0;
  scenario.seed = seed;
  return Simulate(system, run, {});
}

/// Distance of the accepted sightings' poses from the truth, the middle one.
double MedianMiss_m(const RunRecord& record) {
  std::vector<double> misses;
  for (const SightingSample& sample : record.sightings) {
    if (!sample.report.accepted) continue;
    const Pose2 off = Inverse(sample.X_DR) * sample.X_DR_measured;
    misses.push_back(std::hypot(off.x, off.y));
  }
  EXPECT_GE(misses.size(), 20u);
  if (misses.empty()) return 1e9;
  std::nth_element(misses.begin(), misses.begin() + misses.size() / 2, misses.end());
  return misses[misses.size() / 2];
}

// Table I, point 9: 37.9 s in the mean; of 40 of ours 35.3-40.5 s would agree. 1 seed of ours must
// lie within 3 sigma of 2 s of that.
TEST(RaposaClosedLoop, DocksFromPointNineInAboutThePapersTimeAndTheSameWayTwice) {
  const System system = RaposaSystem({{"ferreira2009", MakeFerreira2009Controller}});
  const RunRecord a = RunFrom(system, "ferreira2009", 1.33, 0.0, 1),
                  b = RunFrom(system, "ferreira2009", 1.33, 0.0, 1);
  EXPECT_EQ(a.result.outcome, "docked") << a.failure_note;
  EXPECT_NEAR(a.result.sim_time_s, 37.9, 6.0);
  EXPECT_EQ(a.result.state_hash, b.result.state_hash);
  EXPECT_LT(MedianMiss_m(a), 0.10);
}

double MeasureOf(const RunRecord& record, const std::string& name) {
  const std::vector<Column> columns = Measures();
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].name == name) return record.result.measures.at(i);
  }
  throw std::out_of_range(name);
}

// The bars: six tenths of the paper's 37.9 s; the pyramid moved by less than 10 mm and
// turned by less than 3 deg before the doors close. The second start lies in the paper's dead zone.
TEST(RaposaClosedLoop, OwnControllerDocksFromPointNineAndFromTheDeadZone) {
  const System system = RaposaSystem({{"dockyard", MakeDockyardController}});
  const RunRecord far = RunFrom(system, "dockyard", 1.33, 0.0, 1);
  EXPECT_EQ(far.result.outcome, "docked") << far.failure_note;
  EXPECT_LT(far.result.sim_time_s, 0.6 * 37.88);
  EXPECT_LT(MeasureOf(far, "shift_before_doors_m"), 0.010);
  EXPECT_LT(MeasureOf(far, "turn_before_doors_deg"), 3.0);
  EXPECT_LT(MedianMiss_m(far), 0.02);
  const RunRecord near = RunFrom(system, "dockyard", 0.33, Radians(60.0), 1);
  EXPECT_EQ(near.result.outcome, "docked") << near.failure_note;
}

}  // namespace
}  // namespace dockyard::raposa
