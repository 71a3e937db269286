#include "sim/cable/cable_body.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

// A slice of a convex solid has at most one corner more than the solid has faces.
constexpr int kMostCorners = 96;

struct Slice {
  std::array<Eigen::Vector2d, kMostCorners> corners;
  int count = 0;
};

// Keeps what lies where normal . p <= offset.
void Cut(Slice& slice, const Eigen::Vector2d& normal, double offset_m) {
  Slice kept;
  for (int i = 0; i < slice.count; ++i) {
    const Eigen::Vector2d& p = slice.corners[i];
    const Eigen::Vector2d& q = slice.corners[(i + 1) % slice.count];
    const double at_p = normal.dot(p) - offset_m, at_q = normal.dot(q) - offset_m;
    if (at_p <= 0.0) kept.corners[kept.count++] = p;
    if ((at_p < 0.0) != (at_q < 0.0) && at_p != 0.0 && at_q != 0.0) {
      kept.corners[kept.count++] = p + at_p / (at_p - at_q) * (q - p);
    }
    if (kept.count > kMostCorners - 2) break;
  }
  slice = kept;
}

// The part of the solid above the line from a to b, in coordinates along the line and up.
Slice SliceAbove(const CableBody& body, const Eigen::Vector3d& a_B, const Eigen::Vector3d& along_B,
                 const Eigen::Vector3d& up_B, double length_m, double grow_m) {
  const double high = 4.0 * (body.reach_m + grow_m) + a_B.norm();
  Slice slice;
  slice.corners[0] = {0.0, 0.0};
  slice.corners[1] = {length_m, 0.0};
  slice.corners[2] = {length_m, high};
  slice.corners[3] = {0.0, high};
  slice.count = 4;
  for (const CableFace& face : body.faces) {
    const Eigen::Vector2d normal(face.normal_B.dot(along_B), face.normal_B.dot(up_B));
    Cut(slice, normal, face.offset_m + grow_m - face.normal_B.dot(a_B));
    if (slice.count == 0) break;
  }
  return slice;
}

// A point that has sunk in by a little counts as standing on the surface.
Eigen::Vector3d OnSurface(const CableBody& body, const Eigen::Vector3d& p_B, double grow_m) {
  const NearestFace nearest = FindNearestFace(body, p_B);
  const double out = nearest.gap_m - grow_m;
  constexpr double kClear = 1e-9;
  return out >= kClear ? p_B
                       : Eigen::Vector3d(p_B + (kClear - out) * body.faces[nearest.face].normal_B);
}

}  // namespace

CableBody CableBox(const Eigen::Vector3d& size_m, double friction) {
  CableBody body;
  for (int axis = 0; axis < 3; ++axis) {
    body.faces.push_back({Eigen::Vector3d::Unit(axis), 0.5 * size_m[axis]});
    body.faces.push_back({-Eigen::Vector3d::Unit(axis), 0.5 * size_m[axis]});
  }
  body.reach_m = 0.5 * size_m.norm();
  body.friction = friction;
  return body;
}

CableBody CablePrism(double radius_m, double length_m, int sides, double phase_rad,
                     double friction) {
  CableBody body;
  body.faces.push_back({Eigen::Vector3d::UnitZ(), 0.5 * length_m});
  body.faces.push_back({-Eigen::Vector3d::UnitZ(), 0.5 * length_m});
  const double half = kPi / sides;
  for (int i = 0; i < sides; ++i) {
    const double angle = phase_rad + (2 * i + 1) * half;
    body.faces.push_back({{std::cos(angle), std::sin(angle), 0.0}, radius_m * std::cos(half)});
  }
  body.reach_m = std::hypot(radius_m, 0.5 * length_m);
  body.friction = friction;
  return body;
}

CableBody CableRock(const ConvexBody& rock_G, double friction) {
  CableBody body;
  for (const HalfSpace& face : rock_G.faces) {
    body.faces.push_back({face.normal, face.offset_m - face.normal.dot(rock_G.centre)});
  }
  body.reach_m = rock_G.radius_m;
  body.friction = friction;
  body.motion.X_GL.p = rock_G.centre;
  return body;
}

