#include "sim/cable/cable.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"

namespace dockyard {
namespace {

// The segment at the fed end is divided when longer than this share of the spacing, and joined with
// its neighbour when shorter than that one.
constexpr double kDivide = 1.5, kJoin = 0.5;

}  // namespace

void Cable::LayOut(const Eigen::Vector3d& p_GF, const Eigen::Vector3d& p_GE, int masses) {
  DOCKYARD_CHECK(masses > 0);
  nodes_.assign(static_cast<std::size_t>(masses), CableNode{});
  for (int i = 0; i < masses; ++i) {
    nodes_[i].p_G = p_GF + (i + 1.0) / masses * (p_GE - p_GF);
    nodes_[i].rest_m = (p_GE - p_GF).norm() / masses;
  }
}

double Cable::rest_m() const {
  double sum = 0.0;
  for (const CableNode& node : nodes_) sum += node.rest_m;
  return sum;
}

double Cable::length_m(const Eigen::Vector3d& p_GF) const {
  double sum = 0.0;
  const Eigen::Vector3d* last = &p_GF;
  for (const CableNode& node : nodes_) {
    sum += node.bend.body == kCableFree ? (node.p_G - *last).norm() : node.bend.way.length_m;
    last = &node.p_G;
  }
  return sum;
}

double Cable::fastest_m_s() const {
  double most = 0.0;
  for (const CableNode& node : nodes_) most = std::max(most, node.v_G.squaredNorm());
  return std::sqrt(most);
}

Eigen::Vector3d Cable::momentum_G() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < std::min(nodes_.size(), equations_.mass_kg.size()); ++i) {
    sum += equations_.mass_kg[i] * nodes_[i].v_G;
  }
  return sum;
}

void Cable::Calm() {
  for (CableNode& node : nodes_) node.v_G.setZero();
}

double Cable::DropLast() {
  const double rest = nodes_.back().rest_m;
  nodes_.pop_back();
  return rest;
}

void Cable::AddLast(const Eigen::Vector3d& p_G, const Eigen::Vector3d& v_G, double rest_m) {
  CableNode& node = nodes_.emplace_back();
  node.p_G = p_G;
  node.v_G = v_G;
  node.rest_m = rest_m;
}

void Cable::Feed(const CableStep& step) {
  nodes_.front().rest_m += step.fed_m;
  while (nodes_.front().rest_m < kJoin * model_.spacing_m && nodes_.size() > 1) {
    nodes_[1].rest_m += nodes_[0].rest_m;
    if (nodes_[1].bend.body == kCableFree) nodes_[1].bend = nodes_[0].bend;
    nodes_.erase(nodes_.begin());
  }
  CableNode& first = nodes_.front();
  const bool bends = first.bend.body != kCableFree;
  if (first.rest_m < (bends ? 2.0 * kDivide : kDivide) * model_.spacing_m) return;
  // The new mass lies where both parts have the whole's strain, so the tension stays.
  const Eigen::Vector3d back = step.p_GF - first.p_G;
  const double length = back.norm(), rest = model_.spacing_m;
  const double strain = (length - first.rest_m) / (first.rest_m + model_.inside_m);
  const double share =
      strain > 0.0 && !bends ? rest * (1.0 + strain) / length : rest / first.rest_m;
  CableNode born;
  born.p_G = first.p_G + share * back;
  born.v_G = first.v_G + share * (step.v_GF_G - first.v_G);
  born.rest_m = first.rest_m - rest;
  born.bend = first.bend;
  first.rest_m = rest;
  nodes_.insert(nodes_.begin(), born);
}

void Cable::Move(const CableStep& step) {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    nodes_[i].v_G = equations_.speed[i];
    nodes_[i].p_G += step.step_s * equations_.speed[i];
    nodes_[i].tension_n = spans_[i].tension_n;
    nodes_[i].bend.slid_m = spans_[i].slid_m;
    nodes_[i].bend.swept_m = spans_[i].swept_m;
    nodes_[i].grips.fill(CableGrip{});
  }
  for (const CableTouch& touch : touches_) {
    if (touch.press_n <= 0.0) continue;
    for (CableGrip& grip : nodes_[touch.node].grips) {
      if (grip.body != kCableFree) continue;
      grip = {touch.body, touch.bend_G};
      break;
    }
  }
}

double Cable::Energy(const Eigen::Vector3d& gravity_G, const Eigen::Vector3d& p_GF) const {
  double energy = 0.0;
  const Eigen::Vector3d* last = &p_GF;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const CableNode& node = nodes_[i];
    const double after = i + 1 < nodes_.size() ? nodes_[i + 1].rest_m : 0.0;
    const double mass = 0.5 * model_.mass_kg_per_m * (node.rest_m + after);
    const double inside = i == 0 ? model_.inside_m : 0.0;
    const double length =
        node.bend.body == kCableFree ? (node.p_G - *last).norm() : node.bend.way.length_m;
    const double stretch = std::max(0.0, length - node.rest_m);
    energy += 0.5 * mass * node.v_G.squaredNorm() - mass * gravity_G.dot(node.p_G) +
              0.5 * model_.axial_stiffness_n / (node.rest_m + inside) * stretch * stretch;
    last = &node.p_G;
  }
  return energy;
}

std::vector<Eigen::Vector3d> Cable::Line(const Eigen::Vector3d& p_GF,
                                         const std::vector<CableBody>& bodies) const {
  std::vector<Eigen::Vector3d> line{p_GF};
  for (const CableNode& node : nodes_) {
    if (node.bend.body != kCableFree) {
      const Pose3& X_GB = bodies[node.bend.body].motion.X_GL;
      line.push_back(X_GB * node.bend.way.first_B);
      if (node.bend.way.between_m > 0.0) line.push_back(X_GB * node.bend.way.last_B);
    }
    line.push_back(node.p_G);
  }
  return line;
}

std::uint64_t Cable::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashBits(seed, nodes_.size());
  for (const CableNode& node : nodes_) {
    for (int i = 0; i < 3; ++i) {
      hash = HashDouble(HashDouble(hash, node.p_G[i]), node.v_G[i]);
      for (const CableGrip& grip : node.grips) hash = HashDouble(hash, grip.bend_G[i]);
    }
    hash = HashDouble(HashDouble(hash, node.rest_m), node.bend.slid_m + node.bend.swept_m);
  }
  return hash;
}

}  // namespace dockyard
