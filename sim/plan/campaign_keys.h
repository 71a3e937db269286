// The keys of a campaign's file, stated once: its reader and its schema know no others.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace dockyard {

inline constexpr std::size_t kMostFactors = 100;        // keys of vary, and of one_at_a_time
inline constexpr std::size_t kMostFactorValues = 1000;  // of each
// The work for correlated keys grows with their number cubed: 8000 took minutes and 1.5 GB.
inline constexpr std::size_t kMostDraws = 200;

struct CampaignKey {
  std::string name, meaning;
};

const std::vector<CampaignKey>& CampaignKeys();
std::vector<std::string> CampaignKeyNames();

/// Words of `design.kind`, in the order of DesignKind.
const std::vector<std::string>& DesignWords();
/// Names of the distributions of `draw`.
const std::vector<std::string>& DistributionWords();

}  // namespace dockyard
