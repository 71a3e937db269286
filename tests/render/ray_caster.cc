#include "render/ray_caster.h"

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "render/ground_mesh.h"
#include "render/pixel_noise.h"

namespace dockyard {
namespace {

// Embree 3 takes a context, Embree 4 none.
#if RTC_VERSION_MAJOR >= 4
void Intersect(RTCScene world, RTCRayHit& hit) { rtcIntersect1(world, &hit); }
void Occlude(RTCScene world, RTCRay& ray) { rtcOccluded1(world, &ray); }
#else
void Intersect(RTCScene world, RTCRayHit& hit) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(world, &context, &hit);
}
void Occlude(RTCScene world, RTCRay& ray) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(world, &context, &ray);
}
#endif

// The kind of an Embree geometry.
constexpr int kBoard = -1, kGround = -2, kTether = -3;

double Grey(const Eigen::Vector3d& rgb) { return rgb.dot(Eigen::Vector3d(0.299, 0.587, 0.114)); }

class World {
 public:
  explicit World(const Scene& scene) : scene_(scene), origin_(scene.boards.at(0).X_WB.p) {
    device_ = rtcNewDevice(nullptr);
    if (!device_) throw std::runtime_error("Embree has no device");
    world_ = rtcNewScene(device_);
    rtcSetSceneFlags(world_, RTC_SCENE_FLAG_ROBUST);
    for (std::size_t i = 0; i < scene.objects.size(); ++i) AddObject(static_cast<int>(i));
    AddBoard();
    AddGround();
    AddTether();
    rtcCommitScene(world_);
  }
  ~World() {
    rtcReleaseScene(world_);
    rtcReleaseDevice(device_);
  }
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  double Radiance(const Eigen::Vector3d& from_W, const Eigen::Vector3d& ray_W,
                  const Eigen::Vector2d& sun_point) const {
    RTCRayHit hit = Query(from_W, ray_W, 1e-3);
    Intersect(world_, hit);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return Sky(ray_W);
    const Eigen::Vector3d p_W = from_W + static_cast<double>(hit.ray.tfar) * ray_W;
    Eigen::Vector3d n = Eigen::Vector3d(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z).normalized();
    if (n.dot(ray_W) > 0.0) n = -n;
    const int kind = kinds_[hit.hit.geomID];
    const double open = kind == kGround ? 0.92 : 1.0;  // grain holds back this much sky at rest
    return Lambert(Albedo(kind, p_W, ray_W), p_W, n, open, sun_point);
  }

 private:
  RTCRayHit Query(const Eigen::Vector3d& from_W, const Eigen::Vector3d& ray, double start) const {
    const Eigen::Vector3d from = from_W - origin_;
    RTCRayHit hit{};
    hit.ray.org_x = static_cast<float>(from.x());
    hit.ray.org_y = static_cast<float>(from.y());
    hit.ray.org_z = static_cast<float>(from.z());
    hit.ray.dir_x = static_cast<float>(ray.x());
    hit.ray.dir_y = static_cast<float>(ray.y());
    hit.ray.dir_z = static_cast<float>(ray.z());
    hit.ray.tnear = static_cast<float>(start);
    hit.ray.tfar = 1e9f;
    hit.ray.mask = 0xffffffffu;
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    return hit;
  }

