// One implicit step of a cable: M (v' - v) = h (F(x + h v', v') + M g), by Newton's method.
#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/cable/cable.h"
#include "sim/rigid/symmetric3.h"

namespace dockyard {
namespace {

constexpr int kMostIterations = 8;
// Solved when no mass changes its speed by more [m/s]: 1e-8 m of a step.
constexpr double kSolvedMPerS = 1e-5;
constexpr double kSmoothlySolvedMPerS = 5e-3;
// Air and the cord's own friction take this share of its masses' speeds per second: 4 % of critical
// at 1 Hz (assumed, range 0.1-2).
constexpr double kSwingDampingPerS = 0.5;
// Friction's share of the bristle's stiffness is found to this.
constexpr double kSameHold = 0.01;
constexpr double kShortestM = 1e-3, kNothingM = 1e-9;

}  // namespace

CablePull FixedCableEnd::Try(const Eigen::Vector3d& p_G, const Eigen::Vector3d& v_G,
                             double step_s) const {
  const Eigen::Vector3d way = p_GE_ - p_G - step_s * v_G;
  const double length = std::max(kNothingM, way.norm()), relaxed = std::max(kShortestM, rest_m_);
  const Eigen::Vector3d dir = way / length;
  const double stiffness = cable_.axial_stiffness_n / relaxed;
  const double pull_n = stiffness * std::max(0.0, length - rest_m_);
  const Eigen::Matrix3d along = dir * dir.transpose();
  CablePull pull{pull_n * dir, step_s * pull_n / length * (Eigen::Matrix3d::Identity() - along)};
  if (pull_n > 0.0) pull.resistance += step_s * stiffness * along;
  return pull;
}

void Cable::AddStraight(const Span& span, double h, std::size_t j) {
  const Eigen::Vector3d& d = span.dir_G;
  const Eigen::Vector3d pull = h * span.tension_n * d, along = h * span.along * d;
  Eigen::Matrix3d own;
  for (int k = 0; k < 3; ++k) own.col(k) = d[k] * along;
  for (int k = 0; k < 3; ++k) own(k, k) += h * span.across;
  right_[j] -= pull;
  diagonal_[j] += own;
  if (j == 0) return;
  right_[j - 1] += pull;
  diagonal_[j - 1] += own;
  upper_[j - 1] = -own;
}

void Cable::AddRound(const Span& span, double h, std::size_t j) {
  right_[j] += h * span.on_b_G;
  diagonal_[j] += h * span.bb;
  if (j == 0) return;
  right_[j - 1] += h * span.on_a_G;
  diagonal_[j - 1] += h * span.aa;
  upper_[j - 1] = h * span.ab;
}

void Cable::Assemble(const CableStep& step) {
  const double h = step.step_s;
  const std::size_t count = nodes_.size();
  for (std::size_t i = 0; i < count; ++i) {
    right_[i] = mass_kg_[i] *
                (nodes_[i].v_G - speed_[i] + h * (step.gravity_G - kSwingDampingPerS * speed_[i]));
    diagonal_[i].setZero();
    diagonal_[i].diagonal().setConstant(mass_kg_[i] * (1.0 + h * kSwingDampingPerS));
  }
  for (std::size_t j = 0; j < count; ++j) {
    const bool bent = nodes_[j].bend.body != kNone;
    if (bent) {
      PullRound(step, static_cast<int>(j));
    } else {
      PullStraight(step, static_cast<int>(j));
    }
    const Span& span = spans_[j];
    if (j > 0) linked_[j - 1] = span.tension_n > 0.0;
    if (span.tension_n <= 0.0) continue;
    if (bent) {
      AddRound(span, h, j);
    } else {
      AddStraight(span, h, j);
    }
  }
  for (Touch& touch : touches_) {
    AssembleTouch(step, touch);
    if (touch.press_n <= 0.0) continue;
    right_[touch.node] += h * touch.force_G;
    diagonal_[touch.node] += h * touch.resistance;
  }
  const Node& last = nodes_.back();
  end_pull_ = step.end->Try(last.p_G, speed_.back(), h);
  right_[count - 1] += h * end_pull_.force_G;
  diagonal_[count - 1] += h * end_pull_.resistance;
}

// Gauss' elimination of the block tridiagonal equations; returns the largest change of speed.
double Cable::Solve() {
  const std::size_t count = nodes_.size();
  for (std::size_t i = 0; i < count; ++i) {
    Symmetric s = SymmetricOf(diagonal_[i]);
    if (i > 0 && linked_[i - 1]) {
      TakeProduct(upper_[i - 1], solved_[i - 1], s);
      right_[i].noalias() -= upper_[i - 1].transpose() * change_[i - 1];
    }
    const Symmetric inverse = InverseOf(s);
    change_[i] = Product(inverse, right_[i]);
    if (i + 1 == count || !linked_[i]) continue;
    for (int k = 0; k < 3; ++k) solved_[i].col(k) = Product(inverse, upper_[i].col(k));
  }
  double most = 0.0;
  for (std::size_t i = count; i-- > 0;) {
    if (i + 1 < count && linked_[i]) change_[i].noalias() -= solved_[i] * change_[i + 1];
    speed_[i] += change_[i];
    most = std::max(most, change_[i].squaredNorm());
  }
  return std::sqrt(most);
}

// Whether the speeds found leave taut what was taut, slack what was slack, and pressed and sliding
// what was: then the equations were smooth, and one step of Newton's method leaves (h change)^2 / 2
// L of a segment's length, 1e-10 m.
bool Cable::IsSettled(const CableStep& step) const {
  const double h = step.step_s;
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    const Span& span = spans_[j];
    const Eigen::Vector3d& v_a = j == 0 ? step.v_GF_G : speed_[j - 1];
    const Eigen::Vector3d& a = j == 0 ? step.p_GF : nodes_[j - 1].p_G;
    if (nodes_[j].bend.body != kNone && span.tension_n > 0.0) return false;
    const double square = (nodes_[j].p_G - a + h * (speed_[j] - v_a)).squaredNorm();
    if ((square > span.slack_m * span.slack_m) != (span.tension_n > 0.0)) return false;
  }
  for (const Touch& touch : touches_) {
    const Eigen::Vector3d v = speed_[touch.node] - touch.v_body_G;
    const double along = v.dot(touch.normal_G), in = -(touch.gap_m + h * along);
    if ((in > 0.0) != (touch.press_n > 0.0)) return false;
    if (touch.press_n <= 0.0) continue;
    const double bend = (touch.bend_G + h * (v - along * touch.normal_G)).norm();
    const double most = touch.friction * std::min(touch.stiffness_n_per_m * in, touch.most_n);
    const double held = bend * kBristleNPerM > most ? most / (bend * kBristleNPerM) : 1.0;
    if (std::abs(held - touch.held) > kSameHold * touch.held) return false;
  }
  return true;
}

