// Whether a row of a results folder can be one of its campaign.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "sim/plan/campaign.h"
#include "sim/plan/make_run.h"

namespace dockyard {

/// What a row says of its run before the outcome.
struct RowPlan {
  int run = 0;
  std::uint64_t seed = 0;
  std::string_view labels;  // the cells as a line of CSV
};

/// Check values of rows are no secret, so anybody can write rows: those of runs that were never
/// planned, or with other draws, must not count.
class RowCheck {
 public:
  /// The campaign must outlive it. Where it is sealed and its secret is not known, neither drawn
  /// seeds nor drawn labels follow from it, and any will do.
  explicit RowCheck(const Campaign& campaign);
  /// Any row will do.
  static RowCheck OfNoCampaign();
  ~RowCheck();
  RowCheck(RowCheck&&) noexcept;

  std::int64_t run_count() const;
  /// The index of the row's run; -1 without a campaign. Throws ResultsError for a row that is none
  /// of the campaign's.
  std::int64_t Require(const RowPlan& row, const std::filesystem::path& file) const;

 private:
  RowCheck();
  struct Plan;
  std::unique_ptr<Plan> plan_;
};

}  // namespace dockyard
