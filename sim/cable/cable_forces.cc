// The forces of a cable's segments and of what it touches, at the speeds tried, and how they change
// with them.
#include <algorithm>
#include <cmath>

#include "sim/cable/cable_forces.h"

namespace dockyard {
namespace {

// A piece counts as at least this long, so that stiffness and direction stay finite.
constexpr double kShortest_m = 1e-3;
constexpr double kNothing_m = 1e-9;
// So near an edge a mass is about to pass it. Numerical: ten times its way in a step.
constexpr double kNearEdge_m = 2e-3;
// The share of a bristle's stiffness that keeps its force within the limit at this bend.
double Held(double most_n, double bend_m, double bristle_n_per_m) {
  const double force = bristle_n_per_m * std::abs(bend_m);
  return force > most_n ? most_n / force : 1.0;
}

struct Tension {
  double n = 0.0, per_speed = 0.0;  // and its slope over the rate of stretch
};

/// The straight parts of a segment as tried, from a and from b to where they end.
struct Pulled {
  struct Part {
    Eigen::Vector3d dir{0, 0, 0}, off{0, 0, 0};  // off: what the direction leaves, per length
    double length_m = 0.0, rate_m_s = 0.0;
    double per_m = 0.0;  // how fast the direction turns with the end's way aside
  };
  Part a, b;
  Eigen::Vector3d v_a_G, v_b_G;
  double length_m = 0.0;
  Tension tension;
};

void PullBent(const Pulled& pulled, double h, const CableBend& bend, CableSpan& span) {
  const Eigen::Vector3d &a = pulled.a.dir, &b = pulled.b.dir, &m = span.across_G;
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  const double tension = pulled.tension.n;
  // Along the cable: what slides from a's side to b's makes b's part the tighter one.
  const double slid = bend.slid_m + 0.5 * h * (pulled.b.rate_m_s - pulled.a.rate_m_s);
  const double held =
      kCableBristle_n_per_m * Held(span.most_ratio * tension, slid, kCableBristle_n_per_m);
  const double rub = held * slid, t_a = tension - rub, t_b = tension + rub;
  const double stiff = pulled.tension.per_speed, give = 0.5 * h * held;
  span.slid_m = rub / kCableBristle_n_per_m;
  span.on_a_G = t_a * (a + pulled.a.off);
  span.on_b_G = t_b * (b + pulled.b.off);
  span.aa =
      (stiff + give) * a * a.transpose() + h * t_a * pulled.a.per_m * (one - a * a.transpose());
  span.bb =
      (stiff + give) * b * b.transpose() + h * t_b * pulled.b.per_m * (one - b * b.transpose());
  span.ab = (stiff - give) * a * b.transpose();
  // Across it.
  const double all = std::abs(pulled.a.length_m) + std::abs(pulled.b.length_m);
  const double w_a = std::abs(pulled.b.length_m) / all, w_b = 1.0 - w_a;
  const double sweep =
      m.dot(w_a * (pulled.v_a_G - span.v_first_G) + w_b * (pulled.v_b_G - span.v_last_G));
  const double swept = bend.swept_m + h * sweep;
  const double press = (span.on_a_G + span.on_b_G).norm();
  const double hold =
      kCableBristle_n_per_m * Held(span.friction * press, swept, kCableBristle_n_per_m);
  const Eigen::Matrix3d mm = h * hold * m * m.transpose();
  span.swept_m = hold * swept / kCableBristle_n_per_m;
  span.on_a_G -= w_a * hold * swept * m;
  span.on_b_G -= w_b * hold * swept * m;
  span.aa += w_a * w_a * mm;
  span.bb += w_b * w_b * mm;
  span.ab += w_a * w_b * mm;
}

// A part that is shorter than kNearEdge_m keeps its direction through the step, so that a mass
// passes the edge as on a straight line; aside of that it is held as by a part of that length.
Pulled PartsOf(const CableStep& step, const std::vector<CableNode>& nodes, int j,
               const CableSpan& span, double ahead_s, const Eigen::Vector3d& v_a_G,
               const Eigen::Vector3d& v_b_G) {
  const CableNode& node = nodes[j];
  Pulled pulled;
  pulled.v_a_G = v_a_G;
  pulled.v_b_G = v_b_G;
  const Eigen::Vector3d a = (j == 0 ? step.p_GF : nodes[j - 1].p_G) + ahead_s * v_a_G;
  const Eigen::Vector3d b = node.p_G + ahead_s * v_b_G;
  const auto Part = [&](const Eigen::Vector3d& way, const Eigen::Vector3d& rate, bool is_near,
                        const Eigen::Vector3d& straight) {
    Pulled::Part part;
    if (is_near) {
      part.dir = straight;
      part.length_m = straight.dot(way);
      part.per_m = 1.0 / kNearEdge_m;
      part.off = part.per_m * (way - part.length_m * straight);
    } else {
      const double length = std::max(kNothing_m, way.norm());
      part.dir = way / length;
      part.length_m = length;
      part.per_m = 1.0 / std::max(kShortest_m, length);
    }
    part.rate_m_s = part.dir.dot(rate);
    return part;
  };
  const Eigen::Vector3d first = span.first_G + ahead_s * span.v_first_G;
  const Eigen::Vector3d last = span.last_G + ahead_s * span.v_last_G;
  pulled.a = Part(first - a, span.v_first_G - v_a_G, span.a_is_near, span.a_straight_G);
  pulled.b = Part(last - b, span.v_last_G - v_b_G, span.b_is_near, span.b_straight_G);
  pulled.length_m = pulled.a.length_m + node.bend.way.between_m + pulled.b.length_m;
  return pulled;
}

}  // namespace

void FindSolidEdges(const CableStep& step, const std::vector<CableNode>& nodes, int j,
                    CableSpan& span) {
  const auto Line = [&](int from, const Eigen::Vector3d& to) -> Eigen::Vector3d {
    return (to - (from < 0 ? step.p_GF : nodes[from].p_G)).normalized();
  };
  if (j > 0) {
    span.a_is_near = (span.first_G - nodes[j - 1].p_G).squaredNorm() < kNearEdge_m * kNearEdge_m;
    if (span.a_is_near) span.a_straight_G = Line(j - 2, span.first_G);
  }
  if (j + 1 < static_cast<int>(nodes.size())) {
    span.b_is_near = (span.last_G - nodes[j].p_G).squaredNorm() < kNearEdge_m * kNearEdge_m;
    if (span.b_is_near) span.b_straight_G = Line(j + 1, span.last_G);
  }
  const Pulled pulled = PartsOf(step, nodes, j, span, 0.0, nodes[j].v_G, nodes[j].v_G);
  const double turn = std::acos(std::clamp(-pulled.a.dir.dot(pulled.b.dir), -1.0, 1.0));
  const double ratio = std::exp(span.friction * turn);
  span.most_ratio = (ratio - 1.0) / (ratio + 1.0);
}

// Spring and damper of a segment in one: k (L' - l) + c (L' - L) / h is a spring of k + c / h from
// a length between l and L. The damper works where the segment is taut, and pulls or gives at most
// as much as the spring pulls.
void Stiffen(const CableStep& step, const CableModel& model, double damping_n_s,
             const std::vector<CableNode>& nodes, int j, CableSpan& span) {
  const double h = step.step_s;
  const CableNode& node = nodes[j];
  const Eigen::Vector3d& v_a = j == 0 ? step.v_GF_G : nodes[j - 1].v_G;
  const Eigen::Vector3d way = node.p_G - (j == 0 ? step.p_GF : nodes[j - 1].p_G);
  double length = way.norm(), rate = 0.0;
  if (node.bend.body != kCableFree) {
    const Pulled pulled = PartsOf(step, nodes, j, span, 0.0, v_a, node.v_G);
    length = pulled.length_m;
    rate = pulled.a.rate_m_s + pulled.b.rate_m_s;
  } else if (length > kNothing_m) {
    rate = way.dot(node.v_G - v_a) / length;
  }
  const double relaxed = std::max(kShortest_m, node.rest_m + (j == 0 ? model.inside_m : 0.0));
  const double fed_m = j == 0 ? step.fed_m : 0.0;
  const double k = model.axial_stiffness_n / relaxed, stretch = length - node.rest_m;
  span.stiffness_n_per_m = k;
  span.slack_m = node.rest_m;
  if (stretch <= 0.0) return;
  const double change = h * rate - fed_m;
  double c = damping_n_s / relaxed;
  if (c * std::abs(change) > h * k * stretch) c = h * k * stretch / std::abs(change);
  span.stiffness_n_per_m = k + c / h;
  span.slack_m = (k * node.rest_m + c / h * (length + fed_m)) / span.stiffness_n_per_m;
}

void PullStraight(const CableStep& step, const std::vector<CableNode>& nodes,
                  const std::vector<Eigen::Vector3d>& speed, int j, CableSpan& span) {
  const double h = step.step_s;
  const Eigen::Vector3d& v_a = j == 0 ? step.v_GF_G : speed[j - 1];
  const Eigen::Vector3d& a = j == 0 ? step.p_GF : nodes[j - 1].p_G;
  const Eigen::Vector3d way = nodes[j].p_G - a + h * (speed[j] - v_a);
  const double square = way.squaredNorm();
  span.tension_n = 0.0;
  if (square <= span.slack_m * span.slack_m) return;
  const double length = std::max(kNothing_m, std::sqrt(square));
  span.tension_n = span.stiffness_n_per_m * (length - span.slack_m);
  span.dir_G = way / length;
  span.across = h * span.tension_n / std::max(kShortest_m, length);
  span.along = h * span.stiffness_n_per_m - span.across;
}

void PullRound(const CableStep& step, const std::vector<CableNode>& nodes,
               const std::vector<Eigen::Vector3d>& speed, int j, CableSpan& span) {
  const double h = step.step_s;
  const CableNode& node = nodes[j];
  Pulled pulled = PartsOf(step, nodes, j, span, h, j == 0 ? step.v_GF_G : speed[j - 1], speed[j]);
  const double stretch = pulled.length_m - span.slack_m;
  span.tension_n = 0.0;
  span.slid_m = span.swept_m = 0.0;
  if (stretch <= 0.0) return;
  pulled.tension = {span.stiffness_n_per_m * stretch, h * span.stiffness_n_per_m};
  span.tension_n = pulled.tension.n;
  PullBent(pulled, h, node.bend, span);
}

void Press(double h, const Eigen::Vector3d& v_G, CableTouch& touch) {
  const Eigen::Vector3d& n = touch.normal_G;
  const Eigen::Vector3d v = v_G - touch.v_body_G;
  const double in = -(touch.gap_m + h * v.dot(n));
  touch.force_G.setZero();
  touch.resistance.setZero();
  touch.press_n = 0.0;
  if (in <= 0.0) return;
  const double stiffness = std::min(touch.stiffness_n_per_m, touch.most_n / in);
  touch.press_n = stiffness * in;
  const Eigen::Vector3d tried = touch.bend_G + h * (v - v.dot(n) * n);
  const double held = kCableBristle_n_per_m *
                      Held(touch.friction * touch.press_n, tried.norm(), kCableBristle_n_per_m);
  touch.held = held / kCableBristle_n_per_m;
  touch.force_G = touch.press_n * n - held * tried;
  touch.resistance = h * (stiffness - held) * n * n.transpose();
  touch.resistance.diagonal().array() += h * held;
}

}  // namespace dockyard
