#include "render/stereo_renderer.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "render/colour_views.h"
#include "render/compose.h"
#include "render/gl_context.h"
#include "render/gl_objects.h"
#include "render/ground_mesh.h"
#include "render/kept_lenses.h"
#include "render/level_ground.h"
#include "render/scene_painter.h"
#include "render/shading.h"
#include "render/stray_light.h"
#include "render/sun_in_lens.h"
#include "render/view_rects.h"

namespace dockyard {
namespace {

// Rays per image pixel in the middle of the image, where the tan plane is least dense; 56 deg off
// the axis there are 3.2 times as many along the radius. The board gets a view of its own.
constexpr double kWideDensity = 0.9;
constexpr double kCloseDensity = 2.0;
constexpr double kMostFlatPixels = 16e6;
constexpr double kMostClosePixels = 0.3e6;

// At the texels a pixel of a pair of 1280 px, whose map is as large as any.
ShadowDetail ShadowFor(const Camera& camera) {
  const double share = std::min(1.0, camera.width / 1280.0);
  const auto texels = [&](int most) { return 8 * static_cast<int>(std::ceil(share * most / 8.0)); };
  return {.coarse_texels = texels(kCoarseTexels), .fine_texels = texels(kFineTexels)};
}

std::unique_ptr<GlContext> CreateContext(GlBackend backend) {
  return backend == GlBackend::kOsMesa ? CreateOsMesaContext() : CreateEglSurfacelessContext();
}

}  // namespace

class StereoRenderer::Impl {
 public:
  explicit Impl(GlBackend backend)
      : context_(CreateContext(backend)),
        painter_(std::make_unique<ScenePainter>(context_->functions())),
        colour_(std::make_unique<ColourViews>()),
        sun_sight_(std::make_unique<SunSight>()) {}
  ~Impl() {
    // The objects die before the context, with it current; a refusal leaves them to the context.
    try {
      context_->MakeCurrent();
    } catch (const std::runtime_error&) {
      return;
    }
    painter_.reset();
    colour_.reset();
    sun_sight_.reset();
    wide_target_.reset();
    close_target_.reset();
  }

  GlNames Names() const {
    context_->MakeCurrent();
    const auto text = [&](GLenum name) {
      const GLubyte* said = context_->functions().GetString(name);
      return said == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(said));
    };
    return {text(GL_VENDOR), text(GL_RENDERER), text(GL_VERSION)};
  }

  /// Each channel of both views.
  std::array<std::vector<RadianceImage>, 2> Render(const Scene& scene, const StereoRig& rig,
                                                   const Pose3& X_WR,
                                                   const std::vector<Channel>& channels,
                                                   bool with_depth,
                                                   const std::array<LensRipple, 2>& ripples) {
    Prepare(scene, X_WR);
    const Pose3 X_WL = X_WR * rig.X_RL, X_WQ = X_WR * rig.X_RQ;
    return {RenderView(scene, {rig.left, ripples[0]}, X_WL, channels, with_depth),
            RenderView(scene, {rig.right, ripples[1]}, X_WQ, channels, with_depth)};
  }

  /// A single grey view, in which what a pair shares costs less: see RenderGrey.
  RadianceImage RenderGrey(const Scene& scene, const Camera& camera, const Pose3& X_WC,
                           bool with_depth, const LensRipple& ripple) {
    const bool level = HasGround(scene.ground) && IsLevel(scene.ground);
    Prepare(scene, X_WC, {.shadow = ShadowFor(camera), .fan = {}, .ground = !level});
    return std::move(
        RenderView(scene, {camera, ripple}, X_WC, {Channel::kGrey}, with_depth, level).front());
  }

  /// Each channel of one view.
  std::vector<RadianceImage> RenderFrom(const Scene& scene, const Camera& camera, const Pose3& X_WC,
                                        const Eigen::Vector3d& p_W,
                                        const std::vector<Channel>& channels) {
    Prepare(scene, {Eigen::Matrix3d::Identity(), p_W});
    const LensRipple none;
    return RenderIdeal(scene, {camera, none}, X_WC, channels, false);
  }

  ColourRadiance RenderThrough(const Scene& scene, const ColourTable& colours,
                               const ColourView& view, const std::vector<Pose3>& X_WC) {
    RequireSoundScene(scene);
    context_->MakeCurrent();
    UpdateTexture(scene);
    return colour_->Render(*painter_, texture_, scene, colours, view, X_WC);
  }

 private:
  struct BuiltLens {
    const Camera& camera;
    const LensRipple& ripple;
  };

  /// What all views share. X_WR: where the ground is finest.
  void Prepare(const Scene& scene, const Pose3& X_WR, ScenePainter::Detail detail = {}) {
    RequireSoundScene(scene);
    context_->MakeCurrent();
    detail.shadows = scene.light.sun_irradiance > 0.0;
    painter_->Prepare(scene, X_WR, detail);
    UpdateTexture(scene);
  }
  void UpdateTexture(const Scene& scene) {
    if (!HasGround(scene.ground)) return;
    texture_.Update(scene.ground, scene.light.to_sun_W, scene.light.sun_angular_diameter_rad);
  }

