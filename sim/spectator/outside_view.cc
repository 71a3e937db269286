#include "sim/spectator/outside_view.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/spectator/viewpoint.h"

namespace dockyard {
namespace {

// Assumed, for a picture as a photographer would take it: a view of 25-45 deg; the radiance that
// 5 % of the pixels exceed is put at 0.5-0.8.
constexpr double kVerticalFov_rad = 32.0 * kPi / 180.0;
constexpr double kBrightShare = 0.05, kBrightLevel = 0.6;

double GainOf(const std::array<RadianceImage, 3>& radiance) {
  std::vector<float> green = radiance[1].values;
  const auto at = green.begin() + static_cast<std::ptrdiff_t>((1.0 - kBrightShare) *
                                                              static_cast<double>(green.size()));
  std::nth_element(green.begin(), at, green.end());
  return *at > 0.0f ? kBrightLevel / *at : 1.0;
}

/// The transfer of sRGB (IEC 61966-2-1), in 8 bits.
std::uint8_t Srgb(double linear) {
  const double x = std::clamp(linear, 0.0, 1.0);
  const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * y));
}

// Radius about the aim point; assumed, 0.2-0.5: a gripper or a tip with what it meets.
constexpr double kAboutPoint_m = 0.3;

Sights SightsOf(const LoggedRun& run, const StageShapes& shapes, const std::optional<Aim>& at,
                std::size_t first, std::size_t last) {
  Sights sights;
  sights.X_WD = ToGround(run.X_WD[first]);
  sights.to_sun_W = shapes.light.to_sun_W;
  if (at) {
    sights.margin_m = kAboutPoint_m;
    for (std::size_t i = first; i <= last; ++i) {
      sights.places_W.push_back(AimPlace(*at, run, shapes, i));
    }
    return sights;
  }
  sights.places_W.push_back(run.X_WD[first].p);
  for (std::size_t i = first; i <= last; ++i) sights.places_W.push_back(run.X_WO.front()[i].p);
  return sights;
}

}  // namespace

OutsideView::OutsideView(const LoggedRun& run, const StageShapes& shapes,
                         const OutsideOptions& options, std::size_t first, std::size_t last,
                         StereoRenderer& renderer)
    : run_(run),
      shapes_(shapes),
      at_(options.at),
      scenes_(run, shapes),
      camera_(PinholeCamera(options.width, options.height, kVerticalFov_rad)),
      X_WC_(SpectatorPose(SightsOf(run, shapes, options.at, first, last), camera_, options.from_D)),
      renderer_(renderer) {}

RgbImage OutsideView::Picture(std::size_t sample) {
  const Eigen::Vector3d p_W =
      at_ ? AimPlace(*at_, run_, shapes_, sample) : run_.X_WO.front()[sample].p;
  if (at_) X_WC_ = LookAt(X_WC_.p, p_W);
  const auto radiance = renderer_.RenderColourFrom(scenes_.At(sample), camera_, X_WC_, p_W);
  if (gain_ == 0.0) gain_ = GainOf(radiance);
  RgbImage picture{camera_.width, camera_.height, {}};
  picture.pixels.reserve(3 * radiance[0].values.size());
  for (std::size_t i = 0; i < radiance[0].values.size(); ++i) {
    for (const RadianceImage& channel : radiance) {
      picture.pixels.push_back(Srgb(gain_ * channel.values[i]));
    }
  }
  return picture;
}

}  // namespace dockyard
