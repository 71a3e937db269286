// The table that `campaign --dry-run` prints makes the same runs again.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "sim/app/scenario_options.h"
#include "sim/app/systems.h"
#include "sim/plan/make_run.h"
#include "sim/scenario/scenario_keys.h"
#include "support/bad_files.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;

TEST(DryRunTable, OfTheAcceptanceMakesTheSameStartsFilesAndSeeds) {
  const std::vector<KnownSystem> known = KnownSystems(Systems());
  const ScratchFolder folder;
  const std::string file = SourceFile("scenarios/axel_acceptance.yaml");
  const Campaign campaign = LoadCampaign(file, {"design.runs=12"}, {known, {}});
  const std::string table = folder.Write("plan.csv", PlanCsv(campaign, known));
  const Campaign again = LoadCampaign(file, {"table=" + table}, {known, {}});
  EXPECT_TRUE(again.dispersions.empty());
  const RunMaker first(campaign, known), second(again, known);
  ASSERT_EQ(second.run_count(), 12);
  std::set<std::string> soils;
  for (std::int64_t i = 0; i < 12; ++i) {
    const CampaignRun run = first.Make(i), same = second.Make(i);
    EXPECT_EQ(same.run, run.run);
    EXPECT_EQ(same.scenario.seed, run.scenario.seed);
    EXPECT_EQ(same.scenario.start.on_plane().r, run.scenario.start.on_plane().r);
    EXPECT_EQ(same.scenario.soil_file, run.scenario.soil_file);
    EXPECT_THAT(DifferingKeys(same.scenario, run.scenario), ElementsAre());
    soils.insert(run.scenario.soil_file);
  }
  EXPECT_EQ(soils.size(), 2u);
}

}  // namespace
}  // namespace dockyard