  /// With the stray light of the lens.
  std::vector<RadianceImage> RenderView(const Scene& scene, const BuiltLens& lens,
                                        const Pose3& X_WC, const std::vector<Channel>& channels,
                                        bool with_depth, bool level = false) {
    auto images = RenderIdeal(scene, lens, X_WC, channels, with_depth, level);
    const StrayLight& stray = scene.light.stray;
    if (stray.none()) return images;
    const SunInLens sun = sun_sight_->Of(*painter_, scene, X_WC);
    const SunStray of_sun = StrayOfSun(stray, KeptOf(lens, scene, X_WC).grid, sun);
    for (std::size_t i = 0; i < images.size(); ++i) {
      const Reflected white = Reflect(scene.light, Eigen::Vector3d::Ones(), channels[i]);
      AddStrayLight(stray, lens.camera.focal_px().mean(), of_sun, white.sun, images[i]);
    }
    return images;
  }
  const KeptLens& KeptOf(const BuiltLens& lens, const Scene& scene, const Pose3& X_WC) {
    return lenses_.Of(lens.camera, lens.ripple, scene, X_WC);
  }
  std::vector<RadianceImage> RenderIdeal(const Scene& scene, const BuiltLens& built,
                                         const Pose3& X_WC, const std::vector<Channel>& channels,
                                         bool with_depth, bool level = false) {
    const Camera& camera = built.camera;
    const KeptLens& lens = KeptOf(built, scene, X_WC);
    SizeView(camera, lens.rect, kWideDensity, kMostFlatPixels, wide_);
    painter_->PaintInto(wide_target_, X_WC, wide_);
    if (level) AddLevelGround(scene.ground, X_WC, wide_);
    const FlatView* close = nullptr;
    if (const auto about = CloseRect(scene, X_WC, lens.rect)) {
      SizeView(camera, *about, kCloseDensity, kMostClosePixels, close_);
      painter_->PaintInto(close_target_, X_WC, close_);
      if (level) AddLevelGround(scene.ground, X_WC, close_);
      close = &close_;
    }
    const Lit lit{scene, texture_, painter_->shadow()};
    std::vector<RadianceImage> images;
    for (const Channel channel : channels) {
      images.push_back(Compose(lens.grid, wide_, close, lit, X_WC, channel, with_depth));
    }
    return images;
  }

  std::unique_ptr<GlContext> context_;
  std::unique_ptr<ScenePainter> painter_;
  std::unique_ptr<ColourViews> colour_;
  std::unique_ptr<SunSight> sun_sight_;
  std::unique_ptr<GlViewTarget> wide_target_, close_target_;
  GroundTexture texture_;
  KeptLenses lenses_;
  FlatView wide_, close_;  // their memory serves the next image
};

StereoRenderer::StereoRenderer(GlBackend backend) : impl_(std::make_unique<Impl>(backend)) {}
StereoRenderer::~StereoRenderer() = default;

GlNames StereoRenderer::names() const { return impl_->Names(); }

std::array<RadianceImage, 2> StereoRenderer::RenderRadiance(
    const Scene& scene, const StereoRig& rig, const Pose3& X_WR, bool with_depth,
    const std::array<LensRipple, 2>& ripples) {
  auto seen = impl_->Render(scene, rig, X_WR, {Channel::kGrey}, with_depth, ripples);
  return {std::move(seen[0][0]), std::move(seen[1][0])};
}

RadianceImage StereoRenderer::RenderGrey(const Scene& scene, const Camera& camera,
                                         const Pose3& X_WC, bool with_depth,
                                         const LensRipple& ripple) {
  return impl_->RenderGrey(scene, camera, X_WC, with_depth, ripple);
}

std::array<std::array<RadianceImage, 3>, 2> StereoRenderer::RenderColour(
    const Scene& scene, const StereoRig& rig, const Pose3& X_WR, bool with_depth,
    const std::array<LensRipple, 2>& ripples) {
  auto seen = impl_->Render(scene, rig, X_WR, {Channel::kRed, Channel::kGreen, Channel::kBlue},
                            with_depth, ripples);
  std::array<std::array<RadianceImage, 3>, 2> colour;
  for (int view = 0; view < 2; ++view) {
    for (int channel = 0; channel < 3; ++channel) {
      colour[view][channel] = std::move(seen[view][channel]);
    }
  }
  return colour;
}

std::array<RadianceImage, 3> StereoRenderer::RenderColourFrom(const Scene& scene,
                                                              const Camera& camera,
                                                              const Pose3& X_WC,
                                                              const Eigen::Vector3d& p_W) {
  auto seen =
      impl_->RenderFrom(scene, camera, X_WC, p_W, {Channel::kRed, Channel::kGreen, Channel::kBlue});
  return {std::move(seen[0]), std::move(seen[1]), std::move(seen[2])};
}

ColourRadiance StereoRenderer::RenderThrough(const Scene& scene, const ColourTable& colours,
                                             const ColourView& view,
                                             const std::vector<Pose3>& X_WC) {
  return impl_->RenderThrough(scene, colours, view, X_WC);
}

StereoImages StereoRenderer::Render(const Scene& scene, const StereoRig& rig, const Pose3& X_WR,
                                    const SensorOptions& sensor) {
  return ExposeStereo(RenderRadiance(scene, rig, X_WR, sensor.focus.distance_m > 0.0), rig, sensor);
}

}  // namespace dockyard
