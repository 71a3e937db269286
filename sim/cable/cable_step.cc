// One implicit step of a cable: M (v' - v) = h (F(x + h v', v') + M g), by Newton's method.
#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/cable/cable.h"
#include "sim/cable/cable_bends.h"
#include "sim/cable/cable_forces.h"
#include "sim/rigid/symmetric3.h"

namespace dockyard {
namespace {

constexpr int kMostIterations = 8;
// Solved when no mass changes its speed by more [m/s]: 1e-8 m of a step.
constexpr double kSolved_m_s = 1e-5;
constexpr double kSmoothlySolved_m_s = 5e-3;
// Air and the cord's own friction take this share of its masses' speeds per second: 4 % of critical
// at 1 Hz (assumed, range 0.1-2).
constexpr double kSwingDamping_per_s = 0.5;
// Friction's share of the bristle's stiffness is found to this.
constexpr double kSameHold = 0.01;
constexpr double kShortest_m = 1e-3, kNothing_m = 1e-9;

void AddStraight(const CableSpan& span, double h, std::size_t j, CableEquations& e) {
  const Eigen::Vector3d& d = span.dir_G;
  const Eigen::Vector3d pull = h * span.tension_n * d, along = h * span.along * d;
  Eigen::Matrix3d own;
  for (int k = 0; k < 3; ++k) own.col(k) = d[k] * along;
  for (int k = 0; k < 3; ++k) own(k, k) += h * span.across;
  e.right[j] -= pull;
  e.diagonal[j] += own;
  if (j == 0) return;
  e.right[j - 1] += pull;
  e.diagonal[j - 1] += own;
  e.upper[j - 1] = -own;
}

void AddRound(const CableSpan& span, double h, std::size_t j, CableEquations& e) {
  e.right[j] += h * span.on_b_G;
  e.diagonal[j] += h * span.bb;
  if (j == 0) return;
  e.right[j - 1] += h * span.on_a_G;
  e.diagonal[j - 1] += h * span.aa;
  e.upper[j - 1] = h * span.ab;
}

// Gauss' elimination of the block tridiagonal equations; returns the largest change of speed.
double Solve(CableEquations& e) {
  const std::size_t count = e.speed.size();
  for (std::size_t i = 0; i < count; ++i) {
    Symmetric s = SymmetricOf(e.diagonal[i]);
    if (i > 0 && e.linked[i - 1]) {
      TakeProduct(e.upper[i - 1], e.solved[i - 1], s);
      e.right[i].noalias() -= e.upper[i - 1].transpose() * e.change[i - 1];
    }
    const Symmetric inverse = InverseOf(s);
    e.change[i] = Product(inverse, e.right[i]);
    if (i + 1 == count || !e.linked[i]) continue;
    for (int k = 0; k < 3; ++k) e.solved[i].col(k) = Product(inverse, e.upper[i].col(k));
  }
  double most = 0.0;
  for (std::size_t i = count; i-- > 0;) {
    if (i + 1 < count && e.linked[i]) e.change[i].noalias() -= e.solved[i] * e.change[i + 1];
    e.speed[i] += e.change[i];
    most = std::max(most, e.change[i].squaredNorm());
  }
  return std::sqrt(most);
}

void Resize(std::size_t masses, CableEquations& e) {
  e.mass_kg.resize(masses);
  e.speed.resize(masses);
  e.right.resize(masses);
  e.change.resize(masses);
  e.diagonal.resize(masses);
  e.upper.resize(masses);
  e.solved.resize(masses);
  e.linked.resize(masses);
}

}  // namespace

CablePull FixedCableEnd::Try(const Eigen::Vector3d& p_G, const Eigen::Vector3d& v_G,
                             double step_s) const {
  const Eigen::Vector3d way = p_GE_ - p_G - step_s * v_G;
  const double length = std::max(kNothing_m, way.norm()), relaxed = std::max(kShortest_m, rest_m_);
  const Eigen::Vector3d dir = way / length;
  const double stiffness = cable_.axial_stiffness_n / relaxed;
  const double pull_n = stiffness * std::max(0.0, length - rest_m_);
  const Eigen::Matrix3d along = dir * dir.transpose();
  CablePull pull{pull_n * dir, step_s * pull_n / length * (Eigen::Matrix3d::Identity() - along)};
  if (pull_n > 0.0) pull.resistance += step_s * stiffness * along;
  return pull;
}

void Cable::Assemble(const CableStep& step) {
  CableEquations& e = equations_;
  const double h = step.step_s;
  const std::size_t count = nodes_.size();
  for (std::size_t i = 0; i < count; ++i) {
    e.right[i] = e.mass_kg[i] * (nodes_[i].v_G - e.speed[i] +
                                 h * (step.gravity_G - kSwingDamping_per_s * e.speed[i]));
    e.diagonal[i].setZero();
    e.diagonal[i].diagonal().setConstant(e.mass_kg[i] * (1.0 + h * kSwingDamping_per_s));
  }
  for (std::size_t j = 0; j < count; ++j) {
    const bool bent = nodes_[j].bend.body != kCableFree;
    CableSpan& span = spans_[j];
    if (bent) {
      PullRound(step, nodes_, e.speed, static_cast<int>(j), span);
    } else {
      PullStraight(step, nodes_, e.speed, static_cast<int>(j), span);
    }
    if (j > 0) e.linked[j - 1] = span.tension_n > 0.0;
    if (span.tension_n <= 0.0) continue;
    if (bent) {
      AddRound(span, h, j, e);
    } else {
      AddStraight(span, h, j, e);
    }
  }
  for (CableTouch& touch : touches_) {
    Press(h, e.speed[touch.node], touch);
    if (touch.press_n <= 0.0) continue;
    e.right[touch.node] += h * touch.force_G;
    e.diagonal[touch.node] += h * touch.resistance;
  }
  const CableNode& last = nodes_.back();
  end_pull_ = step.end->Try(last.p_G, e.speed.back(), h);
  e.right[count - 1] += h * end_pull_.force_G;
  e.diagonal[count - 1] += h * end_pull_.resistance;
}

// Whether the speeds found leave taut what was taut, slack what was slack, and pressed and sliding
// what was: then the equations were smooth, and one step of Newton's method leaves (h change)^2 / 2
// L of a segment's length, 1e-10 m.
bool Cable::IsSettled(const CableStep& step) const {
  const double h = step.step_s;
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    const CableSpan& span = spans_[j];
    const Eigen::Vector3d& v_a = j == 0 ? step.v_GF_G : equations_.speed[j - 1];
    const Eigen::Vector3d& a = j == 0 ? step.p_GF : nodes_[j - 1].p_G;
    if (nodes_[j].bend.body != kCableFree && span.tension_n > 0.0) return false;
    const double square = (nodes_[j].p_G - a + h * (equations_.speed[j] - v_a)).squaredNorm();
    if ((square > span.slack_m * span.slack_m) != (span.tension_n > 0.0)) return false;
  }
  for (const CableTouch& touch : touches_) {
    const Eigen::Vector3d v = equations_.speed[touch.node] - touch.v_body_G;
    const double along = v.dot(touch.normal_G), in = -(touch.gap_m + h * along);
    if ((in > 0.0) != (touch.press_n > 0.0)) return false;
    if (touch.press_n <= 0.0) continue;
    const double bend = (touch.bend_G + h * (v - along * touch.normal_G)).norm();
    const double most = touch.friction * std::min(touch.stiffness_n_per_m * in, touch.most_n);
    const double held =
        bend * kCableBristle_n_per_m > most ? most / (bend * kCableBristle_n_per_m) : 1.0;
    if (std::abs(held - touch.held) > kSameHold * touch.held) return false;
  }
  return true;
}

