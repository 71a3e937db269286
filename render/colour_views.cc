#include "render/colour_views.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "controller/base/check.h"
#include "render/ground_mesh.h"
#include "render/ground_sectors.h"
#include "render/level_ground.h"
#include "render/view_rects.h"
#include "render/view_turn.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostLenses = 8;  // that are kept
constexpr double kMostRays = 4e6;
// Beyond this number the thing is large enough for the wide view, or for kWideRays where that has
// fewer.
constexpr double kMostCloseRays = 90e3;
constexpr int kBlurRoom_px = 6;  // round the lit part, for a blur of 1.5 px
// Some 40 cm^2 of robot and target, seen from less than a metre: texels of millimetres.
constexpr ShadowDetail kShadow{.coarse_texels = 384, .fine_texels = 256, .near_m = 1.5};
// From 0.1 m over the ground rings a few pixels apart at 400 px/rad, spokes 12 px.
constexpr int kFanStep = 3;
constexpr int kSectorsBeside = 6;  // more of the ground's fan for poses beside the middle one

Pose3 Rolled(const Pose3& X_WC) { return {X_WC.R * RotZ(kViewTurn_rad), X_WC.p}; }

FanPart FanOf(const Scene& scene, const Pose3& X_WC, const TanRect& rect) {
  const Pose3& X_WG = scene.ground.X_WG;
  Pose3 X_FC = Inverse(X_WG) * X_WC;  // the fan stands under the camera
  X_FC.p.x() = X_FC.p.y() = 0.0;
  const SectorRange range = VisibleSectors(X_FC, rect);
  FanPart part{.step = kFanStep, .least_ring_m = 0.03, .ring_per_r2 = 0.1};
  if (range.count + 2 * kSectorsBeside >= kGroundSectors) return part;
  part.first = (range.first + kGroundSectors - kSectorsBeside) % kGroundSectors;
  part.count = range.count + 2 * kSectorsBeside;
  return part;
}

// The smallest rect in the tan plane of the rolled views that holds all pixels of the spans, and a
// little more: no ray falls beside the view, and thin bodies can be interpolated at its border.
TanRect RectOf(const Camera& camera, const PixelGrid& grid, const std::vector<PixelSpan>& spans) {
  const ViewTurn turn;
  TanRect rect{.left = 1e9, .top = 1e9, .right = -1e9, .bottom = -1e9};
  const auto add = [&](int x, int y) {
    const std::size_t i = static_cast<std::size_t>(y) * (grid.width + 1) + x;
    const Tan tan = turn.ToView(Tan{grid.x[i], grid.y[i]});
    rect = {std::min<double>(rect.left, tan.x), std::min<double>(rect.top, tan.y),
            std::max<double>(rect.right, tan.x), std::max<double>(rect.bottom, tan.y)};
  };
  for (int y = 0; y < grid.height; ++y) {
    const PixelSpan& span = spans[static_cast<std::size_t>(y)];
    for (int x = span.first; x <= span.last && span.last > span.first; ++x) {
      add(x, y);
      add(x, y + 1);
    }
  }
  const double margin = 2.0 / camera.focal_px().minCoeff();
  return {rect.left - margin, rect.top - margin, rect.right + margin, rect.bottom + margin};
}

}  // namespace

ColourViews::Lens ColourViews::MakeLens(const ColourView& view) {
  CheckHole(view.hole);
  DOCKYARD_CHECK(view.vignetting_exponent >= 0.0 && view.vignetting_exponent <= 20.0);
  DOCKYARD_CHECK(view.rays >= 0.5 && view.rays <= 4.0);
  const Camera& camera = view.camera;
  const TanScale scale(camera, view.ripple);
  DOCKYARD_CHECK(!scale.pupil_moves());
  const int w = camera.width, h = camera.height;
  std::vector<float> shares(static_cast<std::size_t>(w) * h);
  int left = w, right = -1, top = h, bottom = -1;
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const Eigen::Vector2d tan = scale(Eigen::Vector2d(x, y));
      const double cosine = 1.0 / std::sqrt(1.0 + tan.squaredNorm());
      const double share =
          ShareThroughHole(view.hole, tan) * std::pow(cosine, view.vignetting_exponent);
      shares[static_cast<std::size_t>(y) * w + x] = static_cast<float>(share);
      if (share <= 0.0) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  if (right < 0) throw std::invalid_argument("view: no pixel sees through the hole");
  left = std::max(left - kBlurRoom_px, 0);
  top = std::max(top - kBlurRoom_px, 0);
  right = std::min(right + kBlurRoom_px, w - 1);
  bottom = std::min(bottom + kBlurRoom_px, h - 1);
  Lens lens{.view = view, .x0 = left, .y0 = top, .spans = {}, .shares = {}};
  lens.grid = {.width = right - left + 1, .height = bottom - top + 1, .x = {}, .y = {}};
  for (int y = top; y <= bottom + 1; ++y) {
    for (int x = left; x <= right + 1; ++x) {
      const Eigen::Vector2d tan = scale(Eigen::Vector2d(x - 0.5, y - 0.5));
      lens.grid.x.push_back(static_cast<float>(tan.x()));
      lens.grid.y.push_back(static_cast<float>(tan.y()));
    }
  }
  for (int y = top; y <= bottom; ++y) {
    const float* row = &shares[static_cast<std::size_t>(y) * w];
    PixelSpan span{.first = lens.grid.width, .last = 0};
    for (int x = left; x <= right; ++x) {
      lens.shares.push_back(row[x]);
      if (row[x] <= 0.0f) continue;
      span.first = std::min(span.first, x - left);
      span.last = x - left + 1;
    }
    if (span.last == 0) span.first = 0;
    lens.spans.push_back(span);
  }
  lens.rect = RectOf(camera, lens.grid, lens.spans);
  return lens;
}

