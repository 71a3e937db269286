#include "sim/plant/scenery.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "models/read/mesh_loader.h"
#include "sim/plant/drawn_mesh.h"
#include "sim/plant/placement.h"
#include "sim/plant/surroundings.h"

namespace dockyard {
namespace {

using Kind = SceneryItem::Kind;
using Colour = SceneryItem::Colour;

constexpr int kFacets = 32;
// Assumed, 0.1-0.6, 0.7-0.9 and 0.03-0.1.
constexpr double kGrey = 0.3, kWhite = 0.8, kBlack = 0.05;
constexpr double kTopOfCone = 0.2;  // its radius, of that of the foot; assumed, 0.1-0.3

RenderMesh Lifted(const TriangleMesh& from, double up_m) {
  RenderMesh mesh;
  for (const Eigen::Vector3d& v : from.vertices) {
    mesh.vertices.push_back((v + up_m * Eigen::Vector3d::UnitZ()).cast<float>());
  }
  mesh.triangles = from.triangles;
  return mesh;
}

std::shared_ptr<const RenderMesh> MeshOf(const SceneryItem& item) {
  if (item.kind != Kind::kMesh) {
    return std::make_shared<const RenderMesh>(SolidMesh(item.kind, item.size_m));
  }
  return DrawnMesh(Scaled(*LoadMesh(item.file), Eigen::Vector3d::Constant(item.scale)));
}

}  // namespace

RenderMesh TurnedMesh(const std::vector<Eigen::Vector2d>& profile_m, const Pose3& X_OA) {
  RenderMesh mesh;
  const auto add = [&](double z, double x, double y) {
    mesh.vertices.push_back((X_OA * Eigen::Vector3d(x, y, z)).cast<float>());
  };
  for (const Eigen::Vector2d& at : profile_m) {
    for (int k = 0; k < kFacets; ++k) {
      const double angle = 2.0 * kPi * k / kFacets;
      add(at.x(), at.y() * std::cos(angle), at.y() * std::sin(angle));
    }
  }
  const auto index = [](std::size_t ring, int k) {
    return static_cast<std::uint32_t>(ring * kFacets + static_cast<std::size_t>(k % kFacets));
  };
  for (std::size_t ring = 0; ring + 1 < profile_m.size(); ++ring) {
    for (int k = 0; k < kFacets; ++k) {
      mesh.triangles.push_back({index(ring, k), index(ring, k + 1), index(ring + 1, k + 1)});
      mesh.triangles.push_back({index(ring, k), index(ring + 1, k + 1), index(ring + 1, k)});
    }
  }
  const auto low = static_cast<std::uint32_t>(mesh.vertices.size());
  add(profile_m.front().x(), 0.0, 0.0);
  add(profile_m.back().x(), 0.0, 0.0);
  for (int k = 0; k < kFacets; ++k) {
    mesh.triangles.push_back({low, index(0, k + 1), index(0, k)});
    mesh.triangles.push_back(
        {low + 1, index(profile_m.size() - 1, k), index(profile_m.size() - 1, k + 1)});
  }
  return mesh;
}

RenderMesh SolidMesh(Kind kind, const Eigen::Vector3d& size_m) {
  const double height_m = size_m.z(), radius_m = 0.5 * size_m.x();
  switch (kind) {
    case Kind::kCylinder:
      return TurnedMesh({{0.0, radius_m}, {height_m, radius_m}}, Pose3{});
    case Kind::kCone:  // as traffic's: blunt
      return TurnedMesh({{0.0, radius_m}, {height_m, kTopOfCone * radius_m}}, Pose3{});
    case Kind::kSphere:
      return Lifted(SphereMesh(radius_m), 0.5 * height_m);
    default:
      return Lifted(BoxMesh(size_m), 0.5 * height_m);
  }
}

Spectrum ReflectanceOf(Colour colour) {
  switch (colour) {
    case Colour::kGrey:
      break;
    case Colour::kWhite:
      return EvenGrey(kWhite);
    case Colour::kBlack:
      return EvenGrey(kBlack);
    case Colour::kBrick:
      return Brick();
    case Colour::kDenim:
      return Denim();
    case Colour::kConeOrange:
      return ConeOrange();
    case Colour::kOrange:
      return OrangePaint();
    case Colour::kBlue:
      return BluePaint();
    case Colour::kGrass:
      return Grass();
    case Colour::kSoil:
      return Soil();
    case Colour::kFloor:
      return FloorCovering();
  }
  return EvenGrey(kGrey);
}

std::vector<SceneryItem> DrawSet(const SceneryItem& set, const Eigen::Vector2d& start_D,
                                 std::uint64_t stream) {
  const Eigen::Vector2d middle(set.X_DO.x, set.X_DO.y);
  std::vector<SceneryItem> solids;
  for (int i = 0; i < set.count; ++i) {
    RandomStream random(WorldSeed(stream, static_cast<std::uint64_t>(i), 0));
    SceneryItem solid;
    const auto pick = [&](std::size_t count) {
      return std::min(count - 1,
                      static_cast<std::size_t>(static_cast<double>(count) * random.Uniform()));
    };
    solid.kind = std::array{Kind::kBox, Kind::kCone, Kind::kSphere}[pick(3)];
    solid.colour = set.colours[pick(set.colours.size())];
    for (double& side_m : solid.size_m) side_m = random.Uniform(set.least_m, set.largest_m);
    if (solid.kind != Kind::kBox) solid.size_m.y() = solid.size_m.x();
    if (solid.kind == Kind::kSphere) solid.size_m.z() = solid.size_m.x();
    const double clear_m = set.clear_m + RadiusOf(solid);
    const auto is_free = [&](const Eigen::Vector2d& p) {
      return DistanceTo(middle + p, {0.0, 0.0}, start_D) >= clear_m;
    };
    if (!PlaceInDisc(random, set.radius_m, is_free, solid)) continue;
    solid.X_DO.x += middle.x();
    solid.X_DO.y += middle.y();
    solids.push_back(solid);
  }
  return solids;
}

namespace {

std::vector<SceneryItem> Drawn(const SceneryItem& item, const Eigen::Vector2d& start_D,
                               std::uint64_t stream) {
  if (item.kind == Kind::kSet) return DrawSet(item, start_D, stream);
  if (item.kind == Kind::kRoom) return DrawRoom(item, start_D, stream);
  if (item.kind == Kind::kOutdoors) return DrawOutdoors(item, start_D, stream);
  return {item};
}

}  // namespace

void AddItems(const std::vector<SceneryItem>& items, const HeightGrid& ground, const Pose3& X_WG,
              const Pose2& X_GD, Lighting& lighting) {
  const Spectrum day = DaylightLight(6500.0);
  const CameraResponse camera = CheapCamera();
  for (const SceneryItem& item : items) {
    const Pose2 X_GO = X_GD * item.X_DO;
    Pose3 X_WO = X_WG * FromGround(X_GO, ground.Height(X_GO.x, X_GO.y) + item.up_m);
    if (item.pitch_rad != 0.0 || item.roll_rad != 0.0) {
      X_WO.R = X_WO.R * RotY(item.pitch_rad) * RotX(item.roll_rad);
    }
    const Spectrum reflectance = ReflectanceOf(item.colour);
    lighting.scenery.push_back(
        {.object = {.mesh = MeshOf(item),
                    .X_WO = X_WO,
                    .albedo =
                        ColourOf(day, reflectance, camera).cwiseProduct(BalanceFor(day, camera))},
         .reflectance = reflectance});
  }
}

void AddScenery(const Scenario& scenario, const HeightGrid& ground, const Pose3& X_WG,
                const Pose2& X_GD, Lighting& lighting) {
  const Pose2 start_D = scenario.start.pose();
  std::vector<SceneryItem> items;
  for (std::size_t i = 0; i < scenario.scenery.size(); ++i) {
    const std::uint64_t stream = WorldSeed(StreamKey(scenario.seed, "scenery"), i, 0);
    for (SceneryItem& solid : Drawn(scenario.scenery[i], {start_D.x, start_D.y}, stream)) {
      items.push_back(solid);
    }
  }
  AddItems(items, ground, X_WG, X_GD, lighting);
}

}  // namespace dockyard
