#include "controller/raposa/ferreira_sight.h"

#include <cmath>

#include "controller/raposa/visual_turn.h"

namespace dockyard::raposa {

Sight::Sight(const Nominal& nominal)
    : nominal_(nominal), vision_(nominal.ferreira_vision), tracker_(nominal) {}

void Sight::Look(const SensorFrame& sensed, bool opens) {
  const std::vector<BandChange>& changes = vision_.band_changes;
  while (next_change_ < changes.size() &&
         static_cast<double>(sensed.tick) * kTickSeconds >= changes[next_change_].at_s) {
    vision_.orange = changes[next_change_].orange;
    vision_.blue = changes[next_change_].blue;
    ++next_change_;
  }
  const RgbImage* image = RgbImageOf(sensed, kBackCamera);
  if (!image) {
    ++without_;
    return;
  }
  without_ = 0;
  seen_ = tracker_.Find(*image, vision_, opens);
}

double Sight::Bearing() const {
  const Eigen::Vector3d along = nominal_.camera.Direction(seen_.orange->ellipse.centre_px);
  return std::atan2(along.x(), along.z());
}

double Sight::EdgeOfView() const {
  return EdgeBearing(nominal_.half_view_rad, nominal_.camera.focal_px().x(), seen_.deviation_px.y(),
                     seen_.orange->ellipse.mean_radius_px());
}

GuidePlace Sight::Guide() const {
  return {
      .r_m = seen_.pair->angle.r_m, .alpha_rad = seen_.pair->alpha_rad, .bearing_rad = Bearing()};
}

Eigen::Vector2d Sight::middle_px() const {
  return {0.5 * (nominal_.camera.width - 1), 0.5 * (nominal_.camera.height - 1)};
}

double Sight::half_view_px() const {
  return nominal_.camera.focal_px().x() * std::tan(nominal_.half_view_rad);
}

}  // namespace dockyard::raposa
