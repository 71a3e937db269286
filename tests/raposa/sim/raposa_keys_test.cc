// What a scenario says under `raposa` reaches the world and the controller.
#include "sim/raposa/raposa_keys.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "models/read/config_error.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_spreads.h"
#include "models/read/yaml_path.h"
#include "raposa/sim/pictures.h"
#include "raposa/sim/raposa_rig.h"
#include "sim/plant/model_store.h"
#include "sim/plant/placement.h"
#include "sim/plant/scenery.h"
#include "sim/raposa/clutter.h"
#include "support/source_tree.h"

namespace dockyard::raposa {
namespace {

BuiltRun Built(const Scenario& scenario) { return BuildRun(scenario, LoadModels(scenario)); }

TEST(RaposaKeys, PageHasTheTableThatTheVisitorDocuments) {
  std::ifstream file(SourceFile("docs/reference/scenarios.md"));
  std::stringstream page;
  page << file.rdbuf();
  const std::string begin = "tests/raposa/sim/raposa_keys_test.cc -->\n";
  const std::size_t from = page.str().find(begin),
                    to = page.str().find("<!-- end of keys of raposa");
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  RaposaKeys values;
  EXPECT_EQ(page.str().substr(from + begin.size(), to - from - begin.size()),
            KeyTable(DocumentKeys([&](Keys& keys) { VisitRaposaKeys(keys, values); })));
}

TEST(RaposaKeys, BandsAndTheirChangesReachTheController) {
  const Scenario scenario = ScenarioAt(
      1.0, 0.0,
      "bands: {orange: {hue: [175, 9], saturation: [60, 255], value: [40, 250]}}, "
      "band_changes: [{at_s: 2, blue: {hue: [90, 120], saturation: [1, 2], value: [3, 4]}}, "
      "{at_s: 5, orange: {hue: [1, 2], saturation: [3, 4], value: [5, 6]}}]");
  const FerreiraVision told = Built(scenario).nominal.ferreira_vision, before;
  const HsvBand orange{175, 9, 60, 255, 40, 250}, blue{90, 120, 1, 2, 3, 4};
  EXPECT_EQ(told.orange, orange);
  EXPECT_EQ(told.blue, before.blue);
  ASSERT_EQ(told.band_changes.size(), 2u);
  EXPECT_EQ(told.band_changes[0], (BandChange{2.0, orange, blue}));
  EXPECT_EQ(told.band_changes[1], (BandChange{5.0, HsvBand{1, 2, 3, 4, 5, 6}, blue}));
}

TEST(RaposaKeys, BandsThatAreNoneAreRefused) {
  for (const char* keys : {"bands: {red: {hue: [1, 2], saturation: [1, 2], value: [1, 2]}}",
                           "bands: {blue: {hue: [1, 180], saturation: [1, 2], value: [1, 2]}}",
                           "bands: {blue: {hue: [1, 2], saturation: [2, 1], value: [1, 2]}}",
                           "bands: {blue: {hue: [1, 2], saturation: [1, 2.5], value: [1, 2]}}",
                           "band_changes: [{at_s: 2}, {at_s: 1}]"}) {
    EXPECT_THROW(Built(ScenarioAt(1.0, 0.0, keys)), ConfigError) << keys;
  }
}

TEST(RaposaKeys, MotionReachesTheControllerInRadians) {
  const FerreiraMotion told =
      Built(ScenarioAt(1.0, 0.0,
                       "motion: {k_linear_per_s: 0.07, turn_deg_s: 16, steer_final: false}"))
          .nominal.ferreira_motion;
  FerreiraMotion expected;
  expected.k_linear_per_s = 0.07;
  expected.turn_rad_s = Radians(16.0);
  expected.steer_final = false;
  EXPECT_EQ(told, expected);
}

TEST(RaposaKeys, VisionReachesTheController) {
  const FerreiraVision vision =
      Built(ScenarioAt(1.0, 0.0, "vision: {least_area_px2: 20, ball_px: 30, lost_frames: 5}"))
          .nominal.ferreira_vision;
  FerreiraVision expected;
  expected.least_area_px2 = 20.0;
  expected.ball_px = 30.0;
  expected.lost_frames = 5;
  EXPECT_EQ(vision, expected);
  for (const char* keys : {"vision: {lost_frames: 0}", "vision: {lost_frames: 1.5}",
                           "vision: {least_area: 20}", "vision: {ball_px: -1}"}) {
    EXPECT_THROW(Built(ScenarioAt(1.0, 0.0, keys)), ConfigError) << keys;
  }
}

TEST(RaposaKeys, MotionThatIsNoneIsRefused) {
  for (const char* keys : {"motion: {turn_rad_s: 0.3}", "motion: {standoff_m: -1}",
                           "motion: {doors_s: soon}", "motion: {k_linear: 0.07}"}) {
    EXPECT_THROW(Built(ScenarioAt(1.0, 0.0, keys)), ConfigError) << keys;
  }
}

TEST(RaposaKeys, TheStartLooksOffTheGuideByTheAngle) {
  const BuiltRun run = Built(ScenarioAt(2.0, Radians(110.0), "off_guide_deg: 7"));
  const Pose2& X_DV = run.world.X_DV_start;
  const double to_guide = std::atan2(-X_DV.y, -X_DV.x);
  EXPECT_NEAR(std::remainder(X_DV.heading - to_guide, 2.0 * kPi), Radians(7.0), 1e-9);
  EXPECT_NEAR(X_DV.x, 2.0 * std::cos(Radians(110.0)), 1e-12);
}

TEST(RaposaKeys, AStartBeyondTheGroundBehindThePyramidIsRefused) {
  EXPECT_NO_THROW(Built(ScenarioAt(2.5, Radians(110.0))));
  EXPECT_THROW(Built(ScenarioAt(2.5, Radians(110.0), "behind_m: 1.5")), ConfigError);
}

TEST(RaposaKeys, SunsOwnColoursAreRefusedAsTheSpectraWouldDropThem) {
  Scenario scenario = ScenarioAt(1.0, 0.0);
  scenario.sun.temperature_k = 3000.0;
  EXPECT_THROW(Built(scenario), ConfigError);
}

/// The distance from a point to the polyline camera, guide, by sampling it.
double FromTheWay(const Eigen::Vector2d& p, const Pose2& X_DV) {
  double least_m = 1e9;
  for (int i = 0; i <= 1000; ++i) {
    const double s = 1e-3 * i;
    least_m = std::min(least_m, (p - s * Eigen::Vector2d(X_DV.x, X_DV.y)).norm());
  }
  return least_m;
}

TEST(RaposaModels, RunsShareThemUntilAKeyOfThemDiffers) {
  ModelStore<RaposaModels> store(LoadModels);
  const auto models = store.Get(ScenarioAt(1.0, 0.0));
  EXPECT_EQ(store.Get(ScenarioAt(1.5, 0.2, {}, {}, 2)), models);
  const auto heavier = store.Get(ScenarioAt(1.0, 0.0, {}, "robot: {mass_scale: 1.1}"));
  EXPECT_NE(heavier, models);
  EXPECT_GT(heavier->built.robot.mass_kg(), models->built.robot.mass_kg());
  EXPECT_EQ(store.Get(ScenarioAt(1.0, 0.0, {}, {}, 3)), models);
}

TEST(Clutter, StandsClearOfTheWay) {
  const Pose2 X_DV = FromDockingCoords({2.0, Radians(40.0), Radians(40.0)});
  int pieces = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const SceneryItem& piece : DrawClutter(20, X_DV, 4.0, seed)) {
      const Eigen::Vector2d p(piece.X_DO.x, piece.X_DO.y);
      EXPECT_GE(FromTheWay(p, X_DV), kClutterClear_m + RadiusOf(piece) - 1e-3);
      EXPECT_LE(p.norm(), 3.0);
      ++pieces;
    }
  }
  EXPECT_EQ(pieces, 400);
}

