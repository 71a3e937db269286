#include "sim/page/groups_part.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/fake_runs.h"

namespace dockyard {
namespace {

std::vector<std::string> LabelsOf(const Json& groups) {
  std::vector<std::string> labels;
  for (const Json& group : groups) labels.push_back(group["label"]);
  return labels;
}

std::vector<std::string> ValuesOf(const Json& group) {
  std::vector<std::string> values;
  for (const Json& value : group["values"]) values.push_back(value["value"]);
  return values;
}

// Nine ranges of two runs each: a factor if the file lists them, none if they were drawn.
TEST(GroupsPart, DrawnNumbersAreNoSettings) {
  Campaign drawn, listed;
  drawn.dispersions.resize(1);
  drawn.dispersions[0].key.name = "start.r_m";
  listed.grid.resize(1);
  listed.grid[0].key.name = "start.r_m";
  const FinishedRuns runs = FakeResults(18);
  EXPECT_THAT(LabelsOf(GroupsPart(&drawn, runs, FakeColumns())), testing::ElementsAre("soil"));
  EXPECT_THAT(LabelsOf(GroupsPart(&listed, runs, FakeColumns())),
              testing::ElementsAre("soil", "start.r_m"));
}

TEST(GroupsPart, TheNumbersOfPointsAndRepeatsAreNoSettings) {
  RowColumns columns = FakeColumns();
  columns.labels = {"point", "repeat"};
  const Campaign campaign;
  EXPECT_TRUE(GroupsPart(&campaign, FakeResults(90), columns).empty());
}

TEST(GroupsPart, AValueOfItsOwnForEachRunIsNoSetting) {
  const Campaign campaign;
  EXPECT_THAT(LabelsOf(GroupsPart(&campaign, FakeResults(9), FakeColumns())),
              testing::ElementsAre("soil"));
}

TEST(GroupsPart, NumbersRiseAndWordsKeepTheirOrder) {
  Campaign campaign;
  campaign.grid.resize(1);
  campaign.grid[0].key.name = "start.r_m";
  FinishedRuns runs = FakeResults(4);
  const std::vector<std::string> order{"5.5", "10", "6", "3.5"};
  for (std::size_t i = 0; i < order.size(); ++i) runs.results[i].labels[1] = order[i];
  const Json groups = GroupsPart(&campaign, runs, FakeColumns());
  ASSERT_EQ(groups.size(), 2u);
  EXPECT_THAT(ValuesOf(groups[0]), testing::ElementsAre("compact", "loose"));
  EXPECT_THAT(ValuesOf(groups[1]), testing::ElementsAre("3.5", "5.5", "6", "10"));
}

}  // namespace
}  // namespace dockyard
