// Where a cable touches ground and solids at the start of a step.
#include <algorithm>
#include <cmath>

#include "sim/cable/cable.h"

namespace dockyard {
namespace {

// Contact of cable and solid. Stiff enough that 300 N press a mass in by less than kSlip, below
// which a segment counts as bent over the solid. Numerical.
constexpr double kStiffnessNPerM = 1e6;
// A segment bends over a solid that is smaller by this than what the masses touch, so that a mass
// passes over an edge without a jump of the length.
constexpr double kSlipM = 1e-5;
// Ground below a cable gives way: sand under a rod as wide as the cable bears this (assumed, range
// 3e4-3e5 Pa), and rebounds with this stiffness per mass (assumed, range 5e3-1e5 N/m).
constexpr double kBearingPa = 1e5;
constexpr double kGroundNPerM = 2e4;
// Masses this far off are looked at in a step [m], and twice their way in it.
constexpr double kNearM = 1e-3;
// The plane of a bend turns by this at a time when the cable slips sideways over a solid.
constexpr double kTurnRad = 0.01;
constexpr double kNothingM = 1e-9;

// A bend that the masses leave by less than this stays where it was: a mass that passes an edge
// hands its bend over to the next segment. Numerical.
constexpr double kHandOverM = 2e-5, kHandOverReachM = 5e-3;

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
  way.bends = last.bends && Apart(way.first_B) < kHandOverReachM * kHandOverReachM;
  way.turn_rad = last.turn_rad;
  way.length_m = (way.first_B - a_B).norm() + (b_B - way.last_B).norm();
  return way;
}

}  // namespace

void Cable::FindNearBodies(const CableStep& step) {
  near_.clear();
  if (step.bodies == nullptr) return;
  Eigen::Vector3d low = step.p_GF, high = step.p_GF;
  for (const Node& node : nodes_) {
    low = low.cwiseMin(node.p_G);
    high = high.cwiseMax(node.p_G);
  }
  for (int i = 0; i < static_cast<int>(step.bodies->size()); ++i) {
    const CableBody& body = (*step.bodies)[i];
    const Eigen::Vector3d& at = body.motion.X_GL.p;
    const double reach = body.reach_m + model_.spacing_m;
    if ((at - at.cwiseMax(low).cwiseMin(high)).squaredNorm() < reach * reach) near_.push_back(i);
  }
}

void Cable::FindTouches(const CableStep& step) {
  touches_.clear();
  const double radius = 0.5 * model_.diameter_m;
  const auto Add = [&](Touch touch) {
    for (const Grip& grip : nodes_[touch.node].grips) {
      if (grip.body == touch.body) touch.bend_G = grip.bend_G;
    }
    touch.bend_G -= touch.bend_G.dot(touch.normal_G) * touch.normal_G;
    touch.gap_m = std::max(touch.gap_m, -deepest_m);
    touches_.push_back(touch);
  };
  for (int i = 0; i < masses(); ++i) {
    const Node& node = nodes_[i];
    const double near_m = kNearM + 2.0 * step.step_s * node.v_G.norm();
    if (step.ground != nullptr) {
      const double above = node.p_G.z() - radius - step.ground->Height(node.p_G.x(), node.p_G.y());
      if (above < near_m) {
        Touch touch;
        touch.node = i;
        touch.body = kGround;
        touch.normal_G = step.ground->Normal(node.p_G.x(), node.p_G.y());
        touch.gap_m = above * touch.normal_G.z();
        touch.friction = model_.friction_on_ground;
        touch.stiffness_n_per_m = kGroundNPerM;
        touch.most_n = kBearingPa * model_.diameter_m * model_.spacing_m;
        Add(touch);
      }
    }
    for (const int b : near_) {
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
      Touch touch;
      touch.node = i;
      touch.body = b;
      touch.normal_G = body.motion.X_GL.R * face.normal_B;
      touch.v_body_G = v_body_G;
      touch.gap_m = nearest.gap_m - radius;
      touch.friction = body.friction;
      touch.stiffness_n_per_m = kStiffnessNPerM;
      touch.most_n = 1e9;
      Add(touch);
    }
  }
}

