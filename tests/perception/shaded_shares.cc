#include "perception/shaded_shares.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard::axel {
namespace {

constexpr int kRings = 6;
constexpr double kOffPlate_m = 0.01;  // the board's own plate shades nothing

struct Triangle {
  Eigen::Vector3d origin, e1, e2;
};

std::vector<Triangle> Triangles(const Scene& scene) {
  std::vector<Triangle> triangles;
  for (const SceneObject& object : scene.objects) {
    for (const auto& index : object.mesh->triangles) {
      const auto corner = [&](int i) -> Eigen::Vector3d {
        return object.X_WO * object.mesh->vertices[index[i]].cast<double>().eval();
      };
      const Eigen::Vector3d origin = corner(0);
      triangles.push_back({origin, corner(1) - origin, corner(2) - origin});
    }
  }
  return triangles;
}

/// Whether a ray meets the triangle (Moeller and Trumbore, 1997).
bool Meets(const Eigen::Vector3d& from, const Eigen::Vector3d& along, const Triangle& triangle) {
  const Eigen::Vector3d p = along.cross(triangle.e2);
  const double determinant = triangle.e1.dot(p);
  if (std::abs(determinant) < 1e-15) return false;
  const Eigen::Vector3d s = (from - triangle.origin) / determinant;
  const Eigen::Vector3d q = s.cross(triangle.e1);
  const double u = s.dot(p), v = along.dot(q);
  return u >= 0.0 && v >= 0.0 && u + v <= 1.0 && triangle.e2.dot(q) > 0.0;
}

}  // namespace

std::vector<double> ShadedShares(const Scene& scene) {
  const std::vector<Triangle> triangles = Triangles(scene);
  const BoardView& view = scene.boards[0];
  const Eigen::Vector3d& to_sun = scene.light.to_sun_W;
  std::vector<double> shares;
  for (const Fiducial& fiducial : view.board.fiducials) {
    int shaded = 0, samples = 0;
    for (int ring = 0; ring < kRings; ++ring) {
      const double r = 0.5 * view.board.disc_diameter_m * (ring + 0.5) / kRings;
      const int spokes = 1 + 6 * ring;  // equal areas, nearly
      for (int k = 0; k < spokes; ++k) {
        const double angle = 2.0 * kPi * k / spokes;
        const Eigen::Vector3d p =
            view.X_WB * Eigen::Vector3d(fiducial.p_BF.x() + r * std::cos(angle),
                                        fiducial.p_BF.y() + r * std::sin(angle), 0.0);
        const Eigen::Vector3d from = p + kOffPlate_m * to_sun;
        shaded += std::any_of(triangles.begin(), triangles.end(),
                              [&](const Triangle& t) { return Meets(from, to_sun, t); });
        ++samples;
      }
    }
    shares.push_back(static_cast<double>(shaded) / samples);
  }
  return shares;
}

}  // namespace dockyard::axel
