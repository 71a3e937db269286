// What of a scene goes to the GPU, and when it has to go again.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "render/pixel_noise.h"
#include "render/scene_painter.h"
#include "render/soil_texture.h"

namespace dockyard {
namespace {

std::uint64_t ReliefKey(const GroundView& g, const Eigen::Vector3d& sun_G, double sun_diameter) {
  std::uint64_t key = MixBits(g.revision + 1);
  const auto add = [&](double value) {
    std::uint64_t bits;
    static_assert(sizeof bits == sizeof value);
    std::memcpy(&bits, &value, sizeof bits);
    key = (key ^ bits) * 0x9e3779b97f4a7c15ull;
    key ^= key >> 32;
  };
  for (const double v : {g.x0_m, g.y0_m, g.cell_m, double(g.nx), double(g.ny), sun_diameter,
                         sun_G.x(), sun_G.y(), sun_G.z()}) {
    add(v);
  }
  const std::size_t count = static_cast<std::size_t>(g.nx) * g.ny;
  for (std::size_t i = 0; i < count; ++i) add(g.heights_m[i]);
  return key;
}

}  // namespace

void ScenePainter::UploadObjects(const Scene& scene) {
  for (auto& [address, cached] : cache_) cached.used = false;
  for (const SceneObject& object : scene.objects) {
    Cached& cached = cache_[object.mesh.get()];
    cached.used = true;
    if (cached.buffers) continue;
    cached.mesh = object.mesh;
    cached.ball = BoundingBall(*object.mesh);
    auto buffers = std::make_unique<GlMesh>(gl_);
    buffers->Upload(WithNormals(*object.mesh));
    cached.buffers = std::move(buffers);
  }
  std::erase_if(cache_, [](const auto& entry) { return !entry.second.used; });
}

void ScenePainter::UploadGround(const Scene& scene, const Pose3& X_WR) {
  const GroundView& ground = scene.ground;
  const Eigen::Vector3d p_GR = Inverse(ground.X_WG) * X_WR.p;
  fan_ = MakeGroundFan(GroundHeight(ground), p_GR.x(), p_GR.y());
  X_WF_ = ground.X_WG * Pose3::Translation(p_GR.x(), p_GR.y(), 0.0);
  UploadRelief(scene);
  if (soil_seed_ == ground.texture_seed) return;
  const std::vector<std::uint8_t> texels = SoilTexture(ground.texture_seed);
  soil_.Image(GL_RGBA8, kSoilSide, kSoilSide, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  soil_.Sampling(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR, GL_REPEAT);
  const std::vector<std::uint8_t> lumps = SoilLumps(texels);
  lumps_.Image(GL_RGBA8, kLumpSide, kLumpSide, GL_RGBA, GL_UNSIGNED_BYTE, lumps.data());
  lumps_.Sampling(GL_LINEAR, GL_LINEAR, GL_REPEAT);
  soil_seed_ = ground.texture_seed;
}

// Most ground is under no caster at all: told apart here, it is drawn without a look at the map.
void ScenePainter::UploadFan(const Scene& scene) {
  const Eigen::Vector3d up_U = fit_.X_WU.R.transpose() * scene.ground.X_WG.R.col(2);
  // Level ground's slope against the light, and as much again for its own relief.
  const double slope = 2.0 * up_U.head<2>().norm() / std::max(up_U.z(), 0.05) + 0.5;
  parts_ = SplitFan(fan_, Inverse(fit_.X_WU) * X_WF_, [&](const Eigen::AlignedBox3d& box_U) {
    return shadow_map_.MayBeShaded(fit_, box_U, slope);
  });
  open_mesh_.Upload(fan_.vertices, parts_.open.indices);
  shaded_mesh_.Upload(fan_.vertices, parts_.shaded.indices);
}

void ScenePainter::UploadRelief(const Scene& scene) {
  const GroundView& ground = scene.ground;
  const Eigen::Vector3d sun_G = ground.X_WG.R.transpose() * scene.light.to_sun_W;
  const double diameter = scene.light.sun_angular_diameter_rad;
  const std::uint64_t key = ReliefKey(ground, sun_G, diameter);
  if (relief_key_ == key) return;
  const std::vector<float> texels = GroundRelief(ground, sun_G, diameter);
  relief_.Image(GL_RGBA16F, ground.nx, ground.ny, GL_RGBA, GL_FLOAT, texels.data());
  relief_.Sampling(GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, GL_CLAMP_TO_EDGE);
  relief_key_ = key;
}

}  // namespace dockyard