const ColourViews::Lens& ColourViews::LensOf(const ColourView& view) {
  for (const Lens& lens : lenses_) {
    if (lens.view == view) return lens;
  }
  if (lenses_.size() >= kMostLenses) lenses_.clear();
  lenses_.push_back(MakeLens(view));
  return lenses_.back();
}

void ColourViews::AddStray(ScenePainter& painter, const Scene& scene, const ColourTable& colours,
                           const Lens& lens, const Pose3& X_WC,
                           std::array<RadianceImage, 3>& part) {
  const StrayLight& stray = scene.light.stray;
  SunInLens sun = sun_sight_.Of(painter, scene, X_WC);
  if (sun.share > 0.0) {
    sun.share *= ShareThroughHole(lens.view.hole, sun.to_sun_C.head<2>() / sun.to_sun_C.z());
  }
  const SunStray of_sun = StrayOfSun(stray, lens.grid, sun);
  const Rgb white = LightBy(colours, scene, X_WC).sky.sun;
  const float irradiance[3] = {white.r, white.g, white.b};
  for (std::size_t c = 0; c < part.size(); ++c) {
    AddStrayLight(stray, lens.view.camera.focal_px().mean(), of_sun, irradiance[c], part[c]);
  }
}

ColourRadiance ColourViews::Render(ScenePainter& painter, const GroundTexture& texture,
                                   const Scene& scene, const ColourTable& colours,
                                   const ColourView& view, const std::vector<Pose3>& X_WC) {
  DOCKYARD_CHECK(!X_WC.empty());
  const Lens& lens = LensOf(view);
  const Pose3& middle = X_WC[X_WC.size() / 2];
  const bool level = HasGround(scene.ground) && IsLevel(scene.ground);
  painter.Prepare(scene, {Eigen::Matrix3d::Identity(), middle.p},
                  {.shadow = kShadow,
                   .shadows = scene.light.sun_irradiance > 0.0,
                   .fan = FanOf(scene, Rolled(middle), lens.rect),
                   .ground = !level});
  const Lit lit{scene, texture, painter.shadow()};
  ColourRadiance light{
      .width = view.camera.width, .height = view.camera.height, .x0 = lens.x0, .y0 = lens.y0};
  for (RadianceImage& channel : light.part) {
    channel = {.width = lens.grid.width, .height = lens.grid.height, .values = {}};
    channel.values.assign(lens.shares.size(), 0.0f);
  }
  for (const Pose3& X : X_WC) {
    SizeView(view.camera, lens.rect, view.rays, kMostRays, wide_);
    const Pose3 X_WV = Rolled(X);
    painter.PaintInto(wide_target_, X_WV, wide_);
    if (level) AddLevelGround(scene.ground, X_WV, wide_);
    const FlatView* close = nullptr;
    int close_rays = kCloseRays;
    if (const auto about = CloseRect(scene, X_WV, lens.rect)) {
      const auto fits = [&] {
        SizeView(view.camera, *about, close_rays, kMostRays, close_);
        return static_cast<double>(close_.width) * close_.height <= kMostCloseRays;
      };
      bool wanted = fits();
      if (!wanted && view.rays < kWideRays) {
        close_rays = kWideRays;
        wanted = fits();
      }
      if (wanted) {
        painter.PaintInto(close_target_, X_WV, close_);
        if (level) AddLevelGround(scene.ground, X_WV, close_);
        close = &close_;
      }
    }
    ComposeColour(lens.grid, lens.spans, wide_, close, close_rays, lit, colours, X, light.part);
  }
  const float per = 1.0f / static_cast<float>(X_WC.size());
  if (!scene.light.stray.none()) {
    for (RadianceImage& channel : light.part) {
      for (float& value : channel.values) value *= per;
    }
    AddStray(painter, scene, colours, lens, middle, light.part);
    for (RadianceImage& channel : light.part) {
      for (std::size_t i = 0; i < lens.shares.size(); ++i) channel.values[i] *= lens.shares[i];
    }
    return light;
  }
  for (RadianceImage& channel : light.part) {
    for (std::size_t i = 0; i < lens.shares.size(); ++i) channel.values[i] *= per * lens.shares[i];
  }
  return light;
}

}  // namespace dockyard