NearestFace FindNearestFace(const CableBody& body, const Eigen::Vector3d& p_B) {
  NearestFace nearest{-1e9, 0};
  for (int i = 0; i < static_cast<int>(body.faces.size()); ++i) {
    const double gap = body.faces[i].normal_B.dot(p_B) - body.faces[i].offset_m;
    if (gap > nearest.gap_m) nearest = {gap, i};
  }
  return nearest;
}

bool PassesThrough(const CableBody& body, const Eigen::Vector3d& a_B, const Eigen::Vector3d& b_B,
                   double grow_m, Eigen::Vector3d& out_B) {
  double from = 0.0, to = 1.0;
  int in = -1, out = -1;
  for (int i = 0; i < static_cast<int>(body.faces.size()); ++i) {
    const CableFace& face = body.faces[i];
    const double at_a = face.normal_B.dot(a_B) - face.offset_m - grow_m;
    const double at_b = face.normal_B.dot(b_B) - face.offset_m - grow_m;
    if (at_a > 0.0 && at_b > 0.0) return false;
    if (at_a > 0.0 && at_a > from * (at_a - at_b)) {
      from = at_a / (at_a - at_b);
      in = i;
    } else if (at_b > 0.0 && at_a < to * (at_a - at_b)) {
      to = at_a / (at_a - at_b);
      out = i;
    }
  }
  if (from >= to) return false;
  if (in < 0) in = FindNearestFace(body, a_B).face;
  if (out < 0) out = FindNearestFace(body, b_B).face;
  out_B = body.faces[in].normal_B + body.faces[out].normal_B;
  return in != out;
}

WayRound FindWayRound(const CableBody& body, const Eigen::Vector3d& from_B,
                      const Eigen::Vector3d& to_B, const Eigen::Vector3d& up_B, double grow_m) {
  const Eigen::Vector3d a_B = OnSurface(body, from_B, grow_m), b_B = OnSurface(body, to_B, grow_m);
  WayRound way;
  way.length_m = (b_B - a_B).norm();
  if (way.length_m < 1e-9) return way;
  const Eigen::Vector3d along = (b_B - a_B) / way.length_m;
  Eigen::Vector3d up = up_B - up_B.dot(along) * along;
  if (up.norm() < 1e-6 * up_B.norm()) return way;
  up.normalize();
  const Slice slice = SliceAbove(body, a_B, along, up, way.length_m, grow_m);
  // From a to b over the slice, always to the corner that leaves all others on its right.
  const Eigen::Vector2d goal(way.length_m, 0.0);
  Eigen::Vector2d at(0.0, 0.0), heading(0.0, 0.0), first_heading(0.0, 0.0);
  double length = 0.0;
  int bends = 0;
  for (; bends <= slice.count; ++bends) {
    Eigen::Vector2d next = goal;
    bool is_goal = true;
    for (int i = 0; i < slice.count; ++i) {
      const Eigen::Vector2d& corner = slice.corners[i];
      if ((corner - at).squaredNorm() < 1e-20) continue;
      const double side = Cross(next - at, corner - at);
      if (side > 1e-12 ||
          (side > -1e-12 && !is_goal && (corner - at).squaredNorm() > (next - at).squaredNorm())) {
        next = corner;
        is_goal = false;
      }
    }
    heading = next - at;
    if (bends == 0) first_heading = heading;
    if (is_goal) break;
    const Eigen::Vector3d p_B = a_B + next.x() * along + next.y() * up;
    if (bends == 0) {
      way.first_B = p_B;
    } else {
      way.between_m += heading.norm();
    }
    way.last_B = p_B;
    length += heading.norm();
    at = next;
  }
  if (bends == 0 || bends > slice.count) return way;
  way.bends = true;
  way.length_m = length + heading.norm();
  way.turn_rad =
      std::acos(std::clamp(first_heading.normalized().dot(heading.normalized()), -1.0, 1.0));
  return way;
}

}  // namespace dockyard