void Cable::FindBends(const CableStep& step) {
  std::vector<Span>& spans = spans_;
  spans.resize(nodes_.size());
  for (Span& span : spans) span.slid_m = span.swept_m = 0.0;
  if (near_.empty()) {
    for (Node& node : nodes_) node.bend = Bend{};
    return;
  }
  const Bend none;
  Bend own;  // of this segment and of the one before, in the last step
  bool before_bent = false;
  for (int j = 0; j < masses(); ++j) {
    Bend& bend = nodes_[j].bend;
    const bool bent = bend.body != kNone;
    const bool after_bent = j + 1 < masses() && nodes_[j + 1].bend.body != kNone;
    if (!bent && before_bent) {
      const Bend before = own;
      BendOver(step, j, before);
    } else if (bent) {
      own = bend;
      BendOver(step, j, own);
    } else {
      BendOver(step, j, after_bent ? nodes_[j + 1].bend : none);
    }
    before_bent = bent;
  }
}

void Cable::TurnUp(const CableBody& body, const Eigen::Vector3d& a_B, const Eigen::Vector3d& b_B,
                   Bend& bend) const {
  // Sideways the cable slips where the way becomes shorter by more than friction holds: the work of
  // turning the plane by d against the friction of N = 2 T sin(turn / 2) at its lever.
  const double grow = 0.5 * model_.diameter_m + kSlipM;
  const Eigen::Vector3d along = (b_B - a_B).normalized();
  const Eigen::Vector3d up = (bend.up_B - bend.up_B.dot(along) * along).normalized();
  const Eigen::Vector3d aside = along.cross(up);
  const Eigen::Vector3d to = bend.way.first_B - a_B;
  const double lever = (to - to.dot(along) * along).norm();
  const double hold = body.friction * 2.0 * std::sin(0.5 * bend.way.turn_rad) * lever * kTurnRad;
  for (const double turn : {kTurnRad, -kTurnRad}) {
    const Eigen::Vector3d turned = up + turn * aside;
    const WayRound way = FindWayRound(body, a_B, b_B, turned, grow);
    if (!way.bends || bend.way.length_m - way.length_m <= hold + kNothingM) continue;
    bend.up_B = turned.normalized();
    bend.way = way;
    return;
  }
}

void Cable::BendOver(const CableStep& step, int segment, const Bend& last) {
  Bend& bend = nodes_[segment].bend;
  if (bend.body != kNone) bend = Bend{};
  const Eigen::Vector3d& a_G = segment == 0 ? step.p_GF : nodes_[segment - 1].p_G;
  const Eigen::Vector3d& b_G = nodes_[segment].p_G;
  const Eigen::Vector3d middle = 0.5 * (a_G + b_G);
  const double half = 0.5 * (b_G - a_G).norm(), radius = 0.5 * model_.diameter_m;
  const double grow = radius + kSlipM;
  for (const int i : near_) {
    const CableBody& body = (*step.bodies)[i];
    const double reach = body.reach_m + radius + half;
    if ((middle - body.motion.X_GL.p).squaredNorm() > reach * reach) continue;
    const Pose3 X_BG = Inverse(body.motion.X_GL);
    const Eigen::Vector3d a_B = X_BG * a_G, b_B = X_BG * b_G;
    const Eigen::Vector3d middle_B = 0.5 * (a_B + b_B);
    if (middle_B.head<2>().norm() < body.hole_radius_m && middle_B.z() > 0.0) continue;
    Eigen::Vector3d out_B;
    const double within = last.body == i ? kHandOverM : 0.0;
    if (!PassesThrough(body, a_B, b_B, grow + within, out_B)) continue;
    Bend tried;
    if (last.body == i) tried = last;
    tried.body = i;
    tried.up_B = Upwards(tried.up_B, out_B, b_B - a_B);
    tried.way = FindWayRound(body, a_B, b_B, tried.up_B, grow);
    if (tried.way.bends) {
      TurnUp(body, a_B, b_B, tried);
    } else if (last.body == i) {
      tried.way = Kept(last.way, a_B, b_B);
    }
    if (!tried.way.bends) continue;
    bend = tried;
    Span& span = spans_[segment];
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

}  // namespace dockyard