TEST(Clutter, PiecesFollowFromTheSeedAndNotFromTheirNumber) {
  const Pose2 X_DV = FromDockingCoords({2.0, 0.0, 0.0});
  const auto three = DrawClutter(3, X_DV, 4.0, 5), ten = DrawClutter(10, X_DV, 4.0, 5),
             other = DrawClutter(3, X_DV, 4.0, 6);
  std::set<SceneryItem::Colour> paints;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(three[i].X_DO.x, ten[i].X_DO.x);
    EXPECT_EQ(three[i].size_m, ten[i].size_m);
    EXPECT_NE(three[i].X_DO.x, other[i].X_DO.x);
  }
  for (const SceneryItem& piece : DrawClutter(60, X_DV, 4.0, 5)) paints.insert(piece.colour);
  EXPECT_EQ(paints.size(), 4u);
}

TEST(Clutter, FacesOfItsBodiesLookOutwardsAndEncloseTheirVolume) {
  const auto volume = [](const RenderMesh& mesh) {
    double sum = 0.0;
    for (const auto& t : mesh.triangles) {
      const auto v = [&](int i) {
        return mesh.vertices[t[static_cast<std::size_t>(i)]].cast<double>();
      };
      sum += v(0).dot(v(1).cross(v(2))) / 6.0;
    }
    return sum;
  };
  const Eigen::Vector3d box(0.2, 0.1, 0.3), round(0.2, 0.2, 0.3),
      ball = Eigen::Vector3d::Constant(0.2);
  const double frustum = kPi * 0.3 / 3.0 * (0.01 + 0.1 * 0.02 + 0.0004);
  EXPECT_NEAR(volume(SolidMesh(SceneryItem::Kind::kBox, box)), 0.006, 1e-6);
  EXPECT_NEAR(volume(SolidMesh(SceneryItem::Kind::kCone, round)) / frustum, 1.0, 0.02);
  EXPECT_NEAR(volume(SolidMesh(SceneryItem::Kind::kSphere, ball)) / (kPi * 0.008 / 6.0), 1.0, 0.05);
}

