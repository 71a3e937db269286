#include "sim/vehicles/loose_stone.h"

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

Pose3 StandingAt(const ConvexBody& shape, const Eigen::Vector2d& p_G, double turn_rad,
                 double ground_m) {
  double low_m = shape.vertices.front().z();
  for (const Vector3d& p : shape.vertices) low_m = std::min(low_m, p.z());
  return {RotZ(turn_rad), {p_G.x(), p_G.y(), ground_m - low_m}};
}

LooseStone MakeLooseStone(const ConvexBody& shape, double density_kg_m3, const Pose3& X_GS) {
  const SolidMass solid = MassOf(shape, density_kg_m3);
  LooseStone stone{.shape_S = Pose3{Matrix3d::Identity(), -solid.p_com} * shape, .X_GS = X_GS};
  stone.model.mass_kg = solid.mass_kg;
  stone.model.I_LCom_L = solid.I_com;
  return stone;
}

TreeBody BodyOf(const LooseStone& stone) {
  TreeLink link;
  link.model = stone.model;
  return TreeBody({link}, {}, stone.X_GS);
}

}  // namespace dockyard
