// Dockings from start to end: images of a tag, controller, physics, judge.
#include <gtest/gtest.h>

#include "controller/custom/graceful.h"
#include "custom/charger_rig.h"
#include "sim/run/loop.h"

namespace dockyard::custom {
namespace {

std::unique_ptr<Controller> Graceful(const Nominal& nominal) {
  auto made = MakeGracefulController(nominal);
  if (!made) RefuseController("graceful", made.error().reason);
  return std::move(*made);
}

RunRecord Dock(const std::vector<std::string>& overrides) {
  CampaignRun run;
  run.scenario = ChargerScenario(overrides);
  return Simulate(CustomSystem({{"graceful", Graceful}}), run, {});
}

TEST(CustomClosedLoop, DocksByATagFromTheSideTwiceWithTheSameBits) {
  const std::vector<std::string> overrides{
      "start={r_m: 0.7, alpha_deg: -15, heading_deg: -5}",
      "as_built={dock: {place: {x_m: 0.02, y_m: -0.03, yaw_deg: 3}}}"};
  const RunRecord a = Dock(overrides);
  const RunRecord b = Dock(overrides);
  EXPECT_EQ(a.result.outcome, "docked") << a.failure_note;
  EXPECT_EQ(a.result.state_hash, b.result.state_hash);
}

TEST(CustomClosedLoop, GivesUpWhereTheTagIsCovered) {
  const RunRecord run = Dock({"start={r_m: 0.8, alpha_deg: 0, heading_deg: 0}", "time_limit_s=60",
                              "graceful={search_rad_s: 1.5, most_rad_s: 1.5, perception_s: 1}",
                              "changes={dock: {boards_as_built: {dust: 0.6, wear: 0.6}}}"});
  EXPECT_EQ(run.result.outcome, "gave_up") << run.failure_note;
}

}  // namespace
}  // namespace dockyard::custom
