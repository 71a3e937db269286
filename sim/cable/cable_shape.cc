#include "sim/cable/cable_shape.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

constexpr int kPieces = 24;
constexpr double kSmallestTension_n = 0.1;  // slacker than this, the excess length gives the sag
// Flatter than this the cosh is lost in rounding and the chord is drawn.
constexpr double kFlattest = 1e5;  // a per span
constexpr int kBisections = 80;

/// Over a level span h, rising by v: lowest point at s0, from the first support.
struct Catenary {
  double a_m = 0.0, s0_m = 0.0;

  Catenary(double a, double h, double v)
      : a_m(a), s0_m(0.5 * h - a * std::asinh(v / (2.0 * a * std::sinh(0.5 * h / a)))) {}
  /// Height above the first support.
  double Height(double s) const {
    // cosh x - cosh y = 2 sinh((x + y) / 2) sinh((x - y) / 2) keeps the digits of a flat curve.
    return 2.0 * a_m * std::sinh((0.5 * s - s0_m) / a_m) * std::sinh(0.5 * s / a_m);
  }
};

/// The a in (low, high) at which a decreasing function falls to the target.
template <class F>
double Solve(double low, double high, double target, const F& falling) {
  for (int i = 0; i < kBisections; ++i) {
    const double middle = std::sqrt(low * high);
    (falling(middle) > target ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

/// Of this length: sqrt(L^2 - v^2) = 2 a sinh(h / 2a).
double OfLength(double length, double h, double v) {
  const double reach = std::sqrt(std::max(0.0, length * length - v * v));
  return Solve(h / 200.0, kFlattest * h, reach,
               [&](double a) { return 2.0 * a * std::sinh(0.5 * h / a); });
}

/// Of this tension over weight at the first support: a cosh(s0 / a), on its flat branch.
double OfTension(double tension_per_weight, double h, double v) {
  // The tension at a is least near a = h / 2.4 (level supports) and grows with a from there.
  return Solve(0.417 * h, kFlattest * h, -tension_per_weight,
               [&](double a) { return -a * std::cosh(Catenary(a, h, v).s0_m / a); });
}

}  // namespace

std::vector<Eigen::Vector3d> HangingTether(const TetherModel& tether, const HeightGrid& ground,
                                           const Eigen::Matrix3d& R_LG,
                                           const Eigen::Vector3d& tip_G,
                                           const Eigen::Vector3d& support_G, double tension_n,
                                           double excess_m, double gravity_m_s2) {
  const Eigen::Vector3d tip = R_LG * tip_G, way = R_LG * (support_G - tip_G);
  const double h = way.head<2>().norm(), v = way.z();
  const double weight_n_per_m = tether.mass_kg_per_m * gravity_m_s2;
  double a = kFlattest * h;
  if (tension_n > kSmallestTension_n && weight_n_per_m > 0.0) {
    a = OfTension(tension_n / weight_n_per_m, h, v);
  } else if (excess_m > 0.0) {
    a = OfLength(way.norm() + excess_m, h, v);
  }
  const bool hangs = h > 1e-3 && a < 0.99 * kFlattest * h;
  const Catenary curve(std::max(a, 1e-3), std::max(h, 1e-3), v);
  std::vector<Eigen::Vector3d> points;
  points.reserve(kPieces + 1);
  for (int i = 0; i <= kPieces; ++i) {
    const double share = static_cast<double>(i) / kPieces;
    Eigen::Vector3d p = tip + share * way;
    if (hangs && i > 0 && i < kPieces) p.z() = tip.z() + curve.Height(share * h);
    p = (R_LG.transpose() * p).eval();
    if (i > 0 && i < kPieces) {
      p.z() = std::max(p.z(), ground.Height(p.x(), p.y()) + 0.5 * tether.diameter_m);
    }
    points.push_back(p);
  }
  points.back() = support_G;
  return points;
}

}  // namespace dockyard
