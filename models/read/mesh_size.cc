#include "models/read/mesh_size.h"

#include <cstdio>

namespace dockyard {

Eigen::Vector3d ExtentOf(const TriangleMesh& mesh) {
  if (mesh.vertices.empty()) return Eigen::Vector3d::Zero();
  Eigen::Vector3d low = mesh.vertices[0], high = low;
  for (const Eigen::Vector3d& v : mesh.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return high - low;
}

std::string SizeText(const Eigen::Vector3d& extent_m) {
  std::string text;
  for (const double side : extent_m) {
    char number[32];
    std::snprintf(number, sizeof number, side < 100.0 ? "%.3g" : "%.0f", side);
    text += (text.empty() ? "" : " x ") + std::string(number);
  }
  return text + " m";
}

std::string UnitDoubt(const Eigen::Vector3d& extent_m) {
  constexpr double kLarge_m = 50.0, kSmall_m = 1e-3;
  const double largest = extent_m.maxCoeff();
  const std::string size = "its size is " + SizeText(extent_m);
  if (largest > kLarge_m) return size + "; is it in millimetres? Numbers count as metres";
  if (largest < kSmall_m) return size + "; is it scaled twice? Numbers count as metres";
  return {};
}

}  // namespace dockyard
