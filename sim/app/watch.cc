#include "sim/app/watch.h"

#include <poll.h>

#include <cstdio>

#include "sim/app/exit_codes.h"
#include "sim/app/kept_campaign.h"
#include "sim/base/json.h"
#include "sim/campaign/finished_set.h"
#include "sim/campaign/progress.h"
#include "sim/jobs/signal_queue.h"

namespace dockyard {
namespace {

void Print(const Tally& tally, std::int64_t total, bool json,
           const std::vector<std::string>& warnings, const std::string& word) {
  if (json) {
    const Json line{{"done", tally.done},           {"total", total},
                    {"successes", tally.successes}, {"lost", tally.lost},
                    {"failures", tally.failures},   {"warnings", warnings}};
    std::printf("%s\n", line.dump().c_str());
  } else {
    std::printf("%s\n", TallyText(tally, total, word).c_str());
  }
  std::fflush(stdout);
}

}  // namespace

int WatchCampaign(const std::filesystem::path& dir, bool json, const Invocation& call) {
  const KeptCampaign kept = OpenKeptCampaign(dir, call.systems);
  const RowCheck check(kept.campaign);
  SignalQueue signals;
  for (std::int64_t shown = -1;;) {
    std::vector<std::string> damaged;
    const Tally tally = ReadFinished(dir, check, kept.columns, damaged).TallyOf(Shard{});
    if (tally.done != shown) {
      Print(tally, check.run_count(), json, call.warnings, SuccessWord(kept.columns));
    }
    shown = tally.done;
    if (tally.done == check.run_count()) return tally.lost == 0 ? kExitDone : kExitIncomplete;
    pollfd news{signals.descriptor(), POLLIN, 0};
    constexpr int kPause_ms = 2000;
    ::poll(&news, 1, kPause_ms);
    if (const int signal = signals.Take(); signal != 0) return kExitSignal + signal;
  }
}

}  // namespace dockyard