// The forces that the speeds found belong to: those tried, less what the last change took.
void Cable::ReadForces(const CableStep& step) {
  forces_.loads.clear();
  forces_.of_ground_G.setZero();
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  forces_.on_fed_end_G.setZero();
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    const CableSpan& span = spans_[j];
    const CableBend& bend = nodes_[j].bend;
    if ((j > 0 && bend.body == kCableFree) || span.tension_n <= 0.0) continue;
    const Eigen::Vector3d& d_a = j == 0 ? none : equations_.change[j - 1];
    const Eigen::Vector3d& d_b = equations_.change[j];
    if (bend.body == kCableFree) {
      forces_.on_fed_end_G = span.tension_n * span.dir_G +
                             span.along * span.dir_G.dot(d_b) * span.dir_G + span.across * d_b;
      continue;
    }
    const Eigen::Vector3d on_a = span.on_a_G - span.aa * d_a - span.ab * d_b;
    const Eigen::Vector3d on_b = span.on_b_G - span.ab.transpose() * d_a - span.bb * d_b;
    if (j == 0) forces_.on_fed_end_G = on_a;
    forces_.loads.push_back({bend.body, span.first_G, -on_a});
    forces_.loads.push_back({bend.body, span.last_G, -on_b});
  }
  // Half of the first segment's mass hangs on the fed end itself.
  forces_.on_fed_end_n = forces_.on_fed_end_G.norm();
  forces_.on_fed_end_G += 0.5 * model_.mass_kg_per_m * nodes_[0].rest_m * step.gravity_G;
  for (CableTouch& touch : touches_) {
    if (touch.press_n <= 0.0) continue;
    const Eigen::Vector3d force = touch.force_G - touch.resistance * equations_.change[touch.node];
    if (touch.body == kCableOnGround) {
      forces_.of_ground_G += force;
    } else {
      forces_.loads.push_back({touch.body, nodes_[touch.node].p_G, -force});
    }
    const Eigen::Vector3d& n = touch.normal_G;
    const Eigen::Vector3d v = equations_.speed[touch.node] - touch.v_body_G;
    touch.bend_G = touch.held * (touch.bend_G + step.step_s * (v - v.dot(n) * n));
  }
  forces_.of_air_G.setZero();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    forces_.of_air_G -= kSwingDamping_per_s * equations_.mass_kg[i] * equations_.speed[i];
  }
  forces_.of_end_G = end_pull_.force_G - end_pull_.resistance * equations_.change.back();
}

