#include "controller/stereo/ground_plane.h"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

namespace dockyard {

std::optional<Eigen::Vector3d> FitGroundPlane(const std::vector<Eigen::Vector3d>& points,
                                              const Eigen::Vector3d& expected, int least_points) {
  constexpr std::array kBands_m{0.12, 0.06, 0.03};
  Eigen::Vector3d plane = expected;
  bool found = false;
  for (const double band_m : kBands_m) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    int count = 0;
    for (const Eigen::Vector3d& p : points) {
      const Eigen::Vector3d row(1.0, p.x(), p.y());
      if (std::abs(p.z() - row.dot(plane)) > band_m) continue;
      normal += row * row.transpose();
      right += p.z() * row;
      ++count;
    }
    if (count < least_points) break;
    plane = normal.ldlt().solve(right);
    found = true;
  }
  return found ? std::optional(plane) : std::nullopt;
}

}  // namespace dockyard
