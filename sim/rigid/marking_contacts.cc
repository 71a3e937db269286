#include "sim/rigid/marking_contacts.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"
#include "sim/rigid/ground_friction.h"
#include "sim/soil/plate_mark.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// Slopes about a mark slump so often, one pass while its point presses and more when it has left
// (assumed, 5-50 ms and 5-50 passes, as those about a scoop). The square in which they do reaches
// over the heap by this many cells: a heap of 40 mm at 29 deg is 4 cells long. Assumed, 4-10.
constexpr double kSlump_s = 0.01;
constexpr int kPassesWhenOut = 10;
constexpr double kReachCells = 6.0;
// The wall before a plate is measured this many cells ahead of its edge, clear of the samples that
// it presses. Assumed, 1.5-3.
constexpr double kAheadCells = 1.5;

}  // namespace

std::size_t MarkingContacts::Add(const GroundMaterial& material, double diameter_m) {
  DOCKYARD_CHECK(diameter_m > 0.0 && material.stiffness_n_per_m > 0.0 && !soils_.empty());
  Point point;
  point.material = material;
  point.radius_m = 0.5 * diameter_m;
  for (const SoilModel& soil : soils_) {
    SinkingPlate plate = RoundPlate(soil, diameter_m);
    plate.rebound_n_per_m = 1.0 / (1.0 / plate.rebound_n_per_m + 1.0 / material.stiffness_n_per_m);
    point.laws.push_back({plate, MakeRimLaws(soil, diameter_m)});
  }
  points_.push_back(std::move(point));
  return points_.size() - 1;
}

// The wall ahead, which a furrow or a rut may have taken away.
Vector3d MarkingContacts::WallForce(const HeightGrid& ground, const Laws& laws, double sunk_m,
                                    const Vector3d& slide_G, Point& point) const {
  const double modulus_m = ShearModulus(laws.wall, ContactDepth(sunk_m));
  point.push = Shear(point.push, slide_G.x(), slide_G.y(), modulus_m);
  const Eigen::Vector2d push(point.push.t, point.push.a);
  if (push.isZero(0.0) || sunk_m <= 0.0) return Vector3d::Zero();
  const Eigen::Vector2d ahead =
      point.mark.centre + (point.radius_m + kAheadCells * ground.cell_m) * push.normalized();
  const double wall_m = sunk_m - std::max(0.0, FindUndisturbed(ground, ahead).sunk_m);
  if (wall_m <= 0.0) return Vector3d::Zero();
  const double wall_n = 2.0 * point.radius_m * BulldozingResistance(laws.wall, wall_m);
  return {-wall_n * push.x(), -wall_n * push.y(), 0.0};
}

// Its hole has no plate any more that holds its walls apart.
void MarkingContacts::Release(Point& point) {
  point.slumps = point.slumps || point.marks;
  point.marks = false;
  point.grip = {};
  point.push = {};
}

Vector3d MarkingContacts::Step(HeightGrid& ground, std::size_t number, const Vector3d& p_G,
                               const Vector3d& v_G, double dt_s) {
  Point& point = points_.at(number);
  KeepUndisturbed(ground);
  const UndisturbedAt soil = FindUndisturbed(ground, p_G.head<2>());
  const Vector3d& n = soil.normal_G;
  const double depth_m = (soil.height_m - p_G.z()) * n.z();
  const double before_m = soil.sunk_m * n.z();
  point.presses = depth_m > before_m;
  if (!point.presses) {
    Release(point);
    return Vector3d::Zero();
  }
  const Laws& laws = point.laws.at(ground.SoilAt(p_G));
  point.mark = {p_G.head<2>(), point.radius_m};
  point.friction = laws.wall.tan_phi;
  double sunk_m = before_m;
  double borne_n = 0.0;
  if (depth_m > 0.0) {
    borne_n = PressPlate(laws.plate, depth_m, sunk_m);
  } else {
    sunk_m = depth_m;  // it ploughs through a heap
  }
  const double speed_out = v_G.dot(n);
  // Damping at most doubles what soil bears.
  const double press_n =
      std::clamp(borne_n - point.material.damping_ns_per_m * speed_out, 0.0, 2.0 * borne_n);
  const Vector3d v_along = v_G - speed_out * n;
  const GroundMaterial& material = point.material;
  const Vector3d drag =
      GroundFriction({material.stiffness_n_per_m, material.damping_ns_per_m},
                     material.friction * press_n, n, v_along, dt_s, point.grip.bend_G);
  const Vector3d wall = WallForce(ground, laws, sunk_m / n.z(), dt_s * v_along, point);
  if (sunk_m > before_m) {
    const double volume_m3 = PressMark(ground, point.mark, sunk_m / n.z());
    HeapAround(ground, point.mark, {point.push.t, point.push.a}, volume_m3);
    point.marks = point.slumps = true;
  }
  return press_n * n + drag + wall;
}

void MarkingContacts::Slump(HeightGrid& ground, double dt_s) {
  since_slump_s_ += dt_s;
  if (since_slump_s_ < kSlump_s - 1e-9) return;
  since_slump_s_ = 0.0;
  held_.clear();
  for (const Point& point : points_) {
    if (point.presses) held_.push_back(point.mark);
  }
  for (Point& point : points_) {
    if (!point.slumps) continue;
    const double half_m = point.radius_m + kReachCells * ground.cell_m;
    point.slumps = !dockyard::Slump(ground, {point.mark.centre, half_m, point.friction, held_},
                                    point.presses ? 1 : kPassesWhenOut);
  }
}

std::uint64_t MarkingContacts::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashDouble(seed, since_slump_s_);
  for (const Point& point : points_) {
    hash = HashPoint(hash, point.grip);
    hash = HashDouble(HashDouble(hash, point.push.t), point.push.a);
    hash = HashBits(hash, (point.marks ? 1 : 0) + (point.slumps ? 2 : 0));
  }
  return hash;
}

}  // namespace dockyard
