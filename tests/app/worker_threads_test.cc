// The threads of workers in a campaign: one each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <string>

#include "sim/app/campaign_setup.h"
#include "sim/app/systems.h"
#include "support/bad_files.h"
#include "support/run_campaign.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t ThreadsOfThisProcess() {
  return std::distance(fs::directory_iterator("/proc/self/task"), fs::directory_iterator());
}

using ShortRun = std::pair<const char*, const char*>;  // scenario, and time of its first images [s]

/// Runs two short runs with a worker each; a worker counts its threads after its run.
class Workers : public testing::TestWithParam<ShortRun> {
 protected:
  void Run(const ShortRun& run) {
    CampaignArguments arguments;
    arguments.out_dir = (folder_.path() / "results").string();
    arguments.file = folder_.Write("campaign.yaml",
                                   "campaign: threads\nseed: 1\nbase: " + SourceFile(run.first) +
                                       "\nscenario: {time_limit_s: " + run.second +
                                       "}\n"
                                       "design: {kind: monte_carlo, runs: 2}\n"
                                       "draw: {start.alpha_deg: {uniform: {min: -5, max: 5}}}\n");
    ReadyCampaign ready = MakeReady(LoadCampaign(arguments, systems_), arguments, systems_);
    ready.options.jobs = 2;
    const auto counting = [&](const CampaignRun& what, const RunLogging& log_dir) {
      RunRecord record = ready.run(what, log_dir);
      folder_.Write(std::to_string(what.run), std::to_string(ThreadsOfThisProcess()));
      folder_.Write("images" + std::to_string(what.run), std::to_string(record.result.images));
      return record;
    };
    RunCampaign(ready.campaign, counting, ready.options);
  }
  std::string Text(const std::string& name) const { return Slurp(folder_.path() / name); }

  const ScratchFolder folder_;
  const std::vector<System> systems_ = Systems();
};

TEST_P(Workers, HaveOneThreadAfterARunWithImages) {
  Run(GetParam());
  for (const char* run : {"1", "2"}) {
    EXPECT_NE(Text(std::string("images") + run), "0");
    EXPECT_EQ(Text(run), "1") << "run " << run;
  }
}

INSTANTIATE_TEST_SUITE_P(OfACampaign, Workers,
                         testing::Values(ShortRun("scenarios/axel_typical.yaml", "5"),
                                         ShortRun("scenarios/raposa_point_9.yaml", "0.5"),
                                         ShortRun("scenarios/rocky7_grasp.yaml", "0.5")));

}  // namespace
}  // namespace dockyard
