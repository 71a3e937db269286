#include "vision/synthetic_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sim/base/random.h"

namespace dockyard {
namespace {

constexpr double kWhite = 0.85, kBlack = 0.05;  // albedo

double Hash01(std::int64_t x, std::int64_t y, std::uint64_t seed) {
  RandomStream stream(seed + 0x9e3779b97f4a7c15ull * static_cast<std::uint64_t>(x) +
                      0xc2b2ae3d27d4eb4full * static_cast<std::uint64_t>(y));
  return stream.Uniform();
}

/// Smooth value noise, 0..1, one feature per unit.
double ValueNoise(const Eigen::Vector2d& p, std::uint64_t seed) {
  const double fx = std::floor(p.x()), fy = std::floor(p.y());
  const auto ix = static_cast<std::int64_t>(fx), iy = static_cast<std::int64_t>(fy);
  const auto ease = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const double u = ease(p.x() - fx), v = ease(p.y() - fy);
  return (1 - v) * ((1 - u) * Hash01(ix, iy, seed) + u * Hash01(ix + 1, iy, seed)) +
         v * ((1 - u) * Hash01(ix, iy + 1, seed) + u * Hash01(ix + 1, iy + 1, seed));
}

bool OnBlack(const Eigen::Vector2d& from_centre, const FiducialBoard& board, double rotation) {
  if (from_centre.norm() > 0.5 * board.disc_diameter_m) return false;
  const Eigen::Vector2d along(std::cos(rotation), -std::sin(rotation));
  const double u = std::abs(from_centre.dot(along));
  const double v = std::abs(from_centre.x() * along.y() - from_centre.y() * along.x());
  return !(u < 0.5 * board.bar_length_m && v < 0.5 * board.bar_width_m);
}

double PlateAlbedo(const SyntheticScene& scene, const Eigen::Vector2d& p_B) {
  const FiducialBoard& board = scene.board;
  if (scene.has_station && (p_B - Eigen::Vector2d(0.0, 0.17)).norm() < 0.12) return 0.03;  // mouth
  if (scene.cover) {
    const Eigen::Vector2d from = (p_B - scene.cover->middle_B).cwiseAbs();
    if ((from.array() < 0.5 * scene.cover->size_m.array()).all()) return 0.4;
  }
  for (const Fiducial& fiducial : board.fiducials) {
    if (OnBlack(p_B - fiducial.p_BF, board, fiducial.rotation)) return kBlack;
  }
  return kWhite;
}

double BoardLight(const SyntheticScene& scene, const Eigen::Vector2d& p_B) {
  double light = 1.0;
  if (scene.speckle > 0.0) {
    const double patch = ValueNoise(p_B / 0.07, scene.seed + 77);
    light *= 1.0 - scene.speckle * std::clamp(4.0 * (patch - 0.5) + 0.5, 0.0, 1.0);
  }
  if (scene.shadow) {
    const auto& edge = *scene.shadow;
    const Eigen::Vector2d normal(std::cos(edge.normal_rad), std::sin(edge.normal_rad));
    const double depth = (p_B - edge.through_B).dot(normal) / edge.penumbra_m;
    light *= 1.0 - (1.0 - edge.shade) * std::clamp(0.5 + depth, 0.0, 1.0);
  }
  return light;
}

/// Radiance of ground and sky, white plate in full light is kWhite.
double Background(const SyntheticScene& scene, const Eigen::Vector3d& eye_D,
                  const Eigen::Vector3d& ray_D) {
  const double azimuth = std::atan2(ray_D.y(), ray_D.x());
  const double hills = 0.05 * ValueNoise({6.0 * azimuth, 0.0}, scene.seed + 5);
  if (ray_D.z() > hills) return 0.75 - 0.2 * std::min(ray_D.z(), 1.0);
  if (ray_D.z() > -0.005) return 0.35;
  const Eigen::Vector3d hit = eye_D - ray_D * (eye_D.z() / ray_D.z());
  const Eigen::Vector2d p = hit.head<2>();
  double albedo = 0.30 + 0.25 * (ValueNoise(p / 0.6, scene.seed) - 0.5) +
                  0.20 * (ValueNoise(p / 0.11, scene.seed + 1) - 0.5);
  // Stones with their shadows: the dark and bright sides of a steep noise.
  const double stone = ValueNoise(p / 0.16, scene.seed + 2);
  if (stone > 0.86) albedo *= 1.6;
  if (stone < 0.13) albedo *= 0.35;
  return albedo;
}

struct Disc {
  Eigen::Vector2d centre_px;
  double radius_px = 0.0, squash = 1.0, tilt = 0.0, rotation = 0.0;
  bool with_bar = false;
};

std::vector<Disc> ClutterDiscs(const SyntheticScene& scene, const Camera& camera,
                               RandomStream& random) {
  std::vector<Disc> discs;
  for (int i = 0; i < scene.clutter_discs + scene.clutter_fiducials; ++i) {
    Disc disc;
    disc.centre_px = {random.Uniform(20.0, camera.width - 20.0),
                      random.Uniform(20.0, camera.height - 20.0)};
    disc.radius_px = random.Uniform(4.0, 25.0);
    disc.squash = random.Uniform(0.6, 1.0);
    disc.tilt = random.Uniform(0.0, kPi);
    disc.rotation = random.Uniform(0.0, kPi);
    disc.with_bar = i >= scene.clutter_discs;
    discs.push_back(disc);
  }
  return discs;
}

/// Albedo of clutter over a pixel, if any covers it: a fiducial on a white ground, or a dark disc.
std::optional<double> ClutterAt(const std::vector<Disc>& discs, const FiducialBoard& board,
                                const Eigen::Vector2d& pixel) {
  for (const Disc& disc : discs) {
    const Eigen::Vector2d from = pixel - disc.centre_px;
    const double c = std::cos(disc.tilt), s = std::sin(disc.tilt);
    const Eigen::Vector2d turned(c * from.x() + s * from.y(),
                                 (c * from.y() - s * from.x()) / disc.squash);
    const double length = turned.norm() / disc.radius_px;
    if (length > (disc.with_bar ? 1.6 : 1.0)) continue;
    if (!disc.with_bar) return 0.06;
    const Eigen::Vector2d p = 0.5 * board.disc_diameter_m / disc.radius_px * turned;
    return OnBlack(p, board, disc.rotation) ? kBlack : kWhite;
  }
  return std::nullopt;
}

class RayCaster {
 public:
  RayCaster(const SyntheticScene& scene, const Camera& camera, const Pose3& X_RC,
            RandomStream& random)
      : scene_(scene),
        camera_(camera),
        X_DC_(scene.X_DR * X_RC),
        X_BC_(Inverse(scene.X_DB) * X_DC_) {
    discs_ = ClutterDiscs(scene, camera, random);
  }

