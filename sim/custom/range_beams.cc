#include "sim/custom/range_beams.h"

#include <algorithm>
#include <cmath>

namespace dockyard::custom {
namespace {

using Eigen::Vector3d;

// Of a search for the ground along the beam, then halved as often. Numerical: 2 cm, then 20 um.
constexpr double kSearch_m = 0.02;
constexpr int kHalvings = 10;

double ToGround(const Vector3d& from_G, const Vector3d& along_G, double most_m,
                const HeightGrid& ground) {
  const auto above = [&](double s) {
    const Vector3d p = from_G + s * along_G;
    return p.z() - ground.Height(p.x(), p.y()) > 0.0;
  };
  for (double s = 0.0; s < most_m; s += kSearch_m) {
    if (above(s + kSearch_m)) continue;
    double low = s, high = s + kSearch_m;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (above(middle) ? low : high) = middle;
    }
    return std::min(high, most_m);
  }
  return most_m;
}

}  // namespace

double BeamLength(const RangeFinder& finder, const Pose3& X_GF,
                  const std::vector<LinkSolid>& solids, const TreeInWorld& tree,
                  const RigidWorld& world, const HeightGrid& ground) {
  const Vector3d along_G = X_GF.R.col(0);
  const Vector3d end_G = X_GF.p + finder.most_m * along_G;
  double least_m = ToGround(X_GF.p, along_G, finder.most_m, ground);
  for (const LinkSolid& solid : solids) {
    const Pose3 X_LG = Inverse(tree.Motion(world, solid.link).X_GL);
    const auto hit = PressEdge(solid.body_L, X_LG * X_GF.p, X_LG * end_G);
    if (hit && hit->to > hit->from) least_m = std::min(least_m, hit->from * finder.most_m);
  }
  return least_m < finder.least_m ? finder.most_m : least_m;
}

}  // namespace dockyard::custom
