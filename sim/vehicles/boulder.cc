#include "sim/vehicles/boulder.h"

#include <algorithm>
#include <cmath>

#include "sim/base/random.h"
#include "sim/rigid/convex_body.h"
#include "sim/vehicles/rock_roughness.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// Triangles of a boulder of 0.6 m are 9 mm wide. One level more changes where a can touches by less
// than half a millimetre.
constexpr int kLevel = 5;
// About the face's middle; a can of 66 mm that is 2 cm off still stands on the face.
constexpr double kFace_m = 0.08;
// Other faces: so many about, their normals so far over the horizontal. Assumed, 5-9 and 0-40 deg.
constexpr int kSides = 7;
constexpr double kSteepest_rad = 0.1, kFlattest_rad = 0.6;
// How far a side may be nearer to the middle than half the width, as a share of it. Assumed, 0-0.3.
constexpr double kUneven = 0.2;
// Behind the face's upper edge the boulder falls, or goes on level. Assumed, 5-40 deg off level.
constexpr double kBehind_rad = 1.4;
// Below the face a steep foot, so that wheels can come near. Assumed, 2-5 cm beyond the disc.
constexpr double kFoot_m = 0.03, kFootUp_rad = 0.1;
// Of the boulder below ground. Assumed, 5-30 cm.
constexpr double kBuried_m = 0.15;

Vector3d NormalOf(double up_rad, double turn_rad) {
  return {std::cos(up_rad) * std::cos(turn_rad), std::cos(up_rad) * std::sin(turn_rad),
          std::sin(up_rad)};
}

// The side, moved out until it leaves the face's disc alone.
HalfSpace ClearOfFace(HalfSpace side, const HalfSpace& face, const Vector3d& middle) {
  const double across = side.normal.dot(face.normal);
  const double reach_m = kFace_m * std::sqrt(std::max(0.0, 1.0 - across * across));
  side.offset_m = std::max(side.offset_m, side.normal.dot(middle) + reach_m);
  return side;
}

std::vector<HalfSpace> DrawFaces(const BoulderShape& shape, const Vector3d& centre,
                                 RandomStream& random) {
  const Vector3d middle(0.0, 0.0, shape.target_up_m);
  const HalfSpace face{FaceNormal(shape), FaceNormal(shape).dot(middle)};
  std::vector<HalfSpace> faces{face, {-Vector3d::UnitZ(), kBuried_m}};
  // Up the face, in its plane, to the upper edge.
  const Vector3d up_face = NormalOf(shape.face_up_rad + 0.5 * kPi, shape.face_turn_rad);
  const Vector3d behind =
      NormalOf(kPi - std::max(kBehind_rad - 0.2 * random.Uniform(), 0.0), shape.face_turn_rad);
  faces.push_back({behind, behind.dot(middle + shape.rim_m * up_face)});
  const Vector3d foot = NormalOf(kFootUp_rad, shape.face_turn_rad);
  if (shape.face_up_rad > 2.0 * kFootUp_rad) {
    faces.push_back({foot, foot.dot(middle - (kFace_m + kFoot_m) * up_face)});
  }
  for (int i = 0; i < kSides; ++i) {
    // Those beside and behind; the face itself is ahead.
    const double turn_rad =
        shape.face_turn_rad + kPi * (0.4 + 1.2 * (i + random.Uniform()) / kSides);
    const Vector3d normal = NormalOf(random.Uniform(kSteepest_rad, kFlattest_rad), turn_rad);
    const double half_m = 0.5 * shape.width_m * (1.0 - kUneven * random.Uniform());
    faces.push_back(ClearOfFace({normal, normal.dot(centre) + half_m}, face, middle));
  }
  return faces;
}

}  // namespace

Vector3d FaceNormal(const BoulderShape& shape) {
  return NormalOf(shape.face_up_rad, shape.face_turn_rad);
}

StarBody MakeBoulder(const BoulderShape& shape, std::uint64_t key) {
  RandomStream random(key);
  // Behind the face by half the width, in plan, and half-way down.
  const Vector3d ahead = NormalOf(0.0, shape.face_turn_rad);
  const Vector3d centre =
      -0.4 * shape.width_m * ahead + 0.4 * shape.target_up_m * Vector3d::UnitZ();
  const std::vector<HalfSpace> faces = DrawFaces(shape, centre, random);
  const RockRoughness roughness(shape.roughness_m, random);
  return MakeStarBody(centre, kLevel, [&](const Vector3d& direction) {
    double radius_m = 1e9;
    for (const HalfSpace& face : faces) {
      const double towards = face.normal.dot(direction);
      if (towards <= 1e-9) continue;
      radius_m = std::min(radius_m, (face.offset_m - face.normal.dot(centre)) / towards);
    }
    return radius_m + roughness.At(centre + radius_m * direction);
  });
}

}  // namespace dockyard