TEST(RaposaSpreads, EveryToleranceCanBeBuiltAtBothItsEndsAndIsNotTold) {
  const Scenario told = ScenarioAt(1.0, 0.3);
  const RaposaModels as_told = LoadModels(told);
  const std::string models = SourceFile("models/raposa/");
  int spreads = 0;
  for (const auto& [root, file] : {std::pair("robot", models + "raposa.yaml"),
                                   std::pair("pyramid", models + "pyramid/pyramid.yaml"),
                                   std::pair("soil", models + "grounds/hard_floor.yaml"),
                                   std::pair("soil", models + "grounds/grass.yaml"),
                                   std::pair("soil", models + "grounds/sand.yaml")}) {
    for (const NumberSpread& spread : ReadSpreads(LoadModelYaml(file))) {
      if (!spread.tolerance) continue;
      ++spreads;
      for (const double end : {spread.tolerance->low, spread.tolerance->high}) {
        std::string nested = (spread.tolerance->of == Limits::Of::kTimes ? "{times: " : "{plus: ") +
                             NumberText(end) + "}";
        std::string key = std::string(root) + "." + spread.key.name;
        while (!key.empty()) {
          const std::size_t dot = key.rfind('.');
          nested = "{" + key.substr(dot == std::string::npos ? 0 : dot + 1) + ": " + nested + "}";
          key = dot == std::string::npos ? "" : key.substr(0, dot);
        }
        Scenario scenario = told;
        if (std::string(root) == "soil") scenario.soil_file = file;
        scenario.as_built = ParseYaml(nested, "test");
        RaposaModels built;
        ASSERT_NO_THROW(built = LoadModels(scenario)) << nested;
        EXPECT_NO_THROW(BuildRun(scenario, built)) << nested;
        EXPECT_EQ(built.nominal.robot.camera.X_RC.p, as_told.nominal.robot.camera.X_RC.p);
      }
    }
  }
  EXPECT_GT(spreads, 50);
}

TEST(RaposaSpreads, FirmGroundsHaveTheSameTolerancesForOneWordToDrawThem) {
  const std::string grounds = SourceFile("models/raposa/grounds/");
  const auto floor = ReadSpreads(LoadModelYaml(grounds + "hard_floor.yaml"));
  const auto grass = ReadSpreads(LoadModelYaml(grounds + "grass.yaml"));
  ASSERT_EQ(floor.size(), grass.size());
  for (std::size_t i = 0; i < floor.size(); ++i) {
    EXPECT_EQ(floor[i].key.name, grass[i].key.name);
    EXPECT_EQ(floor[i].tolerance, grass[i].tolerance);
  }
}

TEST(RaposaSpreads, ACameraTurnedInItsMountSeesTheGuideAside) {
  Scenario scenario = ScenarioAt(1.0, 0.0);
  scenario.as_built = ParseYaml("{robot: {camera: {mounting: {yaw_deg: 1, z_m: 0.002}}}}", "test");
  const RaposaModels models = LoadModels(scenario);
  const Pose3 &told = models.nominal.robot.camera.X_RC, &built = models.built.robot.camera.X_RC;
  EXPECT_NEAR(std::acos(told.R.col(2).dot(built.R.col(2))), Radians(1.0), 1e-9);
  EXPECT_NEAR(built.p.z() - told.p.z(), 0.002, 1e-12);
  const BuiltRun run = BuildRun(scenario, models);
  EXPECT_EQ(run.nominal.X_RC.p, told.p);
}

TEST(RaposaGround, StrengthDiffersFromPlaceToPlaceByTheSeed) {
  // A turn in place slides the belts: patches that are not alike move its middle.
  const auto middle = [](double scatter, std::uint64_t seed) {
    Scenario scenario =
        ScenarioAt(1.0, 0.0, {}, "soil: {patch_scatter: " + NumberText(scatter) + "}", seed);
    BuiltRun run = Built(scenario);
    run.world.robot.belts.speed_offset = 0.0;
    World world(run.world);
    MotorCommands commands = Belts(run.world, -0.1, 0.1);
    Play(world, run.world, commands, 2.0);
    return Eigen::Vector2d(world.truth().X_WR.p.head<2>());
  };
  EXPECT_EQ(middle(0.0, 1), middle(0.0, 2));
  EXPECT_GT((middle(0.2, 1) - middle(0.2, 2)).norm(), 1e-4);
}

}  // namespace
}  // namespace dockyard::raposa