// The forces that the speeds found belong to: those tried, less what the last change took.
void Cable::ReadForces(const CableStep& step) {
  loads_.clear();
  of_ground_G_.setZero();
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  on_fed_end_G_.setZero();
  for (std::size_t j = 0; j < nodes_.size(); ++j) {
    const Span& span = spans_[j];
    const Bend& bend = nodes_[j].bend;
    if ((j > 0 && bend.body == kNone) || span.tension_n <= 0.0) continue;
    const Eigen::Vector3d& d_a = j == 0 ? none : change_[j - 1];
    const Eigen::Vector3d& d_b = change_[j];
    if (bend.body == kNone) {
      on_fed_end_G_ = span.tension_n * span.dir_G + span.along * span.dir_G.dot(d_b) * span.dir_G +
                      span.across * d_b;
      continue;
    }
    const Eigen::Vector3d on_a = span.on_a_G - span.aa * d_a - span.ab * d_b;
    const Eigen::Vector3d on_b = span.on_b_G - span.ab.transpose() * d_a - span.bb * d_b;
    if (j == 0) on_fed_end_G_ = on_a;
    loads_.push_back({bend.body, span.first_G, -on_a});
    loads_.push_back({bend.body, span.last_G, -on_b});
  }
  // Half of the first segment's mass hangs on the fed end itself.
  on_fed_end_n_ = on_fed_end_G_.norm();
  on_fed_end_G_ += 0.5 * model_.mass_kg_per_m * nodes_[0].rest_m * step.gravity_G;
  for (Touch& touch : touches_) {
    if (touch.press_n <= 0.0) continue;
    const Eigen::Vector3d force = touch.force_G - touch.resistance * change_[touch.node];
    if (touch.body == kGround) {
      of_ground_G_ += force;
    } else {
      loads_.push_back({touch.body, nodes_[touch.node].p_G, -force});
    }
    const Eigen::Vector3d& n = touch.normal_G;
    const Eigen::Vector3d v = speed_[touch.node] - touch.v_body_G;
    touch.bend_G = touch.held * (touch.bend_G + step.step_s * (v - v.dot(n) * n));
  }
  of_air_G_.setZero();
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    of_air_G_ -= kSwingDampingPerS * mass_kg_[i] * speed_[i];
  }
  of_end_G_ = end_pull_.force_G - end_pull_.resistance * change_.back();
}

void Cable::Step(const CableStep& step) {
  DOCKYARD_CHECK(!nodes_.empty() && step.end != nullptr);
  Feed(step);
  FindNearBodies(step);
  FindBends(step);
  FindTouches(step);
  const std::size_t count = nodes_.size();
  mass_kg_.resize(count);
  speed_.resize(count);
  right_.resize(count);
  change_.resize(count);
  diagonal_.resize(count);
  upper_.resize(count);
  solved_.resize(count);
  linked_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double after =
        i + 1 < count ? nodes_[i + 1].rest_m : std::min(step.end_rest_m, model_.spacing_m);
    mass_kg_[i] = 0.5 * model_.mass_kg_per_m * (nodes_[i].rest_m + after);
    speed_[i] = nodes_[i].v_G;
  }
  damping_n_s_ = model_.damping_ns_per_m * (rest_m() + step.end_rest_m + model_.inside_m);
  for (int j = 0; j < masses(); ++j) {
    if (nodes_[j].bend.body != kNone) LookForEdges(step, j);
    Stiffen(step, j);
  }
  iterations_ = 0;
  bool solved = false;
  while (!solved && iterations_ < kMostIterations) {
    Assemble(step);
    const double change = Solve();
    ++iterations_;
    solved = change < kSolvedMPerS || (change < kSmoothlySolvedMPerS && IsSettled(step));
  }
  ReadForces(step);
  Move(step);
}

}  // namespace dockyard
