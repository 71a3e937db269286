// Out of the socket and back into it, in closed loop.
#include <gtest/gtest.h>

#include "axel/sim/scenarios.h"

namespace dockyard::axel {
namespace {

TEST(ExcursionRun, LeavesTheConeGoesAsFarAsToldAndDocksAgain) {
  const RunRecord record = SimulateTypical({"axel.excursion_m=2", "time_limit_s=900"});
  EXPECT_EQ(record.history.front().phase, "undock");
  EXPECT_GE(MeasureOf(record, "farthest_m"), 0.9 * 2.0);
  EXPECT_TRUE(record.result.success) << record.failure_note;
}

}  // namespace
}  // namespace dockyard::axel
