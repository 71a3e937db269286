#include "sim/app/raposa/eye_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "controller/raposa/marks_projection.h"
#include "sim/base/json.h"

namespace dockyard::raposa {
namespace {

constexpr std::uint8_t kYellow[3] = {255, 230, 0}, kCyan[3] = {0, 230, 255};

void Put(RgbImage& image, double u, double v, const std::uint8_t (&rgb)[3]) {
  const int x = static_cast<int>(std::lround(u)), y = static_cast<int>(std::lround(v));
  if (x < 0 || y < 0 || x >= image.width || y >= image.height) return;
  std::copy(rgb, rgb + 3,
            &image.pixels[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                               static_cast<std::size_t>(x))]);
}

void Outline(RgbImage& image, const ConvexPolygon& polygon, const std::uint8_t (&rgb)[3]) {
  for (int i = 0; i < polygon.count; ++i) {
    const Eigen::Vector2d a = polygon.corners[static_cast<std::size_t>(i)];
    const Eigen::Vector2d b = polygon.corners[static_cast<std::size_t>((i + 1) % polygon.count)];
    const int steps = 1 + static_cast<int>((b - a).cwiseAbs().maxCoeff());
    for (int k = 0; k <= steps; ++k) {
      const Eigen::Vector2d p = a + (b - a) * (static_cast<double>(k) / steps);
      Put(image, p.x(), p.y(), rgb);
    }
  }
}

/// The camera about the guide, with its sigma.
struct Angle {
  double alpha_rad = 0.0, sigma_rad = 0.0, r_m = 0.0;
};
Angle AngleOf(const PyramidFit& fit) {
  const Pose2 X_DV = Inverse(fit.X_VD);
  const Eigen::Vector2d p(fit.X_VD.x, fit.X_VD.y);
  // alpha = bearing + pi - heading
  const Eigen::Vector3d J(-p.y() / p.squaredNorm(), p.x() / p.squaredNorm(), -1.0);
  return {std::atan2(X_DV.y, X_DV.x), std::sqrt(J.dot(fit.covariance * J)), p.norm()};
}

Json ToJson(const GuideSighting& guide) {
  return {{"centre_px", {guide.centre_px.x(), guide.centre_px.y()}},
          {"bearing_deg", Degrees(guide.bearing_rad)},
          {"bearing_sigma_deg", Degrees(guide.bearing_sigma_rad)},
          {"down_deg", Degrees(guide.down_rad)},
          {"range_m", guide.range_m},
          {"range_sigma_m", guide.range_sigma_m},
          {"clipped", guide.clipped}};
}

}  // namespace

void DrawPyramid(const Nominal& nominal, const PyramidSighting& sighting, RgbImage& image) {
  if (!sighting.guide) return;
  if (!sighting.fits.empty()) {
    const PyramidFit& fit = sighting.fits.front();
    const auto marks = ProjectMarks(nominal, {fit.X_VD, fit.down_m, fit.pitch_rad, fit.roll_rad});
    if (!marks) return;
    for (const ConvexPolygon& strip : marks->strips) Outline(image, strip, kCyan);
    Outline(image, marks->guide, kYellow);
    return;
  }
  for (int k = -4; k <= 4; ++k) {
    Put(image, sighting.guide->centre_px.x() + k, sighting.guide->centre_px.y(), kYellow);
    Put(image, sighting.guide->centre_px.x(), sighting.guide->centre_px.y() + k, kYellow);
  }
}

void PrintPyramid(const PyramidSighting& sighting, bool as_json) {
  if (as_json) {
    Json json{{"guide", sighting.guide ? ToJson(*sighting.guide) : Json()},
              {"fits", Json::array()}};
    for (const PyramidFit& fit : sighting.fits) {
      const Angle angle = AngleOf(fit);
      json["fits"].push_back({{"x_m", fit.X_VD.x},
                              {"y_m", fit.X_VD.y},
                              {"heading_deg", Degrees(fit.X_VD.heading)},
                              {"r_m", angle.r_m},
                              {"alpha_deg", Degrees(angle.alpha_rad)},
                              {"alpha_sigma_deg", Degrees(angle.sigma_rad)},
                              {"misfit", fit.misfit}});
    }
    json["warnings"] = Json::array();
    std::printf("%s\n", json.dump(2).c_str());
    return;
  }
  if (!sighting.guide) {
    std::printf("no guide\n");
    return;
  }
  std::printf("guide: %.1f deg to the left, %.3f m (sigma %.3f)%s\n",
              Degrees(sighting.guide->bearing_rad), sighting.guide->range_m,
              sighting.guide->range_sigma_m, sighting.guide->clipped ? "; clipped" : "");
  for (const PyramidFit& fit : sighting.fits) {
    const Angle angle = AngleOf(fit);
    std::printf("pyramid: alpha %.1f deg (sigma %.1f), r %.3f m, misfit %.2f\n",
                Degrees(angle.alpha_rad), Degrees(angle.sigma_rad), angle.r_m, fit.misfit);
  }
  if (sighting.fits.empty()) std::printf("no blue marks that fit\n");
}

}  // namespace dockyard::raposa