  void Add(const std::vector<Eigen::Vector3d>& points_W,
           const std::vector<std::array<std::uint32_t, 3>>& triangles, int kind) {
    RTCGeometry mesh = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, points_W.size()));
    for (std::size_t i = 0; i < points_W.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        vertices[3 * i + k] = static_cast<float>(points_W[i][k] - origin_[k]);
      }
    }
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        mesh, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, triangles.size()));
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) indices[3 * i + k] = triangles[i][k];
    }
    rtcCommitGeometry(mesh);
    rtcAttachGeometry(world_, mesh);
    rtcReleaseGeometry(mesh);
    kinds_.push_back(kind);
  }

  void AddObject(int index) {
    const SceneObject& object = scene_.objects[static_cast<std::size_t>(index)];
    std::vector<Eigen::Vector3d> points;
    for (const auto& v : object.mesh->vertices) points.push_back(object.X_WO * v.cast<double>());
    Add(points, object.mesh->triangles, index);
  }
  void AddBoard() {
    const FiducialBoard& board = scene_.boards[0].board;
    const double x = 0.5 * board.width_m, y = 0.5 * board.height_m;
    std::vector<Eigen::Vector3d> points;
    for (const auto& [sx, sy] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
      points.push_back(scene_.boards[0].X_WB * Eigen::Vector3d(sx * x, sy * y, 0.0));
    }
    Add(points, {{0, 1, 2}, {0, 2, 3}}, kBoard);
  }
  // The smooth ground of which the grid's heights are samples (Catmull and Rom's cubic through
  // them) in triangles of half a cell, and coarse ones out to 200 m. In triangles of whole cells
  // the ground would have facets that no soil has.
  void AddGround() {
    const GroundView& g = scene_.ground;
    const auto patch = [&](double x0, double y0, double cell, int nx, int ny, auto height,
                           auto left_out) {
      std::vector<Eigen::Vector3d> points;
      std::vector<std::array<std::uint32_t, 3>> triangles;
      for (int iy = 0; iy < ny; ++iy) {
        for (int ix = 0; ix < nx; ++ix) {
          const double x = x0 + ix * cell, y = y0 + iy * cell;
          points.push_back(g.X_WG * Eigen::Vector3d(x, y, height(x, y)));
          if (ix + 1 == nx || iy + 1 == ny || left_out(x + 0.5 * cell, y + 0.5 * cell)) continue;
          const auto a = static_cast<std::uint32_t>(iy * nx + ix),
                     n = static_cast<std::uint32_t>(nx);
          triangles.push_back({a, a + 1, a + n});
          triangles.push_back({a + 1, a + n + 1, a + n});
        }
      }
      Add(points, triangles, kGround);
    };
    const GroundHeight height(g);
    const double x1 = g.x0_m + (g.nx - 1) * g.cell_m, y1 = g.y0_m + (g.ny - 1) * g.cell_m;
    const auto smooth = [&](double x, double y) {
      const double u = (x - g.x0_m) / g.cell_m, v = (y - g.y0_m) / g.cell_m;
      const int ix = static_cast<int>(std::floor(u)), iy = static_cast<int>(std::floor(v));
      std::array<double, 4> rows{};
      for (int j = 0; j < 4; ++j) {
        std::array<double, 4> row{};
        for (int i = 0; i < 4; ++i) row[i] = Node(ix - 1 + i, iy - 1 + j);
        rows[j] = Cubic(row, u - ix);
      }
      return Cubic(rows, v - iy);
    };
    patch(g.x0_m, g.y0_m, 0.5 * g.cell_m, 2 * g.nx - 1, 2 * g.ny - 1, smooth,
          [](double, double) { return false; });
    patch(g.x0_m - 200.0, g.y0_m - 200.0, 0.5, 821, 813, height,
          [&](double x, double y) { return x > g.x0_m && x < x1 && y > g.y0_m && y < y1; });
  }
  double Node(int ix, int iy) const {
    const GroundView& g = scene_.ground;
    return g.heights_m[std::clamp(iy, 0, g.ny - 1) * g.nx + std::clamp(ix, 0, g.nx - 1)];
  }
  // Between the second and the third of four values, t from 0 to 1.
  static double Cubic(const std::array<double, 4>& h, double t) {
    return h[1] + 0.5 * t *
                      (h[2] - h[0] +
                       t * (2.0 * h[0] - 5.0 * h[1] + 4.0 * h[2] - h[3] +
                            t * (3.0 * (h[1] - h[2]) + h[3] - h[0])));
  }

  // Six flat sides round each piece.
  void AddTether() {
    const auto& line = scene_.tether.points_W;
    std::vector<Eigen::Vector3d> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    constexpr std::uint32_t kSides = 6;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Eigen::Vector3d along = (line[i + 1] - line[i]).normalized();
      const Eigen::Vector3d side = along.unitOrthogonal(), up = along.cross(side);
      const auto base = static_cast<std::uint32_t>(points.size());
      for (const Eigen::Vector3d& end : {line[i], line[i + 1]}) {
        for (std::uint32_t k = 0; k < kSides; ++k) {
          const double a = 2.0 * kPi * k / kSides;
          points.push_back(end + 0.5 * scene_.tether.diameter_m *
                                     (std::cos(a) * side + std::sin(a) * up));
        }
      }
      for (std::uint32_t k = 0; k < kSides; ++k) {
        const std::uint32_t l = (k + 1) % kSides;
        triangles.push_back({base + k, base + l, base + kSides + k});
        triangles.push_back({base + l, base + kSides + l, base + kSides + k});
      }
    }
    if (!triangles.empty()) Add(points, triangles, kTether);
  }

  double Albedo(int kind, const Eigen::Vector3d& p_W, const Eigen::Vector3d& ray_W) const {
    if (kind >= 0) return Grey(scene_.objects[static_cast<std::size_t>(kind)].albedo);
    if (kind == kGround) return Grey(scene_.ground.albedo);
    if (kind == kTether) return Grey(scene_.tether.albedo);
    const BoardView& view = scene_.boards[0];
    if (ray_W.dot(view.X_WB.R.col(2)) < 0.0) return view.white_albedo;  // its back
    const Eigen::Vector3d p_B = Inverse(view.X_WB) * p_W;
    for (const Fiducial& f : view.board.fiducials) {
      const Eigen::Vector2d q = p_B.head<2>() - f.p_BF;
      if (q.norm() > 0.5 * view.board.disc_diameter_m) continue;
      const Eigen::Vector2d along(std::cos(f.rotation), -std::sin(f.rotation));
      const Eigen::Vector2d across(-along.y(), along.x());
      const bool bar = std::abs(q.dot(along)) < 0.5 * view.board.bar_length_m &&
                       std::abs(q.dot(across)) < 0.5 * view.board.bar_width_m;
      return bar ? view.white_albedo : view.black_albedo;
    }
    return view.white_albedo;
  }

  double Lambert(double albedo, const Eigen::Vector3d& p_W, const Eigen::Vector3d& n, double open,
                 const Eigen::Vector2d& sun_point) const {
    const SunAndSky& light = scene_.light;
    const double on_level =
        light.sun_irradiance * std::max(0.0, light.to_sun_W.z()) + light.sky_irradiance;
    const double sky = 0.5 * (1.0 + n.z()) * light.sky_irradiance +
                       0.5 * (1.0 - n.z()) * light.ground_bounce_albedo * on_level;
    const double cosine = n.dot(light.to_sun_W);
    double sun = 0.0;
    if (cosine > 0.0) {
      const Eigen::Vector3d side = light.to_sun_W.unitOrthogonal();
      const Eigen::Vector3d up = light.to_sun_W.cross(side);
      const double radius = 0.5 * light.sun_angular_diameter_rad;
      const Eigen::Vector3d towards =
          (light.to_sun_W + radius * (sun_point.x() * side + sun_point.y() * up)).normalized();
      RTCRayHit ray = Query(p_W + 1e-4 * n, towards, 1e-4);
      Occlude(world_, ray.ray);
      if (ray.ray.tfar > 0.0f) sun = cosine * light.sun_irradiance;
    }
    return albedo / kPi * (sun + sky * open);
  }
  double Sky(const Eigen::Vector3d& ray) const {
    const SunAndSky& light = scene_.light;
    const double on_level =
        light.sun_irradiance * std::max(0.0, light.to_sun_W.z()) + light.sky_irradiance;
    return (ray.z() > 0.0 ? light.sky_irradiance * 0.75 * (2.0 - ray.z())
                          : light.ground_bounce_albedo * on_level) /
           kPi;
  }

  const Scene& scene_;
  Eigen::Vector3d origin_;  // of Embree's floats
  RTCDevice device_ = nullptr;
  RTCScene world_ = nullptr;
  std::vector<int> kinds_;
};

}  // namespace

RadianceImage CastRays(const Scene& scene, const Camera& camera, const Pose3& X_WC,
                       int rays_a_side) {
  const World world(scene);
  RadianceImage image{
      .width = camera.width, .height = camera.height, .values = {}, .inverse_depth = {}};
  std::uint64_t place = 0;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      double sum = 0.0;
      for (int k = 0; k < rays_a_side * rays_a_side; ++k) {
        const int column = k % rays_a_side, row = k / rays_a_side;
        const double u = x - 0.5 + (column + 0.5) / rays_a_side;
        const double v = y - 0.5 + (row + 0.5) / rays_a_side;
        const double radius = std::sqrt(HashUniform(11, ++place));
        const double angle = 2.0 * kPi * HashUniform(12, place);
        sum += world.Radiance(X_WC.p, X_WC.R * camera.Direction({u, v}),
                              {radius * std::cos(angle), radius * std::sin(angle)});
      }
      image.values.push_back(static_cast<float>(sum / (rays_a_side * rays_a_side)));
    }
  }
  return image;
}

}  // namespace dockyard
