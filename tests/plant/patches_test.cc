// Soils by place: which soil lies where, and that contacts there have its forces to the bit.
#include <gmock/gmock.h>

#include <cmath>

#include "models/read/load_soil.h"
#include "sim/plant/yard.h"
#include "sim/scenario/patch_keys.h"
#include "sim/soil/wheel_soil.h"
#include "sim/vehicles/belt.h"
#include "support/bad_files.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string SoilFile(const std::string& name) {
  return SourceFile("models/soils/" + name + ".yaml");
}

YardModel YardOf(const std::string& patches, const std::string& file = "yard.yaml") {
  YardModel yard{.length_m = 8.0, .width_m = 8.0, .cell_m = 0.05, .undulation_rms_m = 0.0};
  yard.given_patches = *ParseYaml("patches: " + patches, file).Find("patches");
  ReadPatches(yard);
  return yard;
}

TEST(Patches, LieWhereTheirShapesSay) {
  const std::string sand = SoilFile("loose_sand"), gravel = SoilFile("compact_gravel");
  const YardModel yard =
      YardOf("[{soil: " + sand + ", disc: {x_m: 2, y_m: 1, radius_m: 0.8}}, {soil: " + gravel +
             ", rectangle: {x_m: 4, y_m: -1, length_m: 2, width_m: 1, "
             "turn_deg: 30}}, {soil: " +
             sand + ", polygon: [[-1, -3], [3, -3], [3, -2], [0, -2], [0, 0], [-1, 0]]}]");
  EXPECT_THAT(PatchSoilFiles(yard), ElementsAre(sand, gravel));
  const HeightGrid ground = YardGround(yard, 0.5, Seed{});
  int counts[3] = {0, 0, 0};
  for (double x = -1.4; x < 6.4; x += 0.1) {
    for (double y = -3.9; y < 3.9; y += 0.1) {
      // Within half a cell of a border either may be right.
      const Eigen::Vector2d in_turned =
          Eigen::Rotation2Dd(-kPi / 6) * Eigen::Vector2d(x - 4, y + 1);
      const double disc = 0.8 - std::hypot(x - 2, y - 1);
      const double turned = std::min(1.0 - std::abs(in_turned.x()), 0.5 - std::abs(in_turned.y()));
      const auto box = [&](double x0, double x1, double y0, double y1) {
        return std::min(std::min(x - x0, x1 - x), std::min(y - y0, y1 - y));
      };
      const double angle = std::max(box(-1, 3, -3, -2), box(-1, 0, -3, 0));
      if (std::min({std::abs(disc), std::abs(turned), std::abs(angle)}) < 0.04) continue;
      const std::size_t wanted = angle > 0.0 ? 1 : turned > 0.0 ? 2 : disc > 0.0 ? 1 : 0;
      EXPECT_EQ(ground.SoilAt(x, y), wanted) << x << " " << y;
      ++counts[wanted];
    }
  }
  EXPECT_GT(counts[1], 300);
  EXPECT_GT(counts[2], 100);
}

TEST(Patches, WithoutThemAllGroundIsTheYards) {
  const HeightGrid ground = YardGround({}, 0.5, Seed{});
  EXPECT_TRUE(ground.soils.empty());
  EXPECT_EQ(ground.SoilAt(1.0, 2.0), 0u);
}

WheelModel Wheel() {
  return {.rim_radius_m = 0.1,
          .width_m = 0.1,
          .paddle_count = 12,
          .paddle_height_m = 0.02,
          .paddle_thickness_m = 0.003};
}

// Rolls at 5 % slip for a second from x = 0, 8 mm in the soil.
template <typename Visit>
void Roll(WheelSoil& soil, HeightGrid grid, const Visit& visit) {
  WheelMotion motion{};
  motion.v_GK_G = {0.3, 0.0, 0.0};
  motion.w_GK_G = {0.0, 0.3 / (0.12 * 0.95), 0.0};
  motion.X_GK.p = {0.0, 0.0, 0.112};
  for (int i = 0; i < 1000; ++i) {
    motion.X_GK.p.x() += 1e-3 * motion.v_GK_G.x();
    motion.X_GK.R = RotY(1e-3 * (i + 1) * motion.w_GK_G.y());
    visit(motion.X_GK.p.x(), soil.Step(grid, motion, 1e-3));
  }
}

