#include "sim/report/until_accepted.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "sim/log/record.h"
#include "statistics/follow_runs.h"
#include "support/fake_campaign.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

const SequentialAims kAims{.reliability = 0.8,
                           .confidence = 0.95,
                           .design_reliability = 0.95,
                           .power = 0.9,
                           .max_runs = 200};

Campaign Draws() {
  Campaign campaign;
  campaign.repeats = 200;
  return campaign;
}

TEST(UntilAccepted, TakesRunsThatAreDrawnIndependentlyAndAlike) {
  EXPECT_THAT(WhyNotSequential(Draws()), IsEmpty());
}

TEST(UntilAccepted, SaysWhyOtherCampaignsCannotBeJudged) {
  Campaign arms = Draws();
  arms.arms = {{"ours", {}}};
  EXPECT_EQ(WhyNotSequential(arms), "it has arms");
  EXPECT_THAT(WhyNotSequential(FakeCampaign(3)), HasSubstr("table"));
  Campaign grid = Draws();
  grid.grid = {{{"start.r_m", {}}, {"1", "2"}, {}}};
  EXPECT_THAT(WhyNotSequential(grid), HasSubstr("grid"));
  Campaign alone = Draws();
  alone.one_at_a_time = grid.grid;
  EXPECT_THAT(WhyNotSequential(alone), HasSubstr("one at a time"));
  for (const DesignKind kind : {DesignKind::kLatinHypercube, DesignKind::kSobol}) {
    Campaign design = Draws();
    design.design = kind;
    EXPECT_THAT(WhyNotSequential(design), HasSubstr("depend on each other"));
  }
}

TEST(UntilAccepted, StatesTheExactRatesOfItsTest) {
  const SequentialPlan plan = PlanSequential(kAims);
  const SequentialEnd end = FollowRuns(plan, std::vector<bool>(200, false));
  ASSERT_EQ(end.state, SequentialState::kAccepted);
  const Json json = SequentialJson(plan, end);
  EXPECT_EQ(json["verdict"], "accepted");
  EXPECT_EQ(json["trials"], end.trials);
  EXPECT_EQ(json["failures"], 0);
  const SequentialOperation bad = ExactOperation(plan, 0.8), good = ExactOperation(plan, 0.95);
  EXPECT_EQ(json["exact"][0]["accept"], bad.accept);
  EXPECT_LE(bad.accept, 0.05);
  EXPECT_EQ(json["exact"][0]["mean_runs"], bad.mean_runs);
  EXPECT_EQ(json["exact"][1]["not_accept"], good.reject);
  EXPECT_EQ(json["exact"][1]["undecided"], good.undecided);
  const std::string text = SequentialText(plan, end);
  EXPECT_THAT(text,
              HasSubstr("accepted after " + std::to_string(end.trials) + " runs, 0 failures"));
  EXPECT_THAT(text, HasSubstr("a system at 0.8: accepted with the chance 0.0"));
}

TEST(UntilAccepted, NamesEachEnd) {
  const SequentialPlan plan = PlanSequential(kAims);
  EXPECT_EQ(SequentialJson(plan, {})["verdict"], "not ended");
  const SequentialEnd bad = FollowRuns(plan, std::vector<bool>(200, true));
  EXPECT_EQ(SequentialJson(plan, bad)["verdict"], "not accepted");
  EXPECT_THAT(SequentialText(plan, bad), HasSubstr("not accepted after"));
  SequentialAims few = kAims;
  few.max_runs = 3;
  const SequentialPlan short_plan = PlanSequential(few);
  const SequentialEnd open = FollowRuns(short_plan, {false, false, false});
  EXPECT_EQ(SequentialJson(short_plan, open)["verdict"], "undecided");
}

// As a campaign does it: results end in any order, and count once all before them are there.
TEST(UntilAccepted, DecidesTheSameWhateverTheOrderInWhichRunsEnd) {
  const SequentialPlan plan = PlanSequential(kAims);
  std::vector<bool> failed;
  for (int i = 0; i < 200; ++i) failed.push_back(i % 13 == 5);
  const SequentialEnd serial = FollowRuns(plan, failed);
  std::mt19937 random(1);
  for (int window : {2, 8, 60}) {
    std::vector<std::size_t> order(failed.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    for (std::size_t i = 0; i + window <= order.size(); i += window) {
      std::shuffle(order.begin() + long(i), order.begin() + long(i) + window, random);
    }
    std::vector<char> there(failed.size(), 0);
    std::size_t next = 0;
    SequentialEnd end;
    for (const std::size_t ended : order) {
      there[ended] = 1;
      while (next < failed.size() && there[next]) FollowRun(plan, failed[next++], end);
    }
    EXPECT_EQ(end.state, serial.state);
    EXPECT_EQ(end.trials, serial.trials);
    EXPECT_EQ(end.failures, serial.failures);
  }
}

TEST(UntilAccepted, KnowsHowManyRunsDecided) {
  const SequentialPlan plan = PlanSequential(kAims);
  EXPECT_EQ(DecidedRuns(SequentialJson(plan, {}).dump()), 0);
  const SequentialEnd end = FollowRuns(plan, std::vector<bool>(200, false));
  const std::string text = SequentialJson(plan, end).dump();
  EXPECT_EQ(DecidedRuns(text), end.trials);
  EXPECT_EQ(DecidedRuns(WentOnText(text)), 0);
  EXPECT_TRUE(HasTheseAims(WentOnText(text), kAims));
  for (const char* damaged :
       {"", "[]", "{}", R"({"verdict": 3, "trials": 4})",
        R"({"verdict": "accepted", "trials": -1})", R"({"verdict": "accepted", "trials": 1e99})"}) {
    EXPECT_EQ(DecidedRuns(damaged), 0) << damaged;
  }
}

TEST(UntilAccepted, KnowsTheAimsThatAFolderWasBegunWith) {
  const std::string kept = SequentialJson(PlanSequential(kAims), {}).dump(2);
  EXPECT_TRUE(HasTheseAims(kept, kAims));
  SequentialAims other = kAims;
  other.reliability = 0.79;
  EXPECT_FALSE(HasTheseAims(kept, other));
  for (const char* damaged : {"", "{", "[]", "{\"aims\": 3}"}) {
    EXPECT_FALSE(HasTheseAims(damaged, kAims)) << damaged;
  }
}

}  // namespace
}  // namespace dockyard
