#pragma once

#include "sim/campaign/campaign.h"
#include "sim/campaign/merge.h"

namespace dockyard {

/// All runs of a campaign as `dockyard campaign` makes them, then its results.
inline CampaignEnd RunCampaign(const Campaign& campaign, const RunFunction& function,
                               const CampaignOptions& options) {
  RunShard(campaign, function, options);
  return MergeShards(options.out_dir, campaign, options.columns);
}

}  // namespace dockyard
