#include "sim/report/arm_pairs.h"

#include <map>
#include <utility>
#include <vector>

namespace dockyard {

ArmPairs PairArms(const Rows& a, const Rows& b) {
  using Pair = std::pair<const RunResult*, const RunResult*>;
  std::map<std::vector<std::string>, Pair> pairs;
  const auto add = [&](const Rows& rows, auto member) {
    for (const RunResult* run : rows) {
      std::vector<std::string> key(run->labels.begin() + 1, run->labels.end());
      key.push_back(std::to_string(run->seed));
      pairs[key].*member = run;
    }
  };
  add(a, &Pair::first);
  add(b, &Pair::second);
  ArmPairs found;
  for (const auto& [key, pair] : pairs) {
    if (pair.first == nullptr || pair.second == nullptr) {
      ++found.unpaired;
      continue;
    }
    const bool of_a = pair.first->docked, of_b = pair.second->docked;
    found.counts.both += of_a && of_b;
    found.counts.only_a += of_a && !of_b;
    found.counts.only_b += !of_a && of_b;
    found.counts.neither += !of_a && !of_b;
  }
  return found;
}

}  // namespace dockyard
