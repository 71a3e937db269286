#include "sim/vehicles/loose_stones.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>

#include "sim/base/hash.h"
#include "sim/vehicles/moved_soil.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

// A stone slower than this, at every point, for so long sleeps. Assumed, 0.1-1 mm/s, 0.1-1 s: in
// that time it would creep 0.05 mm.
constexpr double kStill_m_s = 2e-4, kStill_s = 0.25;

// The outward area of each corner: of each face an equal part.
std::vector<Vector3d> CornerAreas(const ConvexBody& body) {
  std::vector<Vector3d> areas(body.vertices.size(), Vector3d::Zero());
  for (const HalfSpace& face : body.faces) {
    const auto IsOn = [&](std::size_t i) {
      return face.offset_m - face.normal.dot(body.vertices[i]) < 1e-7 * body.radius_m;
    };
    double area_m2 = 0.0;
    for (const auto& t : body.triangles) {
      if (!IsOn(t[0]) || !IsOn(t[1]) || !IsOn(t[2])) continue;
      const Vector3d &a = body.vertices[t[0]], &b = body.vertices[t[1]], &c = body.vertices[t[2]];
      area_m2 += 0.5 * (b - a).cross(c - a).norm();
    }
    std::vector<std::size_t> on;
    for (std::size_t i = 0; i < areas.size(); ++i) {
      if (IsOn(i)) on.push_back(i);
    }
    for (const std::size_t i : on) {
      areas[i] += area_m2 / static_cast<double>(on.size()) * face.normal;
    }
  }
  return areas;
}

}  // namespace

LooseStones::LooseStones(std::vector<ToolPart> parts, std::vector<SoilModel> soils,
                         const StoneMaterial& material)
    : parts_(std::move(parts)), soils_(std::move(soils)), material_(material) {}

int LooseStones::Add(const LooseStone& stone) {
  const ConvexBody& shape = stone.shape_S();
  std::vector<SoilLaws> laws;  // of a round plate as wide as the stone
  for (const SoilModel& soil : soils_) laws.push_back(MakeRimLaws(soil, shape.radius_m));
  stones_.push_back({stone, std::move(laws), CornerAreas(shape),
                     std::vector<double>(shape.vertices.size(), 0.0)});
  return count() - 1;
}

void LooseStones::AddForce(int stone, const Vector3d& force_G) {
  Kept& kept = stones_.at(Place(stone));
  kept.load_G += force_G;
  kept.asleep = false;
  kept.still_s = 0.0;
}

void LooseStones::Step(TreeBody& tool, const Vector3d& gravity_G, double step_s,
                       const HeightGrid& ground) {
  FindTouches(tool, ground, step_s);
  for (Kept& kept : stones_) {
    kept.moved = !kept.asleep;
    if (kept.asleep) continue;
    kept.body.TakeWeight(gravity_G, step_s);
    kept.body.AddImpulse(step_s * kept.load_G, kept.body.motion().X_GL.p);
    kept.load_G.setZero();
  }
  SolveAll(tool, step_s);
  for (Kept& kept : stones_) {
    if (kept.asleep) continue;
    kept.body.Move(step_s);
    Rest(kept, ground, step_s);
  }
  // Those of sleepers are kept for when they wake.
  for (const StoneTouch& last : last_touches_) {
    if (!stones_[Place(last.stone)].moved) touches_.push_back(last);
  }
  last_touches_ = touches_;
}

void LooseStones::Rest(Kept& kept, const HeightGrid& ground, double step_s) {
  const LinkMotion& motion = kept.body.motion();
  const int stone = static_cast<int>(&kept - stones_.data());
  const bool held = std::any_of(touches_.begin(), touches_.end(), [&](const StoneTouch& touch) {
    return touch.stone == stone && touch.part >= 0;
  });
  const double speed_m_s =
      motion.v_GL_G.norm() + kept.body.shape_S().radius_m * motion.w_GL_G.norm();
  kept.still_s = held || speed_m_s > kStill_m_s ? 0.0 : kept.still_s + step_s;
  if (kept.still_s < kStill_s) return;
  kept.asleep = true;
  kept.ground_m = BearingHeight(ground, motion.X_GL.p.x(), motion.X_GL.p.y());
  kept.body.SetMotion(Vector3d::Zero(), Vector3d::Zero());
}

std::uint64_t LooseStones::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = seed;
  for (const Kept& kept : stones_) {
    hash = HashDouble(kept.body.StateHash(hash), kept.still_s);
    for (const double sunk_m : kept.sunk_m) hash = HashDouble(hash, sunk_m);
  }
  for (const StoneTouch& touch : last_touches_) {
    for (int i = 0; i < 3; ++i) hash = HashDouble(hash, touch.bend_S[i]);
  }
  return hash;
}

}  // namespace dockyard
