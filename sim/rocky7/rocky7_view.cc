#include "sim/rocky7/rocky7_view.h"

#include <algorithm>

#include "controller/base/split_mix.h"
#include "sim/base/random.h"
#include "sim/plant/drawn_mesh.h"
#include "sim/plant/ground_view.h"
#include "sim/plant/sun_motion.h"
#include "sim/run/shade_body.h"
#include "sim/vehicles/loose_stone.h"

namespace dockyard::rocky7 {
namespace {

// A boulder's stains are larger than a stone's: they are told apart from 7 m. Assumed, 40-150 mm.
constexpr double kBoulderStain_m = 0.08;
// Larger pebbles have a height that a stereo pair would see, so they are not painted.
constexpr double kLargestPebble_m = 0.005;
// About the target the shadows are finest [m].
constexpr double kInterest_m = 0.3;

// Three corners to each triangle, so that no faces share a normal.
RenderMesh Faceted(const std::vector<Eigen::Vector3d>& vertices,
                   const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  RenderMesh mesh;
  for (const auto& triangle : triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const std::uint32_t i : triangle) mesh.vertices.push_back(vertices[i].cast<float>());
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  return mesh;
}

Eigen::Vector3d MiddleOf(const RenderMesh& mesh) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& vertex : mesh.vertices) sum += vertex.cast<double>();
  return sum / std::max<double>(1.0, static_cast<double>(mesh.vertices.size()));
}

}  // namespace

std::string LooseStoneName(std::size_t number) {
  return "loose_stone_" + std::to_string(number + 1);
}

SceneBuilder::SceneBuilder(const BuiltRun& built, const WheeledBody& rover, const Seed& run_seed)
    : lighting_(built.lighting),
      X_WG_(SiteInWorld(built.world.X_WG, built.world.slope)),
      soil_rgb_(built.world.soil.rgb),
      stone_rgb_(built.keys.stone_albedo * built.world.soil.rgb),
      stains_(built.keys.stone_stains),
      target_G_(built.world.target_G),
      texture_seed_(StreamKey(run_seed, "texture")) {
  for (const LinkLook& look : LooksOf(built.world.robot.rover, rover)) {
    Link link{look.name, DrawnParts(look.visuals)};
    if (link.name == "instrument") {
      instrument_link_ = links_.size();
      instrument_m_ = built.world.robot.rover.mast->link2_m;
    }
    links_.push_back(std::move(link));
  }
  for (const ConvexBody& stone : built.world.stones) {
    stones_.push_back(std::make_shared<const RenderMesh>(Faceted(stone.vertices, stone.triangles)));
  }
  for (const ConvexBody& stone_G : built.world.loose_stones) {
    const ConvexBody shape = MakeLooseStone(stone_G, kStoneDensity_kg_m3).shape_S;
    loose_.push_back(std::make_shared<const RenderMesh>(Faceted(shape.vertices, shape.triangles)));
  }
  for (const ConvexBody& pebble : built.gravel) {
    const Eigen::Vector2d p_G = pebble.centre.head<2>();
    gravel_.push_back(
        {std::make_shared<const RenderMesh>(Faceted(pebble.vertices, pebble.triangles)), p_G,
         built.world.ground.Height(p_G.x(), p_G.y())});
  }
  if (built.world.loose_target) {
    const ConvexBody& target = *built.world.loose_target;
    loose_target_ = std::make_shared<const RenderMesh>(Faceted(target.vertices, target.triangles));
  }
  if (built.world.boulder) {
    const StarBody& boulder = *built.world.boulder;
    boulder_ = std::make_shared<const RenderMesh>(Faceted(boulder.vertices, boulder.triangles()));
  }
}

Scene SceneBuilder::Make(const Truth& truth, const HeightGrid& ground) const {
  Scene scene;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    AddParts(links_[i].parts, truth.X_WL.at(i), scene.objects);
  }
  AddStones(truth, ground, scene);
  if (loose_target_) {
    scene.objects.push_back({.mesh = loose_target_,
                             .X_WO = X_WG_ * truth.X_GT,
                             .albedo = stone_rgb_,
                             .stains = StainsOf(texture_seed_)});
  }
  if (boulder_) {
    scene.objects.push_back(
        {.mesh = boulder_,
         .X_WO = X_WG_,
         .albedo = stone_rgb_,
         .stains = {.contrast = stains_, .seed = texture_seed_, .largest_m = kBoulderStain_m}});
  }
  AddSurroundings(lighting_, scene.objects);
  scene.ground = ViewOf(ground, X_WG_, soil_rgb_, texture_seed_);
  scene.ground.largest_pebble_m = kLargestPebble_m;
  scene.light = LightAt(lighting_, truth.time_s);
  scene.interest = Interest{X_WG_ * truth.X_GT.p, kInterest_m};
  return scene;
}

