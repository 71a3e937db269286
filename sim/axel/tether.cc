#include "sim/axel/tether.h"

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "sim/base/hash.h"

namespace dockyard::axel {
namespace {

// A piece always counts as at least this long, so that its stiffness stays finite.
constexpr double kShortestPiece_m = 1e-3;
// Tensions on both sides of a bend settle to this share within one step.
constexpr double kSlideTolerance = 1e-9;
constexpr int kSlideSweeps = 40;

Eigen::Vector2d InPlane(const Eigen::Vector3d& p_M) {
  return {p_M.x(), std::hypot(p_M.y(), p_M.z())};
}

}  // namespace

Tether::Tether(const TetherModel& tether, const StationModel& station, double inside_arm_m)
    : tether_(tether),
      cone_(station.cone),
      anchor_depth_m_(station.anchor_depth_m),
      inside_arm_m_(inside_arm_m) {
  DOCKYARD_CHECK(tether.axial_stiffness_n > 0.0 && inside_arm_m > 0.0);
}

double Tether::free_m() const {
  double sum = 0.0;
  for (int i = 0; i < path_.pieces; ++i) sum += free_[i];
  return sum;
}

void Tether::LayOut(const Eigen::Vector3d& p_MT, double free_m) {
  path_ = FindTetherPath(cone_, anchor_depth_m_, InPlane(p_MT));
  const double total = path_.total_m();
  for (int i = 0; i < path_.pieces; ++i) free_[i] = free_m * path_.length_m[i] / total;
}

void Tether::BeginAt(const Eigen::Vector3d& p_MT, double shorter_m, double inside_m,
                     double damping_ns_per_m) {
  free_[0] -= shorter_m;
  inside_arm_m_ = inside_m;
  tether_.damping_ns_per_m = damping_ns_per_m;
  const TetherPath next = FindTetherPath(cone_, anchor_depth_m_, InPlane(p_MT));
  if (next.bent != path_.bent) Rethread(next);
  path_ = next;
}

double Tether::Pull(int piece) const {
  const double relaxed = std::max(kShortestPiece_m, free_[piece] + Inside(piece));
  return tether_.axial_stiffness_n * (path_.length_m[piece] - free_[piece]) / relaxed;
}

Tether::PerPiece Tether::Tensions() const {
  PerPiece tensions{};
  for (int i = 0; i < path_.pieces; ++i) tensions[i] = std::max(0.0, Pull(i));
  return tensions;
}

void Tether::Rethread(const TetherPath& next) {
  // Lift off the edges that are left: their two pieces become one.
  PerPiece merged{};
  int old_piece = 0, merged_piece = 0;
  merged[0] = free_[0];
  for (int bend = 0; bend < kBendCount; ++bend) {
    if (!path_.bent[bend]) continue;
    ++old_piece;
    if (next.bent[bend]) {
      merged[++merged_piece] = free_[old_piece];
    } else {
      merged[merged_piece] += free_[old_piece];
    }
  }
  // Lay over the new edges: the pieces of one share its strain.
  PerPiece laid{};
  int first = 0;
  merged_piece = 0;
  int piece = 0;
  const auto Share = [&](int last) {
    double way = 0.0;
    for (int i = first; i <= last; ++i) way += next.length_m[i];
    const double inside = Inside(first);
    const double strain = (way - merged[merged_piece]) / (merged[merged_piece] + inside);
    for (int i = first; i <= last; ++i) {
      laid[i] = (next.length_m[i] - strain * Inside(i)) / (1.0 + strain);
    }
    first = last + 1;
    ++merged_piece;
  };
  for (int bend = 0; bend < kBendCount; ++bend) {
    if (!next.bent[bend]) continue;
    if (path_.bent[bend]) Share(piece);
    ++piece;
  }
  Share(piece);
  free_ = laid;
}

void Tether::SlideOverBends() {
  for (int sweep = 0; sweep < kSlideSweeps; ++sweep) {
    bool slid = false;
    for (int bend = 0; bend + 1 < path_.pieces; ++bend) {
      const double ratio = std::exp(tether_.friction_on_station * path_.turn_rad[bend]);
      const double out = std::max(0.0, Pull(bend)), in = std::max(0.0, Pull(bend + 1));
      const bool outwards = out > ratio * in * (1.0 + kSlideTolerance);
      const bool inwards = in > ratio * out * (1.0 + kSlideTolerance);
      if (!outwards && !inwards) continue;
      slid = true;
      const int to = outwards ? bend : bend + 1, from = outwards ? bend + 1 : bend;
      // Newton on the length that slides until the tensions stand at the capstan's ratio.
      for (int newton = 0; newton < 2; ++newton) {
        const double c_to = std::max(kShortestPiece_m, free_[to] + Inside(to));
        const double c_from = std::max(kShortestPiece_m, free_[from] + Inside(from));
        const double gap = Pull(to) - ratio * Pull(from);
        const double slope = tether_.axial_stiffness_n *
                             ((path_.length_m[to] + Inside(to)) / (c_to * c_to) +
                              ratio * (path_.length_m[from] + Inside(from)) / (c_from * c_from));
        const double slide = std::clamp(gap / slope, -0.5 * c_to, 0.5 * c_from);
        free_[to] += slide;
        free_[from] -= slide;
      }
    }
    if (!slid) return;
  }
}

TetherLoad Tether::Step(const Eigen::Vector3d& p_MT, const Eigen::Vector3d& v_MT, double free_m,
                        double free_rate_m_s) {
  const TetherPath next = FindTetherPath(cone_, anchor_depth_m_, InPlane(p_MT));
  if (next.bent != path_.bent) Rethread(next);
  path_ = next;
  free_[0] += free_m - this->free_m();  // what the drum gave since the last step
  SlideOverBends();

  TetherLoad load;
  load.nodes = path_.pieces;
  const double radius = std::hypot(p_MT.y(), p_MT.z());
  Eigen::Vector3d out_M = Eigen::Vector3d::UnitZ();
  if (radius > 0.0) out_M = Eigen::Vector3d(0.0, p_MT.y(), p_MT.z()) / radius;
  const auto Lift = [&](const Eigen::Vector2d& q) {
    return Eigen::Vector3d(q.x() * Eigen::Vector3d::UnitX() + q.y() * out_M);
  };
  PerPiece tension = Tensions();
  std::array<Eigen::Vector3d, kBendCount + 1> along{};
  for (int i = 0; i < path_.pieces; ++i) {
    along[i] = (Lift(path_.nodes[i + 1]) - Lift(path_.nodes[i])) /
               std::max(kShortestPiece_m, path_.length_m[i]);
    load.p_M[i] = Lift(path_.nodes[i + 1]);
  }
  if (tension[0] > 0.0) {
    // Damping of the whole length, at most as large as the elastic tension: never a push.
    const double stretch_rate = -along[0].dot(v_MT) - free_rate_m_s;
    const double damping =
        std::clamp(tether_.damping_ns_per_m * stretch_rate, -tension[0], tension[0]);
    const double factor = 1.0 + damping / tension[0];
    for (double& t : tension) t *= factor;
  }
  load.tension_n = tension[0];
  load.force_on_tip_M = tension[0] * along[0];
  for (int i = 0; i < path_.pieces; ++i) {
    load.force_on_station_M[i] = -tension[i] * along[i];
    if (i + 1 < path_.pieces) load.force_on_station_M[i] += tension[i + 1] * along[i + 1];
  }
  return load;
}

std::uint64_t Tether::StateHash(std::uint64_t seed) const {
  std::uint64_t hash = HashBits(seed, static_cast<std::uint64_t>(path_.pieces));
  for (int i = 0; i < path_.pieces; ++i) hash = HashDouble(hash, free_[i]);
  return hash;
}

}  // namespace dockyard::axel
