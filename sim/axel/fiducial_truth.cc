#include "sim/axel/fiducial_truth.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dockyard::axel {
namespace {

constexpr int kOutlinePoints = 720;
constexpr int kRings = 6;

/// Whether the segment from a to b meets the triangle (Moeller and Trumbore, 1997).
bool Meets(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
           const std::array<Eigen::Vector3d, 3>& triangle) {
  const Eigen::Vector3d direction = b - a;
  const Eigen::Vector3d e1 = triangle[1] - triangle[0], e2 = triangle[2] - triangle[0];
  const Eigen::Vector3d p = direction.cross(e2);
  const double determinant = e1.dot(p);
  if (std::abs(determinant) < 1e-15) return false;
  const Eigen::Vector3d s = (a - triangle[0]) / determinant;
  const double u = s.dot(p);
  if (u < 0.0 || u > 1.0) return false;
  const Eigen::Vector3d q = s.cross(e1);
  const double v = direction.dot(q);
  if (v < 0.0 || u + v > 1.0) return false;
  const double t = e2.dot(q);
  return t > 1e-6 && t < 1.0 - 1e-3;  // short of the board's own surface
}

bool NearSegment(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                 const Eigen::Vector3d& d, double reach_m) {
  // Closest approach of the segments a-b and c-d.
  const Eigen::Vector3d u = b - a, v = d - c, w = a - c;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  double s = determinant > 1e-12 ? std::clamp((uv * vw - vv * uw) / determinant, 0.0, 1.0) : 0.0;
  const double t = vv > 1e-12 ? std::clamp((uv * s + vw) / vv, 0.0, 1.0) : 0.0;
  s = uu > 1e-12 ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0.0;
  return (w + s * u - t * v).norm() < reach_m;
}

/// All triangles that can stand between camera and board, in the world.
std::vector<std::array<Eigen::Vector3d, 3>> Triangles(const Scene& scene) {
  std::vector<std::array<Eigen::Vector3d, 3>> triangles;
  for (const SceneObject& object : scene.objects) {
    for (const auto& index : object.mesh->triangles) {
      std::array<Eigen::Vector3d, 3> triangle;
      for (int i = 0; i < 3; ++i) {
        triangle[i] = object.X_WO * object.mesh->vertices[index[i]].cast<double>().eval();
      }
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

std::optional<Eigen::Vector2d> PolygonCentroid(const std::vector<Eigen::Vector2d>& outline) {
  double area = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  const Eigen::Vector2d& o = outline.front();
  for (std::size_t i = 1; i + 1 < outline.size(); ++i) {
    const Eigen::Vector2d a = outline[i] - o, b = outline[i + 1] - o;
    const double twice = a.x() * b.y() - a.y() * b.x();
    area += twice;
    moment += twice * (a + b) / 3.0;
  }
  if (std::abs(area) < 1e-12) return std::nullopt;
  return o + moment / area;
}

}  // namespace

std::vector<FiducialPixels> TrueFiducials(const Scene& scene, const Camera& camera,
                                          const Pose3& X_WC, const LensRipple& ripple) {
  const auto triangles = Triangles(scene);
  const Pose3 X_CW = Inverse(X_WC);
  const double radius = 0.5 * scene.boards[0].board.disc_diameter_m;
  std::vector<FiducialPixels> all;
  for (const Fiducial& fiducial : scene.boards[0].board.fiducials) {
    const auto point_W = [&](double r, double angle) {
      return scene.boards[0].X_WB * Eigen::Vector3d(fiducial.p_BF.x() + r * std::cos(angle),
                                                    fiducial.p_BF.y() + r * std::sin(angle), 0.0);
    };
    FiducialPixels truth;
    truth.centre = ProjectWith(ripple, camera, X_CW * point_W(0.0, 0.0));
    std::vector<Eigen::Vector2d> outline;
    truth.whole = true;
    for (int i = 0; i < kOutlinePoints; ++i) {
      const auto pixel =
          ProjectWith(ripple, camera, X_CW * point_W(radius, 2.0 * kPi * i / kOutlinePoints));
      if (!pixel || !camera.Sees(*pixel)) truth.whole = false;
      if (pixel) outline.push_back(*pixel);
    }
    if (outline.size() == kOutlinePoints) truth.centroid = PolygonCentroid(outline);

    int hidden = 0, samples = 0;
    for (int ring = 0; ring < kRings; ++ring) {
      const int spokes = 1 + 6 * ring;  // equal areas, nearly
      for (int k = 0; k < spokes; ++k) {
        const Eigen::Vector3d p = point_W(radius * (ring + 0.5) / kRings, 2.0 * kPi * k / spokes);
        bool blocked = false;
        for (const auto& triangle : triangles) {
          if (Meets(X_WC.p, p, triangle)) {
            blocked = true;
            break;
          }
        }
        const auto& tether = scene.tether.points_W;
        for (std::size_t i = 0; !blocked && i + 1 < tether.size(); ++i) {
          blocked = NearSegment(X_WC.p, p, tether[i], tether[i + 1], 0.5 * scene.tether.diameter_m);
        }
        hidden += blocked;
        ++samples;
      }
    }
    truth.hidden = static_cast<double>(hidden) / samples;
    all.push_back(truth);
  }
  return all;
}

}  // namespace dockyard::axel
