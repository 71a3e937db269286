#include "raposa/sim/drawn_pyramid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sim/raposa/mark_meshes.h"

namespace dockyard::raposa {
namespace {

using Colour = std::array<std::uint8_t, 3>;

class DepthBuffer {
 public:
  DepthBuffer(const Camera& camera, const Pose3& X_CP)
      : camera_(camera),
        X_CP_(X_CP),
        image_{camera.width, camera.height, {}},
        inverse_depth_(static_cast<std::size_t>(camera.width * camera.height), 0.0) {
    image_.pixels.assign(3 * inverse_depth_.size(), 0);
  }

  void Add(const std::array<Eigen::Vector3d, 3>& p_P, const Colour& colour) {
    std::array<Eigen::Vector2d, 3> at;
    Eigen::Vector3d inverse_depth;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d p_C = X_CP_ * p_P[i];
      const auto pixel = camera_.Project(p_C);
      if (p_C.z() <= 0.0 || !pixel) return;
      at[i] = *pixel;
      inverse_depth[static_cast<Eigen::Index>(i)] = 1.0 / p_C.z();
    }
    Fill(at, inverse_depth, colour);
  }
  RgbImage& image() { return image_; }

 private:
  static double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
  }
  void Fill(const std::array<Eigen::Vector2d, 3>& at, const Eigen::Vector3d& inverse_depth,
            const Colour& colour) {
    const double area = Cross(at[1] - at[0], at[2] - at[0]);
    if (std::abs(area) < 1e-9) return;
    const auto [x0, x1] = std::minmax({at[0].x(), at[1].x(), at[2].x()});
    const auto [y0, y1] = std::minmax({at[0].y(), at[1].y(), at[2].y()});
    for (int y = std::max(0, static_cast<int>(std::ceil(y0)));
         y <= std::min(image_.height - 1, static_cast<int>(std::floor(y1))); ++y) {
      for (int x = std::max(0, static_cast<int>(std::ceil(x0)));
           x <= std::min(image_.width - 1, static_cast<int>(std::floor(x1))); ++x) {
        const Eigen::Vector2d p(x, y);
        const Eigen::Vector3d share(Cross(at[1] - p, at[2] - p) / area,
                                    Cross(at[2] - p, at[0] - p) / area,
                                    Cross(at[0] - p, at[1] - p) / area);
        if (share.minCoeff() < 0.0) continue;
        Put(x, y, share.dot(inverse_depth), colour);
      }
    }
  }
  void Put(int x, int y, double inverse_depth, const Colour& colour) {
    const std::size_t k = static_cast<std::size_t>(y * image_.width + x);
    if (inverse_depth <= inverse_depth_[k]) return;
    inverse_depth_[k] = inverse_depth;
    std::ranges::copy(colour, &image_.pixels[3 * k]);
  }

  const Camera& camera_;
  Pose3 X_CP_;
  RgbImage image_;
  std::vector<double> inverse_depth_;
};

}  // namespace

RgbImage DrawnPyramid(const PyramidModel& pyramid, const Camera& camera, const Pose3& X_PC) {
  DepthBuffer buffer(camera, Inverse(X_PC));
  const auto add = [&](const RenderMesh& mesh, const Colour& colour) {
    for (const auto& t : mesh.triangles) {
      buffer.Add({mesh.vertices[t[0]].cast<double>(), mesh.vertices[t[1]].cast<double>(),
                  mesh.vertices[t[2]].cast<double>()},
                 colour);
    }
  };
  const Colour orange{190, 90, 20}, blue{20, 60, 170}, grey{120, 120, 120};
  for (const Visual& visual : pyramid.body.visuals) {
    for (const auto& t : visual.mesh->triangles) {
      std::array<Eigen::Vector3d, 3> p_P;
      for (std::size_t i = 0; i < 3; ++i) {
        p_P[i] = visual.X_LV * visual.mesh->vertices[static_cast<std::size_t>(t[i])];
      }
      buffer.Add(p_P, grey);
    }
  }
  add(FacesMesh(pyramid.marks), grey);
  add(RodMesh(pyramid), grey);
  add(StripsMesh(pyramid.marks), blue);
  add(GuideMesh(pyramid.guide), orange);
  return std::move(buffer.image());
}

}  // namespace dockyard::raposa
