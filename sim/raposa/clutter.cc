#include "sim/raposa/clutter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "models/read/mesh_loader.h"
#include "sim/base/random.h"
#include "sim/raposa/mark_meshes.h"

namespace dockyard::raposa {
namespace {

constexpr double kReach_m = 3.0;       // of the middles from the pyramid; assumed, 2-6
constexpr double kBodyBehind_m = 0.6;  // of the robot, behind its camera as it looks
constexpr double kOnAxis_m = 0.8;      // the way along the pyramid's axis
constexpr double kGrey = 0.3;          // assumed, 0.1-0.6
constexpr int kTries = 200;

double DistanceTo(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d way = b - a;
  const double share = std::clamp((p - a).dot(way) / std::max(1e-12, way.squaredNorm()), 0.0, 1.0);
  return (p - a - share * way).norm();
}

/// Sizes are those of bricks and cartons, traffic cones and balls; all assumed.
ClutterPiece DrawPiece(RandomStream& random) {
  ClutterPiece piece;
  piece.shape = static_cast<ClutterShape>(std::min(2, static_cast<int>(3.0 * random.Uniform())));
  piece.paint = static_cast<ClutterPaint>(
      std::min(kClutterPaints - 1, static_cast<int>(kClutterPaints * random.Uniform())));
  const double a = random.Uniform(), b = random.Uniform(), c = random.Uniform();
  switch (piece.shape) {
    case ClutterShape::kBox:
      piece.size_m = {0.06 + 0.24 * a, 0.06 + 0.24 * b, 0.05 + 0.35 * c};
      break;
    case ClutterShape::kCone:
      piece.size_m = {0.10 + 0.20 * a, 0.10 + 0.20 * a, 0.15 + 0.35 * b};
      break;
    case ClutterShape::kBall:
      piece.size_m = Eigen::Vector3d::Constant(0.05 + 0.20 * a);
      break;
  }
  return piece;
}

RenderMesh Converted(const TriangleMesh& from, double up_m) {
  RenderMesh mesh;
  for (const Eigen::Vector3d& v : from.vertices) {
    mesh.vertices.push_back((v + up_m * Eigen::Vector3d::UnitZ()).cast<float>());
  }
  mesh.triangles = from.triangles;
  return mesh;
}

}  // namespace

double ClutterPiece::radius_m() const {
  return shape == ClutterShape::kBox ? 0.5 * size_m.head<2>().norm() : 0.5 * size_m.x();
}

std::vector<ClutterPiece> DrawClutter(int count, const Pose2& X_DV, double behind_m,
                                      const Seed& seed) {
  const Eigen::Vector2d camera(X_DV.x, X_DV.y), pyramid(0.0, 0.0), out(kOnAxis_m, 0.0);
  const Eigen::Vector2d view(std::cos(X_DV.heading), std::sin(X_DV.heading));
  const Eigen::Vector2d tail = camera - kBodyBehind_m * view;
  const std::array<std::array<Eigen::Vector2d, 2>, 4> ways{
      {{tail, camera}, {camera, pyramid}, {camera, out}, {pyramid, out}}};
  std::vector<ClutterPiece> pieces;
  for (int i = 0; i < count; ++i) {
    RandomStream random(WorldSeed(StreamKey(seed, "clutter"), static_cast<std::uint64_t>(i), 0));
    ClutterPiece piece = DrawPiece(random);
    for (int tried = 0; tried < kTries; ++tried) {
      const double r_m = kReach_m * std::sqrt(random.Uniform());
      const double angle = random.Uniform(-kPi, kPi), turn = random.Uniform(-kPi, kPi);
      const Eigen::Vector2d p(r_m * std::cos(angle), r_m * std::sin(angle));
      const double clear_m = kClutterClear_m + piece.radius_m();
      const bool free = std::ranges::all_of(
          ways, [&](const auto& way) { return DistanceTo(p, way[0], way[1]) >= clear_m; });
      if (!free || p.x() < piece.radius_m() - behind_m) continue;
      piece.X_DO = {p.x(), p.y(), turn};
      pieces.push_back(piece);
      break;
    }
  }
  return pieces;
}

RenderMesh ClutterMesh(const ClutterPiece& piece) {
  const double up_m = 0.5 * piece.size_m.z(), radius_m = 0.5 * piece.size_m.x();
  switch (piece.shape) {
    case ClutterShape::kCone:
      return TurnedMesh({{0.0, radius_m}, {piece.size_m.z(), 0.2 * radius_m}}, Pose3{});
    case ClutterShape::kBall:
      return Converted(SphereMesh(radius_m), up_m);
    case ClutterShape::kBox:
      break;
  }
  return Converted(BoxMesh(piece.size_m), up_m);
}

Spectrum ReflectanceOf(ClutterPaint paint) {
  switch (paint) {
    case ClutterPaint::kBrick:
      return Brick();
    case ClutterPaint::kDenim:
      return Denim();
    case ClutterPaint::kConeOrange:
      return ConeOrange();
    case ClutterPaint::kGrey:
      break;
  }
  return EvenGrey(kGrey);
}

}  // namespace dockyard::raposa
