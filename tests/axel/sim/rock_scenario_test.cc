// Rocks of a scenario in Axel's yard: what is built of them, what is refused, what is seen.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "axel/sim/scenarios.h"
#include "models/read/config_error.h"
#include "sim/axel/axel_plant.h"
#include "sim/rigid/rocks.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;

std::string Refused(const std::vector<std::string>& overrides) {
  try {
    Build(TypicalScenario(overrides));
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

TEST(RockScenario, FieldHasTheLawsNumberOutsideOfTheClearCircles) {
  const BuiltRun run = Build(TypicalScenario({"rocks.cover=0.1"}));
  const double clear_m2 = 2.0 * kPi * 1.5 * 1.5, yard_m2 = 144.0;
  // The circles reach out by half a rock, 4 cm on the mean, and the station's over the yard's end.
  const double expected = (yard_m2 - clear_m2) * RocksPerArea(0.1, 0.05, 0.30);
  EXPECT_NEAR(static_cast<double>(run.world.rocks.rocks.size()), expected,
              4.0 * std::sqrt(expected));
  for (const ConvexBody& rock : run.world.rocks.rocks) {
    const Eigen::Vector2d p = rock.centre.head<2>();
    EXPECT_GT(p.norm(), 1.5);
    EXPECT_GT(std::hypot(p.x() - run.world.X_DR_start.x, p.y() - run.world.X_DR_start.y), 1.5);
  }
}

TEST(RockScenario, StandsInTheUndulatingGround) {
  const BuiltRun run =
      Build(TypicalScenario({"yard.undulation_rms_m=0.05",
                             "rocks.given=[{x_m: 6, y_m: 3, diameter_m: 0.2, height_m: 0.08}]"}));
  ASSERT_EQ(run.world.rocks.rocks.size(), 1u);
  double top = -1.0;
  for (const Eigen::Vector3d& p : run.world.rocks.rocks[0].vertices) top = std::max(top, p.z());
  EXPECT_NEAR(top, run.world.ground.Height(6.0, 3.0) + 0.08, 1e-12);
  EXPECT_GT(std::abs(run.world.ground.Height(6.0, 3.0)), 1e-3);
}

TEST(RockScenario, RefusesWhatCannotBe) {
  EXPECT_THAT(Refused({"rocks={cover: 0.05, clear_m: 0.5}"}),
              HasSubstr("rocks: expected clear_m of at least 1.1"));
  EXPECT_THAT(Refused({"rocks.given=[{x_m: -0.3, y_m: 0, diameter_m: 0.2, height_m: 0.05}]"}),
              HasSubstr("rocks.given[0]: expected a rock that is not under the station"));
  EXPECT_THAT(Refused({"yard={length_m: 40, width_m: 40, cell_m: 0.05}", "rocks.cover=0.3"}),
              HasSubstr("rocks: expected at most 5000 rocks in the yard"));
  // The rover stands at 4 m, 15 deg aside; a rock half a metre before its axle is in its arm.
  EXPECT_THAT(Refused({"start.alpha_deg=0",
                       "rocks.given=[{x_m: 3.4, y_m: 0, diameter_m: 0.5, height_m: 0.3}]"}),
              HasSubstr("rocks: expected no rock in the rover's arm at the start"));
}

TEST(RockScenario, GivenOneUnderAWheelRollsTheStart) {
  Scenario scenario =
      TypicalScenario({"start.alpha_deg=0",
                       "rocks.given=[{x_m: 4, y_m: -0.425, diameter_m: 0.25, height_m: 0.08}]"});
  AxelPlant plant(scenario, Build(scenario), std::make_shared<KeptRenderer>());
  const double roll = ToRollPitchYaw(plant.truth().X_WR.R).roll;
  EXPECT_NEAR(Degrees(roll), Degrees(std::asin(0.08 / 0.85)), 1.2);
  EXPECT_GT(plant.truth().rock_force_n, 130.0);
}

TEST(RockScenario, IsSeenByTheCamerasAndBySpectators) {
  // A large rock ahead and aside, where without it only ground is seen.
  const std::string rock = "rocks.given=[{x_m: 2.2, y_m: 0.5, diameter_m: 0.5, height_m: 0.3}]";
  const auto images = [](const std::vector<std::string>& overrides) {
    const Scenario scenario = TypicalScenario(overrides);
    AxelPlant plant(scenario, Build(scenario), std::make_shared<KeptRenderer>());
    return std::get<GrayImage>(plant.TakeImages({kLeftCamera}, 0.0)[0].pixels);
  };
  const GrayImage without = images({"start.alpha_deg=0"}),
                  with = images({"start.alpha_deg=0", rock});
  ASSERT_EQ(without.pixels.size(), with.pixels.size());
  int differ = 0;
  for (std::size_t i = 0; i < with.pixels.size(); ++i) {
    if (std::abs(int{with.pixels[i]} - int{without.pixels[i]}) > 12) ++differ;
  }
  // Half a metre wide at 1.8 m: some hundredths of the picture, its shadow with it.
  EXPECT_GT(differ, 0.005 * static_cast<double>(with.pixels.size()));
  EXPECT_LT(differ, 0.2 * static_cast<double>(with.pixels.size()));

  const Scenario scenario = TypicalScenario({"start.alpha_deg=0", rock});
  const std::vector<System> systems = Systems();
  const StageShapes shapes = systems.front().shapes(scenario);
  AxelPlant plant(scenario, Build(scenario), std::make_shared<KeptRenderer>());
  const Stage stage = plant.Look();
  ASSERT_EQ(shapes.bodies.size(), stage.bodies.size());
  for (std::size_t i = 0; i < shapes.bodies.size(); ++i) {
    EXPECT_EQ(shapes.bodies[i].name, stage.bodies[i].name);
  }
  ASSERT_EQ(stage.solids.size(), 1u);
  EXPECT_EQ(stage.solids[0].corners_W->size() % 3, 0u);
  double top = 0.0;
  for (const Eigen::Vector3d& p : *stage.solids[0].corners_W) top = std::max(top, p.z());
  EXPECT_NEAR(top, 0.3, 0.03);
}

TEST(RockScenario, TheControllerIsToldOfNoRockByDefault) {
  EXPECT_EQ(Build(TypicalScenario({"rocks.cover=0.05"})).nominal.rock_map, RockMap{});
}

TEST(RockScenario, MapHasTheHighRocksWithASurveysErrors) {
  const auto map = [](const std::string& keys, const char* seed) {
    return Build(TypicalScenario({"rocks.cover=0.1", "axel.rock_map=" + keys, seed}))
        .nominal.rock_map;
  };
  const RockMap exact = map("{made: true, sigma_m: 0, least_height_m: 0.05}", "seed=3");
  const RockMap rough = map("{made: true, sigma_m: 0.1, least_height_m: 0.05}", "seed=3");
  const RockMap higher = map("{made: true, sigma_m: 0.1, least_height_m: 0.08}", "seed=3");
  ASSERT_GT(exact.rocks.size(), 20u);
  ASSERT_EQ(exact.rocks.size(), rough.rocks.size());
  double squares = 0.0;
  for (std::size_t i = 0; i < exact.rocks.size(); ++i) {
    EXPECT_GE(exact.rocks[i].height_m, 0.05);
    EXPECT_EQ(exact.rocks[i].radius_m, rough.rocks[i].radius_m);
    squares += std::pow(rough.rocks[i].x_m - exact.rocks[i].x_m, 2) +
               std::pow(rough.rocks[i].y_m - exact.rocks[i].y_m, 2);
  }
  const double n = 2.0 * static_cast<double>(exact.rocks.size());
  EXPECT_NEAR(std::sqrt(squares / n), 0.1, 4.0 * 0.1 / std::sqrt(2.0 * n));
  // A rock's error does not hang on which others are in the map.
  ASSERT_LT(higher.rocks.size(), rough.rocks.size());
  for (const MappedRock& rock : higher.rocks) {
    EXPECT_NE(std::find(rough.rocks.begin(), rough.rocks.end(), rock), rough.rocks.end());
  }
}

TEST(RockScenario, MapHasAGivenRockWhereItStands) {
  const RockMap map =
      Build(TypicalScenario({"rocks.given=[{x_m: 2, y_m: 1, diameter_m: 0.3, height_m: 0.2}]",
                             "axel.rock_map={made: true, sigma_m: 0}"}))
          .nominal.rock_map;
  ASSERT_EQ(map.rocks.size(), 1u);
  EXPECT_NEAR(map.rocks[0].x_m, 2.0, 1e-9);
  EXPECT_NEAR(map.rocks[0].y_m, 1.0, 1e-9);
  EXPECT_NEAR(map.rocks[0].height_m, 0.2, 0.01);
  EXPECT_NEAR(map.rocks[0].radius_m, 0.15, 0.05);
}

TEST(RockScenario, RefusesAMapThatIsBothMadeAndGiven) {
  const std::string given = "given: [{x_m: 2, y_m: 0, radius_m: 0.1, height_m: 0.2}]";
  EXPECT_EQ(Refused({"axel.rock_map={" + given + "}"}), "");
  EXPECT_THAT(Refused({"axel.rock_map={made: true, " + given + "}"}),
              HasSubstr("axel.rock_map.given: expected none beside made: true"));
  EXPECT_THAT(Refused({"axel.rock_map={given: [{x_m: 2, y_m: 0, radius_m: 0.1}]}"}),
              HasSubstr("height_m"));
}

TEST(RockScenario, SameSeedHasTheSameRocksAndAnotherOthers) {
  const auto first = [](const char* seed) {
    return Build(TypicalScenario({"rocks.cover=0.05", seed})).world.rocks.rocks[0].vertices[0];
  };
  EXPECT_EQ(first("seed=3"), first("seed=3"));
  EXPECT_NE(first("seed=3"), first("seed=4"));
}

}  // namespace
}  // namespace dockyard::axel
