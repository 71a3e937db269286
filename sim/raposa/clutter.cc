#include "sim/raposa/clutter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/base/random.h"
#include "sim/plant/placement.h"

namespace dockyard::raposa {
namespace {

constexpr double kReach_m = 3.0;       // of the middles from the pyramid; assumed, 2-6
constexpr double kBodyBehind_m = 0.6;  // of the robot, behind its camera as it looks
constexpr double kOnAxis_m = 0.8;      // the way along the pyramid's axis

/// Sizes are those of bricks and cartons, traffic cones and balls; all assumed.
SceneryItem DrawPiece(RandomStream& random) {
  using enum SceneryItem::Kind;
  using enum SceneryItem::Colour;
  SceneryItem piece;
  piece.kind = std::array{
      kBox, kCone,
      kSphere}[std::min<std::size_t>(2, static_cast<std::size_t>(3.0 * random.Uniform()))];
  piece.colour =
      std::array{kBrick, kDenim, kConeOrange,
                 kGrey}[std::min<std::size_t>(3, static_cast<std::size_t>(4.0 * random.Uniform()))];
  const double a = random.Uniform(), b = random.Uniform(), c = random.Uniform();
  if (piece.kind == kBox) {
    piece.size_m = {0.06 + 0.24 * a, 0.06 + 0.24 * b, 0.05 + 0.35 * c};
  } else if (piece.kind == kCone) {
    piece.size_m = {0.10 + 0.20 * a, 0.10 + 0.20 * a, 0.15 + 0.35 * b};
  } else {
    piece.size_m.setConstant(0.05 + 0.20 * a);
  }
  return piece;
}

}  // namespace

std::vector<SceneryItem> DrawClutter(int count, const Pose2& X_DV, double behind_m,
                                     const Seed& seed) {
  const Eigen::Vector2d camera(X_DV.x, X_DV.y), pyramid(0.0, 0.0), out(kOnAxis_m, 0.0);
  const Eigen::Vector2d view(std::cos(X_DV.heading), std::sin(X_DV.heading));
  const Eigen::Vector2d tail = camera - kBodyBehind_m * view;
  const std::array<std::array<Eigen::Vector2d, 2>, 4> ways{
      {{tail, camera}, {camera, pyramid}, {camera, out}, {pyramid, out}}};
  std::vector<SceneryItem> pieces;
  for (int i = 0; i < count; ++i) {
    RandomStream random(WorldSeed(StreamKey(seed, "clutter"), static_cast<std::uint64_t>(i), 0));
    SceneryItem piece = DrawPiece(random);
    const double radius_m = RadiusOf(piece), clear_m = kClutterClear_m + radius_m;
    const auto is_free = [&](const Eigen::Vector2d& p) {
      return p.x() >= radius_m - behind_m && std::ranges::all_of(ways, [&](const auto& way) {
               return DistanceTo(p, way[0], way[1]) >= clear_m;
             });
    };
    if (PlaceInDisc(random, kReach_m, is_free, piece)) pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace dockyard::raposa
