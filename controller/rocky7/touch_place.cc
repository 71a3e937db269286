#include "controller/rocky7/touch_place.h"

#include <cmath>

namespace dockyard::rocky7 {
namespace {

// Places on rings about the target: half of the aim's 2 cm is left to what the detection is off.
// Assumed, 6-12 mm; 4-8 rings of 8-16 places.
constexpr double kMostShift_m = 0.01;
constexpr int kRings = 5, kOnRing = 12;
// The aims of a placement (models/rocky7, rocky7.reach_m and tilt_deg of a scenario).
constexpr double kAim_m = 0.02, kAim_rad = Radians(5.0);

// The mast must reach so far beyond the surface as it was detected: a detection's own error.
// Assumed, 0.5-1.5 cm: 8.6 mm are left where its links are 15 deg apart (mast.cc).
constexpr double kReachesBeyond_m = 0.008;

double OffAt(const NominalMast& mast, const FaceAt& face) {
  if (!AnglesTo(mast, face.p_RT - kReachesBeyond_m * face.normal_R)) return kPi;
  return ToolOff(mast, face);
}

}  // namespace

FaceAt AlongSurface(const FaceAt& face, const Eigen::Vector3d& along_R) {
  FaceAt place = face;
  const Eigen::Vector3d turn = face.bend_R * along_R;
  place.p_RT += along_R - 0.5 * along_R.dot(turn) * face.normal_R;
  place.normal_R = (face.normal_R + turn).normalized();
  return place;
}

TouchPlace PlaceToTouch(const NominalMast& mast, const FaceAt& face) {
  const Eigen::Vector3d x = face.normal_R.unitOrthogonal(), y = face.normal_R.cross(x);
  TouchPlace best{face, OffAt(mast, face)};
  if (face.bend_R.isZero()) return best;
  double least = std::pow(best.off_rad / kAim_rad, 2);
  for (int ring = 1; ring <= kRings; ++ring) {
    const double aside_m = kMostShift_m * ring / kRings;
    for (int i = 0; i < kOnRing; ++i) {
      const double angle_rad = 2.0 * kPi * i / kOnRing;
      const FaceAt place =
          AlongSurface(face, aside_m * (std::cos(angle_rad) * x + std::sin(angle_rad) * y));
      const double off_rad = OffAt(mast, place);
      const double missed = std::pow(off_rad / kAim_rad, 2) + std::pow(aside_m / kAim_m, 2);
      if (missed >= least) continue;
      least = missed;
      best = {place, off_rad};
    }
  }
  return best;
}

}  // namespace dockyard::rocky7
