#include "sim/campaign/finished_set.h"

#include <algorithm>

#include "controller/base/check.h"
#include "sim/log/column.h"

namespace dockyard {

void FinishedSet::Add(std::int64_t index, bool success, std::string_view outcome) {
  if (Has(index) && !Lost(index)) return;
  const auto known = std::find_if(outcomes_.begin(), outcomes_.end(), [&](const Outcome& each) {
    return each.name == outcome && each.success == success;
  });
  const std::size_t place = static_cast<std::size_t>(known - outcomes_.begin());
  if (known == outcomes_.end()) {
    DOCKYARD_CHECK(outcomes_.size() < 255);
    outcomes_.push_back({std::string(outcome), success, IsLost(outcome)});
  }
  states_[static_cast<std::size_t>(index)] = static_cast<std::uint8_t>(place + 1);
}

Tally FinishedSet::TallyOf(const Shard& shard) const {
  std::vector<std::int64_t> counts(outcomes_.size() + 1, 0);
  for (std::int64_t i = shard.number - 1; i < run_count(); i += shard.count) ++counts[StateOf(i)];
  Tally tally;
  for (std::size_t i = 0; i < outcomes_.size(); ++i) {
    const Outcome& outcome = outcomes_[i];
    const std::int64_t count = counts[i + 1];
    tally.done += count;
    if (outcome.success) tally.successes += count;
    if (outcome.lost) tally.lost += count;
    if (!outcome.success && count > 0) tally.failures[outcome.name] += count;
  }
  return tally;
}

FinishedSet ReadFinished(const std::filesystem::path& dir, const RowCheck& check,
                         const RowColumns& columns, std::vector<std::string>& damaged) {
  FinishedSet finished(check.run_count());
  for (const std::filesystem::path& path : ShardFiles(dir)) {
    const ShardReader shard(path, columns);
    const std::vector<int> lines = shard.ForEach([&](const RowPlace& row) {
      finished.Add(check.Require(row, path), row.success, row.outcome);
    });
    for (const int line : lines) damaged.push_back(path.string() + ":" + std::to_string(line));
  }
  return finished;
}

}  // namespace dockyard
