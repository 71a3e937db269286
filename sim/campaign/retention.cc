#include "sim/campaign/retention.h"

#include "sim/base/hash.h"

namespace dockyard {

// By a hash: every n-th of a grid's runs would be the same point of it.
bool StaysIfSuccess(const Keep& keep, int run) {
  const auto n = static_cast<std::uint64_t>(keep.every_nth_success);
  return n > 0 && HashBits(kHashSeed, static_cast<std::uint64_t>(run)) % n == 0;
}

Retention::Choice Retention::Choose(const RunResult& result) {
  if (result.success) return {StaysIfSuccess(keep_, result.run), std::nullopt};
  if (keep_.failures_per_cause < 0) return {true, std::nullopt};
  std::set<int>& kept = kept_failures_[result.outcome];
  kept.insert(result.run);
  if (static_cast<std::int64_t>(kept.size()) <= keep_.failures_per_cause) {
    return {true, std::nullopt};
  }
  const int last = *kept.rbegin();
  kept.erase(last);
  if (last == result.run) return {false, std::nullopt};
  return {true, last};
}

}  // namespace dockyard
