#include "plan/toy_campaign.h"

namespace dockyard {

CampaignSystems ToyCampaigns() {
  return {ToySystems(), [](const std::string& system) {
            return std::vector<std::string>{"success", "distance_to_" + system};
          }};
}

std::vector<CampaignRun> AllRuns(const Campaign& campaign,
                                 const std::vector<KnownSystem>& systems) {
  const RunMaker maker(campaign, systems);
  std::vector<CampaignRun> runs;
  for (std::int64_t i = 0; i < campaign.run_count(); ++i) runs.push_back(maker.Make(i));
  return runs;
}

Campaign LoadAndCheck(const std::string& file, const std::vector<std::string>& overrides) {
  Campaign campaign = LoadCampaign(file, overrides, ToyCampaigns());
  CheckRuns(campaign, ToySystems(), {});
  return campaign;
}

}  // namespace dockyard
