#include "sim/report/arm_pairs.h"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dockyard {

namespace {

using Pair = std::pair<const RunResult*, const RunResult*>;
using Texts = std::vector<std::string>;

/// @param key_of  the texts that both runs of a pair share
ArmPairs PairBy(const Rows& a, const Rows& b,
                const std::function<Texts(const RunResult&)>& key_of) {
  std::map<Texts, Pair> pairs;
  ArmPairs found;
  const auto add = [&](const Rows& rows, auto member) {
    for (const RunResult* run : rows) {
      const RunResult*& place = pairs[key_of(*run)].*member;
      found.unpaired += place != nullptr ? 1 : 0;
      place = run;
    }
  };
  add(a, &Pair::first);
  add(b, &Pair::second);
  for (const auto& [key, pair] : pairs) {
    if (pair.first == nullptr || pair.second == nullptr) {
      ++found.unpaired;
      continue;
    }
    const bool of_a = pair.first->success, of_b = pair.second->success;
    found.counts.both += of_a && of_b;
    found.counts.only_a += of_a && !of_b;
    found.counts.only_b += !of_a && of_b;
    found.counts.neither += !of_a && !of_b;
  }
  return found;
}

}  // namespace

ArmPairs PairArms(const Rows& a, const Rows& b) {
  return PairBy(a, b, [](const RunResult& run) {
    Texts key(run.labels.begin() + 1, run.labels.end());
    key.push_back(std::to_string(run.seed));
    return key;
  });
}

ArmPairs PairGroups(const std::string& label, const RowColumns& columns, const Rows& a,
                    const Rows& b) {
  const auto of_group = [&](const std::string& name) {
    return name == label || name == "point" || (label == "changed" && name == "changed_to");
  };
  return PairBy(a, b, [&](const RunResult& run) {
    Texts key{std::to_string(run.seed)};
    for (std::size_t i = 0; i < columns.labels.size(); ++i) {
      if (!of_group(columns.labels[i])) key.push_back(run.labels[i]);
    }
    if (label != "controller" && label != "arm") key.push_back(run.controller);
    return key;
  });
}

}  // namespace dockyard
