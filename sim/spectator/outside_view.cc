#include "sim/spectator/outside_view.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/spectator/near_view.h"
#include "sim/spectator/sight_lines.h"
#include "sim/spectator/viewpoint.h"

namespace dockyard {
namespace {

// Assumed, for a image as a photographer would take it: a view of 25-45 deg; the radiance that
// 5 % of the pixels exceed is put at 0.5-0.8.
constexpr double kVerticalFov_rad = 32.0 * kPi / 180.0;
constexpr double kBrightShare = 0.05, kBrightLevel = 0.6;

/// The first row whose rays go downwards: above it there is sky. 0 where few rows are below it.
int HorizonRow(const Camera& camera, const Pose3& X_WC) {
  const int last = camera.height - 1 - camera.height / 10;
  for (int v = 0; v <= last; ++v) {
    const Eigen::Vector3d ray_C =
        camera.Direction({0.5 * (camera.width - 1), static_cast<double>(v)});
    if ((X_WC.R * ray_C).z() < 0.0) return v;
  }
  return 0;
}

/// Of the rows from `first_row` on: how much sky is in an image does not change it.
double GainOf(const std::array<RadianceImage, 3>& radiance, int first_row) {
  const std::vector<float>& all = radiance[1].values;
  std::vector<float> green(all.begin() + std::ptrdiff_t{first_row} * radiance[1].width, all.end());
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

constexpr std::size_t kTried = 40;  // samples at which the robot is to be whole in the image

Sights SightsOf(const LoggedRun& run, const StageShapes& shapes, std::size_t first,
                std::size_t last) {
  Sights sights;
  sights.X_WD = ToGround(run.X_WD[first]);
  sights.to_sun_W = shapes.light.to_sun_W;
  sights.places_W.push_back(run.X_WD[first].p);
  for (std::size_t i = first; i <= last; ++i) sights.places_W.push_back(run.X_WO.front()[i].p);
  const SightLines lines(run, shapes);
  const std::size_t step = std::max<std::size_t>(1, (last - first) / kTried);
  for (std::size_t i = first; i <= last; i += step) {
    const auto corners = lines.RobotCorners_W(i);
    sights.corners_W.insert(sights.corners_W.end(), corners.begin(), corners.end());
  }
  return sights;
}

Pose3 PoseOf(const LoggedRun& run, const StageShapes& shapes, const OutsideOptions& options,
             const Camera& camera, std::size_t first, std::size_t last) {
  if (!options.at) return SpectatorPose(SightsOf(run, shapes, first, last), camera, options.from_D);
  if (options.from_D) {
    const Pose3 X_WD = FromGround(ToGround(run.X_WD[first]), 0.0);
    return PoseAimedAt(X_WD * *options.from_D, AimPlace(*options.at, run, shapes, first));
  }
  const NearView view = FindNearView(run, shapes, *options.at, first, last, kVerticalFov_rad);
  return PoseAimedAt(view.from_W, view.at_W);
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
      X_WC_(PoseOf(run, shapes, options, camera_, first, last)),
      renderer_(renderer) {}

RgbImage OutsideView::Image(std::size_t sample) {
  const Eigen::Vector3d p_W =
      at_ ? AimPlace(*at_, run_, shapes_, sample) : run_.X_WO.front()[sample].p;
  if (at_) X_WC_ = PoseAimedAt(X_WC_.p, p_W);
  const auto radiance = renderer_.RenderColourFrom(scenes_.At(sample), camera_, X_WC_, p_W);
  if (gain_ == 0.0) gain_ = GainOf(radiance, HorizonRow(camera_, X_WC_));
  RgbImage image{camera_.width, camera_.height, {}};
  image.pixels.reserve(3 * radiance[0].values.size());
  for (std::size_t i = 0; i < radiance[0].values.size(); ++i) {
    for (const RadianceImage& channel : radiance) {
      image.pixels.push_back(Srgb(gain_ * channel.values[i]));
    }
  }
  return image;
}

}  // namespace dockyard
