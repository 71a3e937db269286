#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "controller/custom/graceful.h"
#include "custom/controller/test_robot.h"

namespace dockyard::custom {
namespace {

using ::testing::HasSubstr;

std::string ReasonFor(const Nominal& nominal) {
  const auto made = MakeGracefulController(nominal);
  return made ? "" : made.error().reason;
}

TEST(MakeGracefulController, TakesARobotWithTwoWheelsAndABoardOfDiscs) {
  EXPECT_EQ(ReasonFor(NominalOf()), "");
}

TEST(MakeGracefulController, TakesABoardOfTagsNextToOneOfDiscs) {
  Nominal nominal = NominalOf();
  DockBoard tags = nominal.boards[0];
  tags.board.fiducials.clear();
  tags.board.tags = {{.family = "tag36h11", .id = 7, .size_m = 0.1}};
  nominal.boards.push_back(tags);
  EXPECT_EQ(ReasonFor(nominal), "");
}

TEST(MakeGracefulController, SaysWhichPartItCannotUse) {
  Nominal nominal = NominalOf();
  nominal.boards[0].board.fiducials.clear();
  EXPECT_THAT(ReasonFor(nominal), HasSubstr("board board: expected tags on it"));
  nominal = NominalOf();
  nominal.boards.clear();
  EXPECT_THAT(ReasonFor(nominal), HasSubstr("expected a board"));
  nominal = NominalOf();
  nominal.wheels[0].steering = 0;
  EXPECT_THAT(ReasonFor(nominal), HasSubstr("steered"));
  nominal = NominalOf();
  nominal.sensors.clear();
  EXPECT_THAT(ReasonFor(nominal), HasSubstr("charger_voltage_v or charger_closed"));
  nominal = NominalOf();
  nominal.cameras.clear();
  EXPECT_THAT(ReasonFor(nominal), HasSubstr("cameras"));
  nominal = NominalOf();
  nominal.docking.most_m_s = 0.05;
  EXPECT_THAT(ReasonFor(nominal), HasSubstr("the largest not below the least"));
}

}  // namespace
}  // namespace dockyard::custom