TEST(Patches, WheelOnAPatchHasItsSoilsLoadsToTheBit) {
  const SoilModel sand = LoadSoil(SoilFile("loose_sand")),
                  gravel = LoadSoil(SoilFile("compact_gravel"));
  HeightGrid grid = LevelGrid(-1.0, 2.0, 1.0, 0.02);
  std::vector<double> on_sand, on_gravel;
  WheelSoil of_sand(Wheel(), sand), of_gravel(Wheel(), gravel);
  Roll(of_sand, grid, [&](double, const WheelLoad& load) { on_sand.push_back(load.force_G.z()); });
  Roll(of_gravel, grid,
       [&](double, const WheelLoad& load) { on_gravel.push_back(load.force_G.z()); });
  EXPECT_GT(on_gravel.back(), 1.5 * on_sand.back());
  grid.soils.assign(grid.heights_m.size(), 1);
  WheelSoil patched(Wheel(), sand);
  patched.AddSoil(gravel);
  std::size_t i = 0;
  Roll(patched, grid,
       [&](double, const WheelLoad& load) { ASSERT_EQ(load.force_G.z(), on_gravel[i++]); });
  // Gravel from x = 0.15 on: sand up to there, then the load grows to gravel's.
  for (int iy = 0; iy < grid.ny; ++iy) {
    for (int ix = 0; ix < grid.nx; ++ix) {
      const bool beyond = grid.x0_m + ix * grid.cell_m > 0.15;
      grid.soils[static_cast<std::size_t>(iy * grid.nx + ix)] = beyond ? 1 : 0;
    }
  }
  WheelSoil crossing(Wheel(), sand);
  crossing.AddSoil(gravel);
  i = 0;
  double last = 0.0;
  Roll(crossing, grid, [&](double x_m, const WheelLoad& load) {
    if (x_m < 0.14) {
      ASSERT_EQ(load.force_G.z(), on_sand[i]);
    }
    ++i;
    last = load.force_G.z();
  });
  EXPECT_GT(last, 1.2 * on_sand.back());
}

TEST(Patches, BeltOnAPatchHasItsGroundsLoadsToTheBit) {
  BeltModel model;
  model.front = {.x_m = 0.2, .radius_m = 0.05};
  model.rear = {.x_m = -0.2, .radius_m = 0.05};
  model.width_m = 0.1;
  model.pads = 40;
  model.sprocket_radius_m = 0.05;
  model.stiffness_pa_per_m = 2e6;
  model.damping_pa_s_per_m = 1e4;
  model.shear_stiffness_pa_per_m = 2e6;
  const BeltGround floor{.friction = 0.5, .rolling_loss = 0.02};
  const SoilModel sand = LoadSoil(SoilFile("loose_sand"));
  HeightGrid grid = LevelGrid(-1.0, 2.0, 1.0, 0.05);
  const auto run = [&](Belt belt) {
    LinkMotion carrier{};
    carrier.X_GL.p.z() = 0.045;
    carrier.v_GL_G.x() = 0.09;
    BeltLoad load;
    for (int i = 0; i < 500; ++i) {
      carrier.X_GL.p.x() += 1e-3 * carrier.v_GL_G.x();
      load = belt.Step(grid, carrier, 0.1, 1e-3);
    }
    return std::array{load.force_G.x(), load.force_G.z(), load.drive_torque_nm};
  };
  Belt patched(model, floor);
  patched.AddGround(Belt(model, sand, 0.05));
  const auto on_floor = run(Belt(model, floor)), on_sand = run(Belt(model, sand, 0.05));
  EXPECT_NE(on_floor, on_sand);
  grid.soils.assign(grid.heights_m.size(), 1);
  EXPECT_EQ(run(patched), on_sand);
  grid.soils.assign(grid.heights_m.size(), 0);
  EXPECT_EQ(run(patched), on_floor);
}

TEST(Patches, BadOnesAreRefusedWithTheirPlace) {
  const ScratchFolder folder;
  const std::string soil = "soil: " + SoilFile("loose_sand");
  const struct {
    std::string patch, message;
  } cases[] = {
      {"disc: {x_m: 0, y_m: 0, radius_m: 1}", "missing key 'soil'"},
      {soil, "yard.patches[0]: expected one of rectangle, disc and polygon"},
      {soil + ", disc: {x_m: 0, y_m: 0, radius_m: 1}, polygon: [[0, 0], [1, 0], [1, 1]]",
       "expected one of rectangle, disc and polygon"},
      {soil + ", disc: {x_m: 0, y_m: 0, radius_m: 0}", "yard.patches[0].disc.radius_m: expected"},
      {soil + ", disc: {x_m: 0, y_m: 0}", "radius_m"},
      {soil + ", polygon: [[0, 0], [1, 0]]", "yard.patches[0].polygon: expected"},
      {soil + ", polygon: [[0, 0], [1, 0, 2], [1, 1]]", "expected rows of equal length"},
      {"soil: nowhere.yaml, disc: {x_m: 0, y_m: 0, radius_m: 1}", "nowhere.yaml"},
  };
  for (const auto& each : cases) {
    EXPECT_THAT(MessageOf([&] { YardOf("[{" + each.patch + "}]"); }, folder),
                HasSubstr(each.message))
        << each.patch;
  }
}

}  // namespace
}  // namespace dockyard
