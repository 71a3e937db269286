#include "sim/vehicles/rounded_rock.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/base/random.h"
#include "sim/rigid/convex_body.h"
#include "sim/vehicles/rock_roughness.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// Triangles of a rock of 0.6 m are 9 mm wide, as boulder.cc has them.
constexpr int kLevel = 5;
// Zingg's ratio of width to length, and of the height over the middle to half the mean of both.
// Assumed, 0.6-0.9 (as loose_stone.cc) and 0.6-1.
constexpr double kNarrowest = 0.6, kWidest = 0.9, kFlattest = 0.6, kSteepest = 1.0;
// Faces about the sides and about the summit, and how far their normals are over the horizontal.
// Assumed, 5-9 and 3-5 faces, 0-40 and 45-75 deg.
constexpr int kSides = 7, kTops = 4;
constexpr double kSideLow_rad = 0.0, kSideHigh_rad = 0.6, kTopLow_rad = 0.85, kTopHigh_rad = 1.25;
// A face may be nearer to the middle by this share. Assumed, 0-0.3.
constexpr double kUneven = 0.2;
// Of the norm that rounds the edges: larger is sharper. Rocks of 0.6 m have summits with a radius
// of 8-40 cm in the median (rounded_rock_test.cc). Assumed, 5-16.
constexpr double kLeastNorm = 5.0, kMostNorm = 14.0;
// Hollows: as deep as this share of the radius, as wide as this angle. Assumed, 0-5, 0-12 %,
// 10-35 deg.
constexpr int kHollows = 3;
constexpr double kDeepest = 0.1, kNarrow_rad = 0.2, kWide_rad = 0.5;

struct Hollow {
  Vector3d direction{0, 0, 1};
  double share = 0.0, width_rad = 0.3;
};

Vector3d NormalOf(double up_rad, double turn_rad) {
  return {std::cos(up_rad) * std::cos(turn_rad), std::cos(up_rad) * std::sin(turn_rad),
          std::sin(up_rad)};
}

/// About the origin, for a rock whose half axes are 1.
std::vector<HalfSpace> DrawFaces(RandomStream& random) {
  std::vector<HalfSpace> faces{{-Vector3d::UnitZ(), 1.0}};
  const auto ring = [&](int count, double low_rad, double high_rad) {
    for (int i = 0; i < count; ++i) {
      const double turn_rad = 2.0 * kPi * (i + 0.8 * random.Uniform()) / count;
      faces.push_back({NormalOf(random.Uniform(low_rad, high_rad), turn_rad),
                       1.0 - kUneven * random.Uniform()});
    }
  };
  ring(kSides, kSideLow_rad, kSideHigh_rad);
  ring(kTops, kTopLow_rad, kTopHigh_rad);
  return faces;
}

std::vector<Hollow> DrawHollows(RandomStream& random) {
  std::vector<Hollow> hollows;
  for (int i = 0; i < kHollows; ++i) {
    const double up_rad = random.Uniform(-0.2, 1.0), turn_rad = random.Uniform(-kPi, kPi);
    hollows.push_back({NormalOf(up_rad, turn_rad), kDeepest * random.Uniform(),
                       random.Uniform(kNarrow_rad, kWide_rad)});
  }
  return hollows;
}

/// Moved so that the vertex that is farthest along the normal lies over the origin, that high.
StarBody WithTargetAt(StarBody rock, const Vector3d& normal, double up_m) {
  const Vector3d target = *std::ranges::max_element(
      rock.vertices, {}, [&](const Vector3d& p) { return normal.dot(p); });
  const Vector3d shift = Vector3d(0.0, 0.0, up_m) - target;
  rock.centre += shift;
  for (Vector3d& vertex : rock.vertices) vertex += shift;
  return rock;
}

}  // namespace

StarBody MakeRoundedRock(const RoundedRockShape& shape, std::uint64_t key) {
  RandomStream random(key);
  const double narrow = random.Uniform(kNarrowest, kWidest);
  const double half_length_m = shape.width_m / (1.0 + narrow);  // the mean of both is the width
  // Low targets are those of rocks that are buried deeper; high ones of rocks that are higher.
  const double own_up_m = 0.5 * shape.width_m * random.Uniform(kFlattest, kSteepest);
  const Vector3d half_m(half_length_m, narrow * half_length_m,
                        std::max(own_up_m, 0.6 * shape.target_up_m));
  const double turn_rad = random.Uniform(-kPi, kPi);
  const double norm = random.Uniform(kLeastNorm, kMostNorm);
  const std::vector<HalfSpace> faces = DrawFaces(random);
  const std::vector<Hollow> hollows = DrawHollows(random);
  const RockRoughness roughness(shape.roughness_m, random);
  StarBody rock = MakeStarBody({0.0, 0.0, 0.0}, kLevel, [&](const Vector3d& direction) {
    const Vector3d scaled = (RotZ(-turn_rad) * direction).cwiseQuotient(half_m);
    double sum = 0.0;
    for (const HalfSpace& face : faces) {
      sum += std::pow(std::max(0.0, face.normal.dot(scaled) / face.offset_m), norm);
    }
    double radius_m = 1.0 / std::pow(sum, 1.0 / norm);
    for (const Hollow& hollow : hollows) {
      const double away = std::acos(std::clamp(hollow.direction.dot(direction), -1.0, 1.0));
      radius_m *= 1.0 - hollow.share * std::exp(-std::pow(away / hollow.width_rad, 2));
    }
    return radius_m + roughness.At(radius_m * direction);
  });
  return WithTargetAt(std::move(rock), NormalOf(shape.face_up_rad, shape.face_turn_rad),
                      shape.target_up_m);
}

}  // namespace dockyard