  double Pixel(int x, int y) const {
    const Eigen::Vector2d middle(x, y);
    const bool fine = scene_.has_board && NearBoard(middle);
    const int n = fine || NearClutter(middle) ? scene_.samples : 1;
    double sum = 0.0;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        sum += Radiance(middle + Eigen::Vector2d((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5));
      }
    }
    return sum / (n * n);
  }

 private:
  std::optional<Eigen::Vector2d> HitBoardPlane(const Eigen::Vector3d& ray_C) const {
    const Eigen::Vector3d ray_B = X_BC_.R * ray_C;
    if (ray_B.z() < 1e-6 || X_BC_.p.z() > 0.0) return std::nullopt;
    return Eigen::Vector2d((X_BC_.p - ray_B * (X_BC_.p.z() / ray_B.z())).head<2>());
  }
  bool NearBoard(const Eigen::Vector2d& pixel) const {
    const auto hit = HitBoardPlane(camera_.Direction(pixel));
    return hit && std::abs(hit->x()) < 0.5 && std::abs(hit->y()) < 0.3;
  }
  bool NearClutter(const Eigen::Vector2d& pixel) const {
    return std::any_of(discs_.begin(), discs_.end(), [&](const Disc& disc) {
      return (pixel - disc.centre_px).squaredNorm() < 4.0 * disc.radius_px * disc.radius_px;
    });
  }
  double Radiance(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector3d ray_C = camera_.Direction(pixel);
    if (scene_.has_board) {
      const auto hit = HitBoardPlane(ray_C);
      if (hit && std::abs(hit->x()) < 0.5 * scene_.board.width_m &&
          std::abs(hit->y()) < 0.5 * scene_.board.height_m) {
        const double albedo = PlateAlbedo(scene_, *hit);
        return albedo * BoardLight(scene_, *hit);
      }
      // The module behind the plate, down to the ground.
      if (scene_.has_station && hit && std::abs(hit->x()) < 0.6 && hit->y() > -0.4 &&
          hit->y() < 0.6) {
        return 0.42 * BoardLight(scene_, *hit);
      }
    }
    if (const auto albedo = ClutterAt(discs_, scene_.board, pixel)) return *albedo;
    return Background(scene_, X_DC_.p, X_DC_.R * ray_C);
  }

