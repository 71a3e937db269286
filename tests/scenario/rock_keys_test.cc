// Keys of rocks: what good values become and how bad ones are reported.
#include <gmock/gmock.h>

#include "scenario/toy_system.h"
#include "sim/scenario/load_scenario.h"
#include "sim/scenario/rock_keys.h"

namespace dockyard {
namespace {

class RockKeys : public testing::Test {
 protected:
  Scenario Loaded(const std::string& lines) const {
    return LoadScenario(folder_.And(lines), {}, systems_);
  }
  std::string Refused(const std::string& lines) const {
    const std::string file = folder_.And(lines);
    return MessageOf([&] { LoadScenario(file, {}, systems_); }, folder_);
  }

  ToyFolder folder_;
  std::vector<KnownSystem> systems_ = ToySystems();
};

TEST_F(RockKeys, NoRockIsTheDefault) {
  EXPECT_FALSE(HasRocks(Loaded("").rocks));
  EXPECT_FALSE(HasRocks(Loaded("rocks: {least_m: 0.08}").rocks));
}

TEST_F(RockKeys, EachKeyArrives) {
  const RockField rocks =
      Loaded(
          "rocks: {cover: 0.05, least_m: 0.06, largest_m: 0.4, clear_m: 1.2, flattest: 0.3, "
          "steepest: 0.6, buried: 0.2, friction: 0.5, given: [{x_m: 2, y_m: -1, diameter_m: 0.2, "
          "height_m: 0.08, turn_deg: 90}, {x_m: 3, y_m: 0, diameter_m: 0.1, height_m: 0.05}]}")
          .rocks;
  EXPECT_TRUE(HasRocks(rocks));
  EXPECT_EQ(rocks.cover, 0.05);
  EXPECT_EQ(rocks.least_m, 0.06);
  EXPECT_EQ(rocks.largest_m, 0.4);
  EXPECT_EQ(rocks.clear_m, 1.2);
  EXPECT_EQ(rocks.flattest, 0.3);
  EXPECT_EQ(rocks.steepest, 0.6);
  EXPECT_EQ(rocks.buried, 0.2);
  EXPECT_EQ(rocks.friction, 0.5);
  ASSERT_EQ(rocks.given.size(), 2u);
  EXPECT_EQ(rocks.given[0].x_m, 2.0);
  EXPECT_EQ(rocks.given[0].y_m, -1.0);
  EXPECT_EQ(rocks.given[0].diameter_m, 0.2);
  EXPECT_EQ(rocks.given[0].height_m, 0.08);
  EXPECT_EQ(rocks.given[0].turn_rad, 0.5 * kPi);
  EXPECT_EQ(rocks.given[1].turn_rad, 0.0);
}

TEST_F(RockKeys, WrittenOnesReadBack) {
  const std::string written = ResolvedYaml(
      Loaded("rocks: {cover: 0.05, given: [{x_m: 2, y_m: -1, diameter_m: 0.2, height_m: 0.08}]}"));
  const std::string file = folder_.Write("scenarios/written.yaml", written);
  const Scenario again = LoadScenario(file, {}, systems_);
  EXPECT_EQ(ResolvedYaml(again), written);
  EXPECT_EQ(again.rocks.given.size(), 1u);
}

TEST_F(RockKeys, BadOnesAreReportedByPlace) {
  EXPECT_EQ(Refused("rocks: {cover: 0.4}"),
            "scenarios/s.yaml:10:16: rocks.cover: expected a number >= 0 and <= 0.3, found '0.4'");
  EXPECT_EQ(Refused("rocks: {least_m: 0.5}"),
            "scenarios/s.yaml:10:18: rocks.least_m: expected at most rocks.largest_m");
  EXPECT_EQ(Refused("rocks: {steepest: 0.2}"),
            "scenarios/s.yaml:10:19: rocks.flattest: expected at most rocks.steepest");
  EXPECT_EQ(Refused("rocks: {given: 3}"),
            "scenarios/s.yaml:10:16: rocks.given: expected a list, found '3'");
  EXPECT_EQ(Refused("rocks: {given: [{x_m: 2, y_m: 0, height_m: 0.1}]}"),
            "scenarios/s.yaml:10:17: rocks.given[0]: missing key 'diameter_m'");
  EXPECT_EQ(Refused("rocks: {given: [{x_m: 2, y_m: 0, diameter_m: 5, height_m: 0.1}]}"),
            "scenarios/s.yaml:10:46: rocks.given[0].diameter_m: expected a number from 0.02 to 2, "
            "found '5'");
  EXPECT_EQ(Refused("rocks: {given: [{x_m: 60, y_m: 0, diameter_m: 0.2, height_m: 0.1}]}"),
            "scenarios/s.yaml:10:17: rocks.given[0]: expected a rock inside the yard");
}

TEST_F(RockKeys, SystemThatHasNoneRefusesThem) {
  systems_.front().rocks = false;
  EXPECT_EQ(Refused("rocks: {cover: 0.05}"),
            "scenarios/s.yaml:10:16: rocks: expected no rocks, as the system toy has none");
  EXPECT_EQ(Loaded("rocks: {cover: 0}").rocks.cover, 0.0);
}

}  // namespace
}  // namespace dockyard
