// Files that ask for much: they are refused, or checked in part, within seconds.
#include <gmock/gmock.h>

#include <functional>

#include "plan/toy_campaign.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

/// "  changes.k0: VALUE", "  changes.k1: VALUE", ... a line each.
std::string Keys(int count, const std::string& value) {
  std::string lines;
  for (int i = 0; i < count; ++i) lines += "  changes.k" + std::to_string(i) + ": " + value + "\n";
  return lines;
}

class LargeCampaign : public testing::Test {
 protected:
  std::string Message(const std::string& keys) const {
    return MessageOf(
        [&] {
          LoadAndCheck(folder_.Write("scenarios/l.yaml", "campaign: l\nbase: toy.yaml\n" + keys));
        },
        folder_);
  }
  ToyFolder folder_;
};

TEST_F(LargeCampaign, OfAMillionPointsHasEachValueChecked) {
  // 1000 x 1000 points, of which 10 000 are made.
  const std::string fine = "start.alpha_deg: {from: 0, to: 9.99, step: 0.01}";
  const auto grid = [&](const std::string& first, const std::string& second) {
    return Message("vary:\n  " + first + "\n  " + second + "\n");
  };
  EXPECT_EQ(grid(fine, "start.r_m: {from: 1, to: 1.999, step: 0.001}"), "(no error)");
  const std::string bad = "start.heading_deg: {from: 171, to: 1170, step: 1}";  // beyond 180
  EXPECT_THAT(grid(fine, bad), HasSubstr("start.heading_deg"));
  EXPECT_THAT(grid(bad, fine), HasSubstr("start.heading_deg"));
}

TEST_F(LargeCampaign, OfAMillionModelsHasThreeHundredChecked) {
  const Campaign campaign =
      LoadCampaign(folder_.Write("scenarios/l.yaml",
                                 "campaign: l\nbase: toy.yaml\nvary:\n"
                                 "  changes.a: {from: 1, to: 1000, step: 1}\n"
                                 "  changes.b: {from: 1, to: 1000, step: 1}\n"),
                   {}, ToyCampaigns());
  int checked = 0;
  CheckRuns(campaign, ToySystems(), [&](const Scenario&) { ++checked; });
  EXPECT_EQ(checked, 300);
}

TEST_F(LargeCampaign, HasABaseOfSoManyValuesAndNoMore) {
  const auto message = [&](int count) {
    std::string list;
    for (int i = 0; i < count; ++i) list += i == 0 ? "1" : ", 1";
    return Message("scenario: {changes: {k: [" + list + "]}}\nvary: {start.r_m: [2, 3]}\n");
  };
  EXPECT_EQ(message(9000), "(no error)");
  EXPECT_THAT(message(10000), HasSubstr("expected a base scenario of at most 10000 values"));
}

TEST_F(LargeCampaign, HasSoManyKeysAndNoMore) {
  EXPECT_THAT(Message("draw:\n" + Keys(201, "{uniform: {min: 1, max: 2}}")),
              HasSubstr("draw: expected at most 200 keys, found 201"));
  EXPECT_THAT(Message("vary:\n" + Keys(101, "[1]")),
              HasSubstr("vary: expected at most 100 keys, found 101"));
  EXPECT_THAT(Message("one_at_a_time:\n" + Keys(101, "[1]")),
              HasSubstr("one_at_a_time: expected at most 100 keys, found 101"));
}

}  // namespace
}  // namespace dockyard
