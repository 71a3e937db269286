#include "sim/report/baseline.h"

#include <algorithm>
#include <cstddef>
#include <unordered_map>
#include <utility>

namespace dockyard {
namespace {

/// Places of the labels that both sides have: here and there.
using SharedLabels = std::vector<std::pair<std::size_t, std::size_t>>;

SharedLabels SharedLabelsOf(const RowColumns& here, const RowColumns& there) {
  SharedLabels shared;
  for (std::size_t i = 0; i < here.labels.size(); ++i) {
    const auto at = std::find(there.labels.begin(), there.labels.end(), here.labels[i]);
    if (at == there.labels.end()) continue;
    shared.push_back({i, static_cast<std::size_t>(at - there.labels.begin())});
  }
  return shared;
}

bool SameDraw(const RunResult& here, const RunResult& there, const SharedLabels& shared) {
  return here.seed == there.seed &&
         std::all_of(shared.begin(), shared.end(), [&](const auto& label) {
           return here.labels[label.first] == there.labels[label.second];
         });
}

}  // namespace

BaselinePairs PairWithBaseline(const RowColumns& columns, const std::vector<RunResult>& rows,
                               const RowColumns& baseline_columns,
                               const std::vector<RunResult>& baseline) {
  const SharedLabels shared = SharedLabelsOf(columns, baseline_columns);
  std::unordered_map<int, const RunResult*> partners;
  for (const RunResult& row : baseline) partners[row.run] = &row;
  BaselinePairs pairs;
  for (const RunResult& here : rows) {
    const auto found = partners.find(here.run);
    if (found == partners.end()) {
      pairs.only_here.push_back(here.run);
      continue;
    }
    const RunResult& there = *found->second;
    partners.erase(found);
    if (!SameDraw(here, there, shared)) {
      pairs.other_draw.push_back(here.run);
      continue;
    }
    pairs.counts.both += here.success && there.success;
    pairs.counts.neither += !here.success && !there.success;
    if (here.success && !there.success) pairs.won.push_back(here.run);
    if (!here.success && there.success) pairs.lost.push_back(here.run);
    pairs.same_bits += here.state_hash == there.state_hash && here.outcome == there.outcome;
  }
  for (const auto& [run, row] : partners) pairs.only_there.push_back(run);
  std::sort(pairs.only_there.begin(), pairs.only_there.end());
  pairs.counts.only_a = static_cast<int>(pairs.won.size());
  pairs.counts.only_b = static_cast<int>(pairs.lost.size());
  return pairs;
}

}  // namespace dockyard
