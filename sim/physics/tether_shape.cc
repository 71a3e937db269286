#include "sim/physics/tether_shape.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

constexpr int kPieces = 24;
constexpr double kGravity = 9.81;          // [m/s^2]
constexpr double kSmallestTensionN = 0.1;  // slacker than this, the excess length gives the sag

}  // namespace

std::vector<Eigen::Vector3d> HangingTether(const TetherModel& tether, const HeightGrid& ground,
                                           const Eigen::Vector3d& tip_G,
                                           const Eigen::Vector3d& support_G, double tension_n,
                                           double excess_m) {
  const double distance = (support_G - tip_G).norm();
  double sag = std::sqrt(0.375 * distance * std::max(0.0, excess_m));
  if (tension_n > kSmallestTensionN) {
    const double weight_n_per_m = tether.mass_kg_per_m * kGravity;
    sag = weight_n_per_m * distance * distance / (8.0 * tension_n);
  }
  std::vector<Eigen::Vector3d> points;
  points.reserve(kPieces + 1);
  for (int i = 0; i <= kPieces; ++i) {
    const double s = static_cast<double>(i) / kPieces;
    Eigen::Vector3d p = tip_G + s * (support_G - tip_G);
    p.z() -= 4.0 * sag * s * (1.0 - s);
    if (i > 0 && i < kPieces) {
      p.z() = std::max(p.z(), ground.Height(p.x(), p.y()) + 0.5 * tether.diameter_m);
    }
    points.push_back(p);
  }
  return points;
}

}  // namespace dockyard
