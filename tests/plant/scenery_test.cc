// Scenery: its places, its draws, and what a camera sees of it.
#include "sim/plant/scenery.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "render/measure.h"
#include "sim/plant/placement.h"
#include "sim/scenario/scenery_keys.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

Scenario ScenarioOf(const std::string& items) {
  Scenario scenario;
  scenario.given_scenery = *ParseYaml("scenery: " + items, "s.yaml").Find("scenery");
  ReadScenery(scenario);
  return scenario;
}

const SceneryItem kSet{.kind = SceneryItem::Kind::kSet,
                       .X_DO = {1.0, 0.5, 0.0},
                       .count = 60,
                       .radius_m = 4.0,
                       .least_m = 0.1,
                       .largest_m = 0.3,
                       .clear_m = 0.6,
                       .colours = {SceneryItem::Colour::kBlue, SceneryItem::Colour::kOrange}};

TEST(Scenery, SetIsDrawnWithinItsBoundsClearOfTheLineBetweenStartAndTarget) {
  const Eigen::Vector2d start_D(4.0, 1.0);
  std::set<SceneryItem::Kind> kinds;
  std::set<SceneryItem::Colour> colours;
  int drawn = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const SceneryItem& solid : DrawSet(kSet, start_D, seed)) {
      const Eigen::Vector2d p(solid.X_DO.x, solid.X_DO.y);
      EXPECT_LE((p - Eigen::Vector2d(1.0, 0.5)).norm(), 4.0);
      for (double s = 0.0; s <= 1.0; s += 0.001) {
        ASSERT_GE((p - s * start_D).norm(), 0.6 + RadiusOf(solid) - 1e-9);
      }
      EXPECT_GE(solid.size_m.minCoeff(), 0.1);
      EXPECT_LE(solid.size_m.maxCoeff(), 0.3);
      kinds.insert(solid.kind);
      colours.insert(solid.colour);
      ++drawn;
    }
  }
  EXPECT_EQ(drawn, 300);
  EXPECT_EQ(kinds.size(), 3u);
  EXPECT_EQ(colours, std::set(kSet.colours.begin(), kSet.colours.end()));
}

TEST(Scenery, SolidsFollowFromTheSeedAndNotFromTheirNumber) {
  SceneryItem few = kSet;
  few.count = 4;
  const auto all = DrawSet(kSet, {4, 1}, 7), some = DrawSet(few, {4, 1}, 7),
             other = DrawSet(few, {4, 1}, 8);
  for (std::size_t i = 0; i < some.size(); ++i) {
    EXPECT_EQ(some[i].X_DO, all[i].X_DO);
    EXPECT_EQ(some[i].size_m, all[i].size_m);
    EXPECT_NE(some[i].X_DO, other[i].X_DO);
  }
}

// A box of a dull grey on a bump: a camera before it sees its face by Lambert's law, at its place.
TEST(Scenery, SolidIsWhereItsKeysPutItOnTheGroundAndHasItsColour) {
  Scenario scenario = ScenarioOf(
      "[{kind: box, length_m: 0.4, width_m: 0.6, height_m: 0.5, x_m: 1, y_m: 2, up_m: 0.25, "
      "turn_deg: 90, colour: grey}]");
  HeightGrid ground = LevelGrid(-1.5, 6.0, 6.0, 0.5);
  for (double& height_m : ground.heights_m) height_m = 0.125;
  Lighting lighting;
  const Pose3 X_WG{RotZ(0.3), {5.0, -2.0, 0.0}};
  AddScenery(scenario, ground, X_WG, Pose2{}, lighting);
  ASSERT_EQ(lighting.scenery.size(), 1u);
  const SceneObject& box = lighting.scenery[0].object;
  EXPECT_LT((box.X_WO.p - X_WG * Eigen::Vector3d(1.0, 2.0, 0.375)).norm(), 1e-12);
  Scene scene;
  scene.light.to_sun_W = X_WG.R * Eigen::Vector3d(0.8, 0.0, 0.6);
  AddSurroundings(lighting, scene.objects);
  // Its sides along x face the world's +-y of the yard: from +x a face of 0.6 turned to 0.4 m.
  const Eigen::Vector3d face_G(1.3, 2.0, 0.625);
  Pose3 X_GC = Pose3::Translation(4.0, 2.0, 0.625);
  X_GC.R << 0, 0, -1, 1, 0, 0, 0, -1, 0;  // along -x, upright
  const Pose3 X_WC = X_WG * X_GC;
  const Camera camera = EquidistantCamera(320, 240, kPi / 4);
  const RadianceImage image = StereoRenderer().RenderRadiance(scene, RigAt(camera, X_WC), {})[0];
  const double face = UnshadedRadiance(scene.light, X_WG.R.col(0), 0.3);
  EXPECT_NEAR(image.at(160, 120), face, 0.01 * face);
  // Half its width, 0.2 m, to either side it ends.
  const auto column = [&](double y_m) {
    const auto pixel = camera.Project(Inverse(X_WC) * (X_WG * Eigen::Vector3d(1.3, y_m, 0.625)));
    return static_cast<int>(std::lround(pixel->x()));
  };
  EXPECT_NEAR(image.at(column(2.19), 120), face, 0.01 * face);
  EXPECT_NE(image.at(column(2.21), 120), image.at(160, 120));
}

TEST(Scenery, BadItemsAreRefusedWithTheirPlace) {
  const ScratchFolder folder;
  const std::string at = "x_m: 1, y_m: 1";
  const struct {
    std::string item, message;
  } cases[] = {
      {"kind: house, " + at, "scenery[0].kind: expected one of box, cylinder, cone, sphere, mesh"},
      {"kind: sphere, diameter_m: 1, contact: true, " + at,
       "scenery[0].contact: expected false, as nothing runs into scenery"},
      {"kind: sphere, diameter_m: 1, height_m: 2, " + at, "height_m"},
      {"kind: box, length_m: 1, width_m: 1, " + at, "missing key 'height_m'"},
      {"kind: sphere, diameter_m: 1, colour: pink, " + at,
       "scenery[0].colour: expected one of grey"},
      {"kind: set, count: 3, radius_m: 2, least_m: 2, largest_m: 1, " + at, "at most largest_m"},
      {"kind: set, count: 3, radius_m: 2, colours: [blue, pink], " + at, "expected one of grey"},
      {"kind: mesh, file: nothing.obj, " + at, "nothing.obj"},
      {"kind: room, length_m: 1, width_m: 5, " + at, "scenery[0].length_m: expected"},
      {"kind: room, length_m: 5, width_m: 5, radius_m: 3, " + at, "radius_m"},
      {"kind: outdoors, things: -1, " + at, "scenery[0].things: expected"},
  };
  for (const auto& each : cases) {
    EXPECT_THAT(MessageOf([&] { ScenarioOf("[{" + each.item + "}]"); }, folder),
                HasSubstr(each.message))
        << each.item;
  }
}

TEST(Scenery, MoreThingsThanCanBeDrawnAreRefusedAtTheItemThatIsTooMuch) {
  const ScratchFolder folder;
  const std::string set = "{kind: set, count: 500, radius_m: 9, x_m: 1, y_m: 1}";
  EXPECT_EQ(ScenarioOf("[" + set + ", " + set + ", " + set + "]").scenery.size(), 3u);
  EXPECT_THAT(
      MessageOf([&] { ScenarioOf("[" + set + ", " + set + ", " + set + ", " + set + "]"); },
                folder),
      HasSubstr(
          "scenery[3]: expected at most 1500 things in all, those of sets counted, found 2000"));
}

}  // namespace
}  // namespace dockyard
