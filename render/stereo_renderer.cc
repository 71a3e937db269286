#include "render/stereo_renderer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "render/fisheye_warp.h"
#include "render/gl_context.h"
#include "render/gl_objects.h"
#include "render/scene_painter.h"

namespace dockyard {
namespace {

// Flat pixels per image pixel in the middle of the picture, where the tan plane is least dense; 56
// deg off the axis it has 3.2 times as many along the radius. The board gets a view of its own.
constexpr double kWideDensity = 0.85;
constexpr double kCloseDensity = 3.0;
constexpr int kSamples = 1;
constexpr ShadowEffort kWideEffort{.searches = 4, .taps = 8};
constexpr ShadowEffort kCloseEffort{.searches = 4, .taps = 6};
constexpr double kMostFlatPixels = 16e6;
constexpr double kMostClosePixels = 0.3e6;

std::unique_ptr<GlContext> CreateContext(GlBackend backend) {
  return backend == GlBackend::kOsMesa ? CreateOsMesaContext() : CreateEglSurfacelessContext();
}

FlatView Sized(const Camera& camera, const TanRect& rect, double density, double most_pixels) {
  const double w = rect.right - rect.left, h = rect.bottom - rect.top;
  const Eigen::Vector2d f = camera.focal_px();
  const double wanted = density * density * f.x() * f.y() * w * h;
  const double scale = density * std::min(1.0, std::sqrt(most_pixels / wanted));
  return {.rect = rect,
          .width = std::max(2, static_cast<int>(std::ceil(scale * f.x() * w))),
          .height = std::max(2, static_cast<int>(std::ceil(scale * f.y() * h))),
          .values = {}};
}

// The board's outline in the tan plane, cut to the picture; none when it does not stand wholly
// before the camera or lies outside the picture.
std::optional<TanRect> BoardRect(const BoardView& view, const Pose3& X_WC, const TanRect& image) {
  const Pose3 X_CB = Inverse(X_WC) * view.X_WB;
  TanRect rect{.left = 1e9, .top = 1e9, .right = -1e9, .bottom = -1e9};
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      const Eigen::Vector3d p_C =
          X_CB * Eigen::Vector3d(x * view.board.width_m, y * view.board.height_m, 0.0);
      if (p_C.z() < 0.05) return std::nullopt;
      const Eigen::Vector2d tan = p_C.head<2>() / p_C.z();
      rect.left = std::min(rect.left, tan.x());
      rect.right = std::max(rect.right, tan.x());
      rect.top = std::min(rect.top, tan.y());
      rect.bottom = std::max(rect.bottom, tan.y());
    }
  }
  const double margin = 0.03 * (rect.right - rect.left + rect.bottom - rect.top) + 0.01;
  rect = {std::max(rect.left - margin, image.left), std::max(rect.top - margin, image.top),
          std::min(rect.right + margin, image.right), std::min(rect.bottom + margin, image.bottom)};
  if (rect.right - rect.left < 0.01 || rect.bottom - rect.top < 0.01) return std::nullopt;
  return rect;
}

}  // namespace

class StereoRenderer::Impl {
 public:
  explicit Impl(GlBackend backend)
      : context_(CreateContext(backend)),
        painter_(std::make_unique<ScenePainter>(context_->functions())) {}
  ~Impl() {
    // The objects die before the context, with it current; a refusal leaves them to the context.
    try {
      context_->MakeCurrent();
    } catch (const std::runtime_error&) {
      return;
    }
    painter_.reset();
    wide_target_.reset();
    close_target_.reset();
  }

  std::array<RadianceImage, 2> RenderRadiance(const Scene& scene, const StereoRig& rig,
                                              const Pose3& X_WR) {
    RequireSoundScene(scene);
    context_->MakeCurrent();
    painter_->Prepare(scene, X_WR);
    return {RenderEye(scene, ScaleOf(0, rig.left), X_WR * rig.X_RL),
            RenderEye(scene, ScaleOf(1, rig.right), X_WR * rig.X_RQ)};
  }

 private:
  // A run's lenses stay: their tables are made once.
  const TanScale& ScaleOf(int eye, const Camera& camera) {
    std::optional<TanScale>& scale = scales_[eye];
    if (!scale || !(scale->camera() == camera)) scale.emplace(camera);
    return *scale;
  }

  RadianceImage RenderEye(const Scene& scene, const TanScale& scale, const Pose3& X_WC) {
    const Camera& camera = scale.camera();
    const TanRect rect = ImageRect(camera, scale);
    FlatView wide = Sized(camera, rect, kWideDensity, kMostFlatPixels);
    PaintInto(wide_target_, X_WC, kWideEffort, wide);
    std::optional<FlatView> close;
    if (scene.board.board.width_m > 0.0 && scene.board.board.height_m > 0.0) {
      if (const auto board = BoardRect(scene.board, X_WC, rect)) {
        close = Sized(camera, *board, kCloseDensity, kMostClosePixels);
        PaintInto(close_target_, X_WC, kCloseEffort, *close);
      }
    }
    return WarpToFisheye(camera, scale, wide, close ? &*close : nullptr);
  }

  void PaintInto(std::unique_ptr<GlGreyTarget>& target, const Pose3& X_WC, ShadowEffort effort,
                 FlatView& view) {
    if (!target || target->width() < view.width || target->height() < view.height) {
      const int w = std::max(view.width, target ? target->width() : 0);
      const int h = std::max(view.height, target ? target->height() : 0);
      target = std::make_unique<GlGreyTarget>(context_->functions(), w, h, kSamples);
    }
    target->Bind();
    painter_->Paint(X_WC, view.rect, view.width, view.height, effort);
    view.values.resize(static_cast<std::size_t>(view.width) * view.height);
    target->Read(view.width, view.height, view.values.data());
  }

  std::unique_ptr<GlContext> context_;
  std::unique_ptr<ScenePainter> painter_;
  std::unique_ptr<GlGreyTarget> wide_target_, close_target_;
  std::array<std::optional<TanScale>, 2> scales_;
};

StereoRenderer::StereoRenderer(GlBackend backend) : impl_(std::make_unique<Impl>(backend)) {}
StereoRenderer::~StereoRenderer() = default;

std::array<RadianceImage, 2> StereoRenderer::RenderRadiance(const Scene& scene,
                                                            const StereoRig& rig,
                                                            const Pose3& X_WR) {
  return impl_->RenderRadiance(scene, rig, X_WR);
}

StereoImages StereoRenderer::Render(const Scene& scene, const StereoRig& rig, const Pose3& X_WR,
                                    const SensorOptions& sensor) {
  return ExposeStereo(RenderRadiance(scene, rig, X_WR), rig, sensor);
}

}  // namespace dockyard
