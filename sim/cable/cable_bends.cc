// Where a cable touches ground and solids at the start of a step.
#include <algorithm>
#include <cmath>

#include "sim/cable/cable_bends.h"

namespace dockyard {
namespace {

// Contact of cable and solid. Stiff enough that 300 N press a mass in by less than kSlip, below
// which a segment counts as bent over the solid. Numerical.
constexpr double kStiffness_n_per_m = 1e6;
// A segment bends over a solid that is smaller by this than what the masses touch, so that a mass
// passes over an edge without a jump of the length.
constexpr double kSlip_m = 1e-5;
// Ground below a cable gives way: sand under a rod as wide as the cable bears this (assumed, range
// 3e4-3e5 Pa), and rebounds with this stiffness per mass (assumed, range 5e3-1e5 N/m).
constexpr double kBearing_pa = 1e5;
constexpr double kGround_n_per_m = 2e4;
// Masses this far off are looked at in a step [m], and twice their way in it.
constexpr double kNear_m = 1e-3;
// The plane of a bend turns by this at a time when the cable slips sideways over a solid.
constexpr double kTurn_rad = 0.01;
constexpr double kNothing_m = 1e-9;

// A bend that the masses leave by less than this stays where it was: a mass that passes an edge
// hands its bend over to the next segment. Numerical.
constexpr double kHandOver_m = 2e-5, kHandOverReach_m = 5e-3;

// The last direction out of the solid, turned with the cable's. When it has little of the direction
// between the faces' normals, that one.
Eigen::Vector3d Upwards(const Eigen::Vector3d& last_B, const Eigen::Vector3d& out_B,
                        const Eigen::Vector3d& way_B) {
  constexpr double kLeast = 0.3;
  const Eigen::Vector3d along = way_B.normalized();
  const Eigen::Vector3d up = (last_B - last_B.dot(along) * along).normalized();
  const Eigen::Vector3d out = (out_B - out_B.dot(along) * along).normalized();
  return up.dot(out) > kLeast ? up : out;
}

// The way from a to b over the edge of another way.
WayRound Kept(const WayRound& last, const Eigen::Vector3d& a_B, const Eigen::Vector3d& b_B) {
  WayRound way;
  const auto Apart = [&](const Eigen::Vector3d& edge_B) {
    return std::min((edge_B - a_B).squaredNorm(), (edge_B - b_B).squaredNorm());
  };
  way.first_B = Apart(last.first_B) < Apart(last.last_B) ? last.first_B : last.last_B;
  way.last_B = way.first_B;
  way.bends = last.bends && Apart(way.first_B) < kHandOverReach_m * kHandOverReach_m;
  way.turn_rad = last.turn_rad;
  way.length_m = (way.first_B - a_B).norm() + (b_B - way.last_B).norm();
  return way;
}

void TurnUp(const CableBody& body, double diameter_m, const Eigen::Vector3d& a_B,
            const Eigen::Vector3d& b_B, CableBend& bend) {
  // Sideways the cable slips where the way becomes shorter by more than friction holds: the work of
  // turning the plane by d against the friction of N = 2 T sin(turn / 2) at its lever.
  const double grow = 0.5 * diameter_m + kSlip_m;
  const Eigen::Vector3d along = (b_B - a_B).normalized();
  const Eigen::Vector3d up = (bend.up_B - bend.up_B.dot(along) * along).normalized();
  const Eigen::Vector3d aside = along.cross(up);
  const Eigen::Vector3d to = bend.way.first_B - a_B;
  const double lever = (to - to.dot(along) * along).norm();
  const double hold = body.friction * 2.0 * std::sin(0.5 * bend.way.turn_rad) * lever * kTurn_rad;
  for (const double turn : {kTurn_rad, -kTurn_rad}) {
    const Eigen::Vector3d turned = up + turn * aside;
    const WayRound way = FindWayRound(body, a_B, b_B, turned, grow);
    if (!way.bends || bend.way.length_m - way.length_m <= hold + kNothing_m) continue;
    bend.up_B = turned.normalized();
    bend.way = way;
    return;
  }
}

void BendOver(const CableStep& step, const CableModel& model, const std::vector<int>& near,
              std::vector<CableNode>& nodes, int segment, const CableBend& last, CableSpan& span) {
  CableBend& bend = nodes[segment].bend;
  if (bend.body != kCableFree) bend = CableBend{};
  const Eigen::Vector3d& a_G = segment == 0 ? step.p_GF : nodes[segment - 1].p_G;
  const Eigen::Vector3d& b_G = nodes[segment].p_G;
  const Eigen::Vector3d middle = 0.5 * (a_G + b_G);
  const double half = 0.5 * (b_G - a_G).norm(), radius = 0.5 * model.diameter_m;
  const double grow = radius + kSlip_m;
  for (const int i : near) {
    const CableBody& body = (*step.bodies)[i];
    const double reach = body.reach_m + radius + half;
    if ((middle - body.motion.X_GL.p).squaredNorm() > reach * reach) continue;
    const Pose3 X_BG = Inverse(body.motion.X_GL);
    const Eigen::Vector3d a_B = X_BG * a_G, b_B = X_BG * b_G;
    const Eigen::Vector3d middle_B = 0.5 * (a_B + b_B);
    if (middle_B.head<2>().norm() < body.hole_radius_m && middle_B.z() > 0.0) continue;
    Eigen::Vector3d out_B;
    const double within = last.body == i ? kHandOver_m : 0.0;
    if (!PassesThrough(body, a_B, b_B, grow + within, out_B)) continue;
    CableBend tried;
    if (last.body == i) tried = last;
    tried.body = i;
    tried.up_B = Upwards(tried.up_B, out_B, b_B - a_B);
    tried.way = FindWayRound(body, a_B, b_B, tried.up_B, grow);
    if (tried.way.bends) {
      TurnUp(body, model.diameter_m, a_B, b_B, tried);
    } else if (last.body == i) {
      tried.way = Kept(last.way, a_B, b_B);
    }
    if (!tried.way.bends) continue;
    bend = tried;
    span.a_is_near = span.b_is_near = false;
    const Pose3& X_GB = body.motion.X_GL;
    span.first_G = X_GB * bend.way.first_B;
    span.last_G = X_GB * bend.way.last_B;
    span.v_first_G = body.motion.VelocityAt(span.first_G);
    span.v_last_G = body.motion.VelocityAt(span.last_G);
    span.across_G = X_GB.R * (b_B - a_B).cross(bend.up_B).normalized();
    span.friction = body.friction;
    return;
  }
}

}  // namespace

void FindNearBodies(const CableStep& step, const CableModel& model,
                    const std::vector<CableNode>& nodes, std::vector<int>& near) {
  near.clear();
  if (step.bodies == nullptr) return;
  Eigen::Vector3d low = step.p_GF, high = step.p_GF;
  for (const CableNode& node : nodes) {
    low = low.cwiseMin(node.p_G);
    high = high.cwiseMax(node.p_G);
  }
  for (int i = 0; i < static_cast<int>(step.bodies->size()); ++i) {
    const CableBody& body = (*step.bodies)[i];
    const Eigen::Vector3d& at = body.motion.X_GL.p;
    const double reach = body.reach_m + model.spacing_m;
    if ((at - at.cwiseMax(low).cwiseMin(high)).squaredNorm() < reach * reach) near.push_back(i);
  }
}

void FindTouches(const CableStep& step, const CableModel& model,
                 const std::vector<CableNode>& nodes, const std::vector<int>& near,
                 double deepest_m, std::vector<CableTouch>& touches) {
  touches.clear();
  const double radius = 0.5 * model.diameter_m;
  const auto Add = [&](CableTouch touch) {
    for (const CableGrip& grip : nodes[touch.node].grips) {
      if (grip.body == touch.body) touch.bend_G = grip.bend_G;
    }
    touch.bend_G -= touch.bend_G.dot(touch.normal_G) * touch.normal_G;
    touch.gap_m = std::max(touch.gap_m, -deepest_m);
    touches.push_back(touch);
  };
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    const CableNode& node = nodes[i];
    const double near_m = kNear_m + 2.0 * step.step_s * node.v_G.norm();
    if (step.ground != nullptr) {
      const double above = node.p_G.z() - radius - step.ground->Height(node.p_G.x(), node.p_G.y());
      if (above < near_m) {
        CableTouch touch;
        touch.node = i;
        touch.body = kCableOnGround;
        touch.normal_G = step.ground->Normal(node.p_G.x(), node.p_G.y());
        touch.gap_m = above * touch.normal_G.z();
        touch.friction = model.friction_on_ground;
        touch.stiffness_n_per_m = kGround_n_per_m;
        touch.most_n = kBearing_pa * model.diameter_m * model.spacing_m;
        Add(touch);
      }
    }
    for (const int b : near) {
      const CableBody& body = (*step.bodies)[b];
      const Eigen::Vector3d from_centre = node.p_G - body.motion.X_GL.p;
      const double reach = body.reach_m + radius + near_m;
      if (from_centre.squaredNorm() > reach * reach) continue;
      // Of the face that is nearest after the step: a mass that slides along one face over the
      // end of another does not meet that one.
      const Eigen::Vector3d v_body_G = body.motion.VelocityAt(node.p_G);
      const Eigen::Vector3d way_G = step.step_s * (node.v_G - v_body_G);
      const Eigen::Matrix3d R_BG = body.motion.X_GL.R.transpose();
      const Eigen::Vector3d p_B = R_BG * from_centre;
      NearestFace nearest = FindNearestFace(body, p_B + R_BG * way_G);
      if (nearest.gap_m - radius > near_m) continue;
      const CableFace& face = body.faces[nearest.face];
      nearest.gap_m = face.normal_B.dot(p_B) - face.offset_m;
      if (p_B.head<2>().norm() < body.hole_radius_m && p_B.z() > 0.0) continue;
      CableTouch touch;
      touch.node = i;
      touch.body = b;
      touch.normal_G = body.motion.X_GL.R * face.normal_B;
      touch.v_body_G = v_body_G;
      touch.gap_m = nearest.gap_m - radius;
      touch.friction = body.friction;
      touch.stiffness_n_per_m = kStiffness_n_per_m;
      touch.most_n = 1e9;
      Add(touch);
    }
  }
}

void FindBends(const CableStep& step, const CableModel& model, const std::vector<int>& near,
               std::vector<CableNode>& nodes, std::vector<CableSpan>& spans) {
  const auto bend_over = [&](int j, const CableBend& last) {
    BendOver(step, model, near, nodes, j, last, spans[j]);
  };
  spans.resize(nodes.size());
  for (CableSpan& span : spans) span.slid_m = span.swept_m = 0.0;
  if (near.empty()) {
    for (CableNode& node : nodes) node.bend = CableBend{};
    return;
  }
  const CableBend none;
  CableBend own;  // of this segment and of the one before, in the last step
  bool before_bent = false;
  for (int j = 0; j < static_cast<int>(nodes.size()); ++j) {
    CableBend& bend = nodes[j].bend;
    const bool bent = bend.body != kCableFree;
    const bool after_bent =
        j + 1 < static_cast<int>(nodes.size()) && nodes[j + 1].bend.body != kCableFree;
    if (!bent && before_bent) {
      const CableBend before = own;
      bend_over(j, before);
    } else if (bent) {
      own = bend;
      bend_over(j, own);
    } else {
      bend_over(j, after_bent ? nodes[j + 1].bend : none);
    }
    before_bent = bent;
  }
}

}  // namespace dockyard
