#include "support/fake_campaign.h"

#include "support/fake_runs.h"

namespace dockyard {

std::vector<KnownSystem> FakeSystems() { return {{"fake", {"straight"}, {}, {}}}; }

Campaign FakeCampaign(int count) {
  Campaign campaign;
  campaign.name = "fake";
  campaign.seed = 7;
  campaign.base =
      ParseYaml("{system: fake, start: {r_m: 4, alpha_deg: 0, heading_deg: 0}}", "fake.yaml");
  campaign.tags = {"soil"};
  campaign.labels = FakeColumns().labels;
  std::string rows;
  for (const CampaignRun& run : FakeRuns(count)) {
    rows += "- {run: " + std::to_string(run.run) + ", soil: " + run.labels[0] +
            ", start.r_m: " + run.labels[1] + "}\n";
  }
  campaign.table = ReadTable(ParseYaml(rows, "fake.yaml"), "runs");
  return campaign;
}

}  // namespace dockyard
