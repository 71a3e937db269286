#include "sim/vehicles/loose_stone.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"
#include "sim/base/random.h"
#include "sim/rigid/solid_mass.h"

namespace dockyard {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Points whose hull is a stone; assumed, 40-80.
constexpr int kPoints = 40;
// Zingg's ratios of width and height to length; assumed, 0.6-0.9 each.
constexpr double kWidth = 0.8, kHeight = 0.65;
// Noise of the radius, either way; assumed, 0.05-0.10.
constexpr double kRough = 0.08;
// A stone whose centre of mass is nearer to being over another face than this share of its radius
// does not rest on soil, which yields under the edge. Assumed, 0.03-0.1.
constexpr double kUnsteady = 0.05;

// The face that a ray from the origin in this direction leaves through.
const HalfSpace& FaceBeyond(const ConvexBody& shape, const Vector3d& direction_S) {
  const HalfSpace* first = &shape.faces.front();
  double nearest_m = 1e9;
  for (const HalfSpace& face : shape.faces) {
    const double along = face.normal.dot(direction_S);
    if (along <= 0.0 || face.offset_m >= nearest_m * along) continue;
    nearest_m = face.offset_m / along;
    first = &face;
  }
  return *first;
}

}  // namespace

ConvexBody LooseStoneShape(double length_m, std::uint64_t key) {
  RandomStream random(key);
  std::vector<Vector3d> points;
  double low = 0.0, high = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double z = random.Uniform(-1.0, 1.0), angle = random.Uniform(-kPi, kPi);
    const double r = std::sqrt(1.0 - z * z), size = random.Uniform(1.0 - kRough, 1.0 + kRough);
    points.push_back(size *
                     Vector3d(r * std::cos(angle), kWidth * r * std::sin(angle), kHeight * z));
    low = std::min(low, points.back().x());
    high = std::max(high, points.back().x());
  }
  for (Vector3d& p : points) p *= length_m / (high - low);
  const Vector3d com = MassOf(HullOf(points), 1.0).p_com;
  for (Vector3d& p : points) p -= com;
  return HullOf(points);
}

Matrix3d RestingTurn(const ConvexBody& shape, std::uint64_t key) {
  RandomStream random(key);
  const double z = random.Uniform(-1.0, 1.0), angle = random.Uniform(-kPi, kPi);
  const double r = std::sqrt(1.0 - z * z), turn_rad = random.Uniform(-kPi, kPi);
  const Vector3d down_S(r * std::cos(angle), r * std::sin(angle), z);
  const HalfSpace* on = &FaceBeyond(shape, down_S);
  // The foot is the point of the face below the centre of mass. Where it comes near to another face
  // the stone rolls onto that, if this lets the centre of mass down.
  while (true) {
    const Vector3d foot_S = on->offset_m * on->normal;
    const HalfSpace* next = on;
    double most_m = -kUnsteady * shape.radius_m;
    for (const HalfSpace& face : shape.faces) {
      const double beyond_m = face.normal.dot(foot_S) - face.offset_m;
      if (beyond_m <= most_m || face.offset_m >= on->offset_m) continue;
      most_m = beyond_m;
      next = &face;
    }
    if (next == on) break;
    on = next;
  }
  const Matrix3d R_FS =
      Eigen::Quaterniond::FromTwoVectors(on->normal, -Vector3d::UnitZ()).toRotationMatrix();
  return RotZ(turn_rad) * R_FS;
}

Pose3 StandingAt(const ConvexBody& shape, const Matrix3d& R_GS, const Eigen::Vector2d& p_G,
                 double ground_m, double buried) {
  double low_m = 1e9, high_m = -1e9;
  for (const Vector3d& p : shape.vertices) {
    const double z_m = R_GS.row(2).dot(p);
    low_m = std::min(low_m, z_m);
    high_m = std::max(high_m, z_m);
  }
  return {R_GS, {p_G.x(), p_G.y(), ground_m - low_m - buried * (high_m - low_m)}};
}

LooseStone MakeLooseStone(const ConvexBody& shape, double density_kg_m3, const Pose3& X_GS) {
  const SolidMass solid = MassOf(shape, density_kg_m3);
  LooseStone stone{.shape_S = Pose3{Matrix3d::Identity(), -solid.p_com} * shape, .X_GS = X_GS};
  stone.model.mass_kg = solid.mass_kg;
  stone.model.I_LCom_L = solid.I_com;
  return stone;
}

LooseStone MakeLooseStone(const ConvexBody& body_G, double density_kg_m3) {
  return MakeLooseStone(body_G, density_kg_m3,
                        {Matrix3d::Identity(), MassOf(body_G, density_kg_m3).p_com});
}

TreeBody BodyOf(const LooseStone& stone) {
  TreeLink link;
  link.model = stone.model;
  return TreeBody({link}, {}, stone.X_GS);
}

}  // namespace dockyard