void SceneBuilder::AddStones(const Truth& truth, const HeightGrid& ground, Scene& scene) const {
  std::uint64_t number = 0;  // of all stones, the fixed ones first
  const auto add = [&](const std::shared_ptr<const RenderMesh>& mesh, const Pose3& X_GO) {
    scene.objects.push_back({.mesh = mesh,
                             .X_WO = X_WG_ * X_GO,
                             .albedo = stone_rgb_,
                             .stains = StainsOf(SplitMix(texture_seed_, number++))});
  };
  for (std::size_t i = 0; i < stones_.size(); ++i) {
    add(stones_[i], Pose3::Translation(0.0, 0.0, -truth.sunk_m.at(i)));
  }
  for (std::size_t i = 0; i < loose_.size(); ++i) add(loose_[i], truth.X_GS.at(i));
  for (const Pebble& pebble : gravel_) {
    const double up_m = ground.Height(pebble.p_G.x(), pebble.p_G.y()) - pebble.ground_m;
    add(pebble.mesh, Pose3::Translation(0.0, 0.0, up_m));
  }
}

std::vector<StagePoint> SceneBuilder::Points() const {
  std::vector<StagePoint> points;
  if (loose_target_) {
    points.push_back({"target", "target"});
  } else if (boulder_) {
    points.push_back({"target", "target", target_G_});
  } else if (!stones_.empty()) {
    points.push_back({"target", "target", MiddleOf(*stones_.front())});
  }
  for (const Link& link : links_) {
    if (link.name == "front_scoop") points.push_back({"gripper", link.name});
  }
  if (instrument_link_) {
    points.push_back({"tip", links_[*instrument_link_].name, {instrument_m_, 0.0, 0.0}});
  }
  return points;
}

void SceneBuilder::AddStones(StageShapes& shapes) const {
  std::uint64_t number = 0;
  const auto part = [&](const std::shared_ptr<const RenderMesh>& mesh) {
    return StagePart{mesh, Pose3{}, stone_rgb_, StainsOf(SplitMix(texture_seed_, number++))};
  };
  for (std::size_t i = 0; i < stones_.size(); ++i) {
    const std::string name = i == 0 && !loose_target_ && !boulder_ ? "target" : "stones";
    if (shapes.bodies.back().name != name) shapes.bodies.push_back({name, false, {}});
    shapes.bodies.back().about = name == "stones";
    shapes.bodies.back().parts.push_back(part(stones_[i]));
  }
  for (std::size_t i = 0; i < loose_.size(); ++i) {
    shapes.bodies.push_back({LooseStoneName(i), false, {part(loose_[i])}, true});
  }
  if (gravel_.empty()) return;
  shapes.bodies.push_back({"gravel", false, {}, true});
  for (const Pebble& pebble : gravel_) shapes.bodies.back().parts.push_back(part(pebble.mesh));
}

StageShapes SceneBuilder::Shapes() const {
  StageShapes shapes;
  for (const Link& link : links_) {
    shapes.bodies.push_back({link.name, true, {}});
    AddParts(link.parts, Pose3{}, shapes.bodies.back());
  }
  if (loose_target_) {
    shapes.bodies.push_back(
        {"target", false, {{loose_target_, Pose3{}, stone_rgb_, StainsOf(texture_seed_)}}});
  }
  if (boulder_) {
    Stains stains = StainsOf(texture_seed_);
    stains.largest_m = kBoulderStain_m;
    shapes.bodies.push_back({"target", false, {{boulder_, Pose3{}, stone_rgb_, stains}}});
  }
  AddStones(shapes);
  for (StageBody& body : SurroundingBodies(lighting_)) shapes.bodies.push_back(std::move(body));
  shapes.light = lighting_.sun_and_sky;
  shapes.to_pole_W = lighting_.to_pole_W;
  shapes.ground_rgb = soil_rgb_;
  shapes.ground_texture_seed = texture_seed_;
  shapes.largest_pebble_m = kLargestPebble_m;
  shapes.points = Points();
  return shapes;
}

}  // namespace dockyard::rocky7