  const SyntheticScene& scene_;
  const Camera& camera_;
  Pose3 X_DC_, X_BC_;
  std::vector<Disc> discs_;
};

/// Gaussian blur, separable, border pixels repeated.
std::vector<double> Blurred(const std::vector<double>& in, int width, int height, double sigma) {
  constexpr int kHalf = 3;
  std::array<double, 2 * kHalf + 1> kernel;
  double sum = 0.0;
  for (int i = -kHalf; i <= kHalf; ++i) {
    kernel[static_cast<std::size_t>(i + kHalf)] = std::exp(-0.5 * i * i / (sigma * sigma));
    sum += kernel[static_cast<std::size_t>(i + kHalf)];
  }
  std::vector<double> rows(in.size()), out(in.size());
  const auto pass = [&](const std::vector<double>& from, std::vector<double>& to, bool across) {
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        double value = 0.0;
        for (int i = -kHalf; i <= kHalf; ++i) {
          const int xi = across ? std::clamp(x + i, 0, width - 1) : x;
          const int yi = across ? y : std::clamp(y + i, 0, height - 1);
          value += kernel[static_cast<std::size_t>(i + kHalf)] / sum *
                   from[static_cast<std::size_t>(yi) * width + xi];
        }
        to[static_cast<std::size_t>(y) * width + x] = value;
      }
    }
  };
  pass(in, rows, true);
  pass(rows, out, false);
  return out;
}

}  // namespace

FiducialBoard TestBoard() {
  FiducialBoard board{.width_m = 0.9,
                      .height_m = 0.5,
                      .disc_diameter_m = 0.10,
                      .bar_length_m = 0.064,
                      .bar_width_m = 0.022,
                      .fiducials = {}};
  const double layout[8][3] = {{-.36, -.17, 0}, {-.12, -.18, 45}, {.14, -.17, 90}, {.37, -.16, -45},
                               {-.38, .06, 90}, {-.27, .18, -45}, {.27, .04, 0},   {.37, .17, 45}};
  for (const auto& [x, y, degrees] : layout) {
    board.fiducials.push_back({.p_BF = {x, y}, .rotation = Radians(degrees)});
  }
  return board;
}

StereoRig TestRig(int width, int height) {
  Pose3 ahead;
  ahead.R << 0, 0, 1, -1, 0, 0, 0, -1, 0;  // x_C = -y_R, y_C = -z_R, z_C = x_R
  StereoRig rig{.left = EquidistantCamera(width, height, Radians(90.0)),
                .right = EquidistantCamera(width, height, Radians(90.0)),
                .X_RL = ahead,
                .X_RQ = ahead};
  rig.X_RL.p = {0.05, 0.175, 0.22};
  rig.X_RQ.p = {0.05, -0.175, 0.22};
  return rig;
}

Pose3 TestBoardInDock() {
  Pose3 X_DB = Pose3::Translation(0.0, 0.0, 0.62);
  X_DB.R << 0, 0, -1, 1, 0, 0, 0, -1, 0;  // x_B = y_D, y_B = -z_D, z_B = -x_D
  X_DB.R = RotY(Radians(5.0)) * X_DB.R;
  return X_DB;
}

Pose3 RoverAt(const DockingCoords& at, double pitch_rad) {
  Pose3 X_DR = FromGround(FromDockingCoords(at), 0.25);
  X_DR.R = X_DR.R * RotY(pitch_rad);
  return X_DR;
}

StereoRig Miscalibrated(const StereoRig& rig, std::uint64_t key) {
  RandomStream random(key);
  StereoRig built = rig;
  for (const bool right : {false, true}) {
    Camera& camera = right ? built.right : built.left;
    Pose3& X_RC = right ? built.X_RQ : built.X_RL;
    const double yaw = right ? Radians(0.16) * random.Normal() : 0.0;
    const double pitch = Radians(0.05) * random.Normal(), roll = Radians(0.05) * random.Normal();
    X_RC.R = X_RC.R * RotY(yaw) * RotX(pitch) * RotZ(roll);
    const double focal = 1.0 + 0.002 * random.Normal();
    const double du = random.Normal(), dv = random.Normal();
    camera = Adjusted(camera, focal, {du, dv});
  }
  return built;
}

GrayImage SyntheticView(const SyntheticScene& scene, const Camera& camera, const Pose3& X_RC) {
  RandomStream random(StreamKey(scene.seed, X_RC.p.y() > 0.0 ? "left view" : "right view"));
  const RayCaster caster(scene, camera, X_RC, random);
  const std::size_t count =
      static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  std::vector<double> radiance(count);
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      radiance[static_cast<std::size_t>(y) * camera.width + x] = caster.Pixel(x, y);
    }
  }
  if (scene.blur_px > 0.0) radiance = Blurred(radiance, camera.width, camera.height, scene.blur_px);
  GrayImage image{.width = camera.width, .height = camera.height, .pixels = {}};
  image.pixels.reserve(count);
  for (const double value : radiance) {
    const double dn = value / kWhite * scene.white_dn + scene.noise_dn * random.Normal();
    image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(dn), 0l, 255l)));
  }
  return image;
}

StereoImages SyntheticPair(const SyntheticScene& scene, const StereoRig& rig) {
  return {.left = SyntheticView(scene, rig.left, rig.X_RL),
          .right = SyntheticView(scene, rig.right, rig.X_RQ)};
}

}  // namespace dockyard
