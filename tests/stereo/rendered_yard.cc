#include "stereo/rendered_yard.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>

#include "sim/base/random.h"
#include "sim/images/png.h"
#include "stereo/ray_scene.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kBlur_px = 0.6;
// Stains of rocks: assumed, 0.1-0.2. Their albedo: assumed, 0.2-0.4; the ground has 0.38.
constexpr double kContrast = 0.15;
const Vector3d kRockAlbedo(0.33, 0.27, 0.22);
// Stones larger than this are objects, smaller ones paint.
constexpr double kPebble_m = 0.005;

// Where the ray is in the half-spaces of all faces.
std::optional<double> MeetsBody(const ConvexBody& body, const Vector3d& from,
                                const Vector3d& along) {
  const Vector3d to = body.centre - from;
  const double beside2 = to.squaredNorm() - to.dot(along) * to.dot(along) / along.squaredNorm();
  if (beside2 > body.radius_m * body.radius_m) return std::nullopt;
  double first = 0.0, last = 1e9;
  for (const HalfSpace& face : body.faces) {
    const double rate = face.normal.dot(along), rest = face.offset_m - face.normal.dot(from);
    if (rate == 0.0) {
      if (rest < 0.0) return std::nullopt;
      continue;
    }
    if (rate < 0.0) {
      first = std::max(first, rest / rate);
    } else {
      last = std::min(last, rest / rate);
    }
  }
  if (first > last || first <= 0.0) return std::nullopt;
  return first;
}

}  // namespace

RenderedYard MakeYard(const YardSettings& with) {
  RenderedYard yard;
  constexpr int kSide = 61;
  yard.heights_m.assign(kSide * kSide, 0.0);
  Scene& scene = yard.scene;
  scene.ground = {.X_WG = {},
                  .x0_m = -3,
                  .y0_m = -3,
                  .cell_m = 0.1,
                  .nx = kSide,
                  .ny = kSide,
                  .heights_m = yard.heights_m.data()};
  scene.ground.texture_seed = StreamKey(with.seed, "texture") | 1U;
  scene.ground.largest_pebble_m = kPebble_m;
  const double c = std::cos(with.sun_elevation_rad);
  scene.light.to_sun_W = {c * std::cos(with.sun_azimuth_rad), c * std::sin(with.sun_azimuth_rad),
                          std::sin(with.sun_elevation_rad)};
  // The rover's wheels stand on the rest.
  yard.rocks = PlaceRocks(with.field, {0.1, 2.3, -1.2, 1.2}, {}, StreamKey(with.seed, "rocks"));
  for (const Rock& rock : yard.rocks) {
    RenderMesh mesh;
    for (const Vector3d& p : rock.body.vertices) mesh.vertices.push_back(p.cast<float>());
    mesh.triangles = rock.body.triangles;
    SceneObject object{std::make_shared<const RenderMesh>(std::move(mesh)), {}, kRockAlbedo};
    object.stains = {.contrast = kContrast, .seed = StreamKey(with.seed, "stains")};
    scene.objects.push_back(std::move(object));
  }
  return yard;
}

StereoRig BodyCameras(int width, int height) {
  const Camera camera = EquidistantCamera(width, height, Radians(103.0));
  return {camera, camera, LookingDown({0.0, 0.05, 0.3}, Radians(45.0)),
          LookingDown({0.0, -0.05, 0.3}, Radians(45.0))};
}

StereoImages PictureOf(StereoRenderer& renderer, const RenderedYard& yard, const StereoRig& rig,
                       std::uint64_t noise_key, const Pose3& X_WR) {
  SensorOptions sensor;
  sensor.blur_sigma_px = kBlur_px;
  sensor.noise_key = noise_key;
  Scene scene = yard.scene;
  scene.ground.heights_m = yard.heights_m.data();
  return renderer.Render(scene, rig, X_WR, sensor);
}

std::optional<Met3> MeetsYard(const std::vector<Rock>& rocks, const Vector3d& from,
                              const Vector3d& along) {
  std::optional<Met3> met;
  if (along.z() < 0.0) met = Met3{-from.z() / along.z(), -1};
  for (std::size_t i = 0; i < rocks.size(); ++i) {
    const auto way = MeetsBody(rocks[i].body, from, along);
    if (way && (!met || *way < met->way)) met = Met3{*way, static_cast<int>(i)};
  }
  return met;
}

YardTruth TruthOf(const RenderedYard& yard, const StereoRig& rig, const Rectifier& rectifier) {
  const RectifiedPair& pair = rectifier.pair();
  YardTruth truth{pair.width, pair.height, {}};
  for (int v = 0; v < pair.height; ++v) {
    for (int u = 0; u < pair.width; ++u) {
      YardTruth::Pixel& pixel = truth.pixels.emplace_back();
      if (!rectifier.IsSeen(u, v, false)) continue;
      const Vector3d ray_C = pair.Point(u, v, pair.focal_px * pair.baseline_m);  // 1 m deep
      const auto met = MeetsYard(yard.rocks, rig.X_RL.p, pair.X_RC.R * ray_C);
      if (!met || met->way > 50.0) continue;
      pixel.disparity_px = static_cast<float>(pair.focal_px * pair.baseline_m / met->way);
      pixel.rock = met->rock;
      const double right_u = u - static_cast<double>(pixel.disparity_px);
      if (!rectifier.IsSeen(static_cast<int>(std::lround(right_u)), v, true)) continue;
      const Vector3d p_R = rig.X_RL.p + met->way * (pair.X_RC.R * ray_C);
      const Vector3d back = p_R - rig.X_RQ.p;
      const auto again = MeetsYard(yard.rocks, rig.X_RQ.p, back);
      pixel.both = again && again->way > 1.0 - 1e-6;
    }
  }
  return truth;
}

void KeepPicture(const std::string& name, const GrayImage& image) {
  const char* folder = std::getenv("DOCKYARD_IMAGES");
  if (folder == nullptr) return;
  std::ofstream(std::string(folder) + "/" + name + ".png", std::ios::binary) << EncodePng(image);
}

GrayImage Shades(int width, int height, const std::vector<float>& values, double low, double high) {
  GrayImage image{width, height, {}};
  for (const float value : values) {
    const double share = (static_cast<double>(value) - low) / (high - low);
    image.pixels.push_back(
        std::isnan(value) ? std::uint8_t{0}
                          : static_cast<std::uint8_t>(20.0 + 235.0 * std::clamp(share, 0.0, 1.0)));
  }
  return image;
}

}  // namespace dockyard