void Cable::Step(const CableStep& step) {
  DOCKYARD_CHECK(!nodes_.empty() && step.end != nullptr);
  Feed(step);
  FindNearBodies(step, model_, nodes_, near_);
  FindBends(step, model_, near_, nodes_, spans_);
  FindTouches(step, model_, nodes_, near_, deepest_m, touches_);
  const std::size_t count = nodes_.size();
  Resize(count, equations_);
  for (std::size_t i = 0; i < count; ++i) {
    const double after =
        i + 1 < count ? nodes_[i + 1].rest_m : std::min(step.end_rest_m, model_.spacing_m);
    equations_.mass_kg[i] = 0.5 * model_.mass_kg_per_m * (nodes_[i].rest_m + after);
    equations_.speed[i] = nodes_[i].v_G;
  }
  const double damping_n_s =
      model_.damping_ns_per_m * (rest_m() + step.end_rest_m + model_.inside_m);
  for (int j = 0; j < masses(); ++j) {
    if (nodes_[j].bend.body != kCableFree) FindSolidEdges(step, nodes_, j, spans_[j]);
    Stiffen(step, model_, damping_n_s, nodes_, j, spans_[j]);
  }
  bool solved = false;
  for (int i = 0; !solved && i < kMostIterations; ++i) {
    Assemble(step);
    const double change = Solve(equations_);
    solved = change < kSolved_m_s || (change < kSmoothlySolved_m_s && IsSettled(step));
  }
  ReadForces(step);
  Move(step);
}

}  // namespace dockyard
