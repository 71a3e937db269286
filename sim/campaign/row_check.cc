#include "sim/campaign/row_check.h"

#include <string>
#include <vector>

#include "sim/base/text.h"
#include "sim/log/results.h"

namespace dockyard {
namespace {

[[noreturn]] void Refuse(const RowPlan& row, const std::string& what,
                         const std::filesystem::path& file) {
  throw ResultsError(file.string() + ": run " + std::to_string(row.run) +
                     " does not belong to this campaign: " + what +
                     "; remove the file, and run the campaign again");
}

}  // namespace

struct RowCheck::Plan {
  const Campaign& campaign;
  std::vector<KnownSystem> none{};  // no scenario is made
  RunMaker maker{campaign, none};
};

RowCheck::RowCheck() = default;
RowCheck::~RowCheck() = default;
RowCheck::RowCheck(RowCheck&&) noexcept = default;

RowCheck::RowCheck(const Campaign& campaign) : plan_(new Plan{campaign}) {}

RowCheck RowCheck::OfNoCampaign() { return {}; }

std::int64_t RowCheck::run_count() const { return plan_ ? plan_->maker.run_count() : 0; }

std::int64_t RowCheck::Require(const RowPlan& row, const std::filesystem::path& file) const {
  if (!plan_) return -1;
  const std::int64_t index = plan_->maker.IndexOf(row.run);
  if (index < 0) Refuse(row, "it has no run of that number", file);
  const std::uint64_t seed = plan_->maker.SeedNumber(index).value_or(row.seed);
  if (seed != row.seed) {
    Refuse(row, "its seed is " + std::to_string(seed) + ", not " + std::to_string(row.seed), file);
  }
  std::vector<std::string> labels = plan_->maker.Labels(index);
  if (!plan_->campaign.is_hidden()) {
    if (row.labels != CsvLine(labels)) Refuse(row, "its labels differ from the plan's", file);
    return index;
  }
  labels.resize(labels.size() - plan_->campaign.dispersions.size());
  const std::string known = CsvLine(labels);
  const bool same =
      row.labels.starts_with(known) &&
      (labels.empty() || row.labels.size() == known.size() || row.labels[known.size()] == ',');
  if (!same) Refuse(row, "its labels differ from the plan's", file);
  return index;
}

}  // namespace dockyard
