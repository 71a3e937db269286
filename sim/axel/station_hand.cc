#include "sim/axel/station_hand.h"

#include <cmath>

namespace dockyard::axel {
namespace {

constexpr double kSeconds = 4.0;  // from hold to let go; assumed, 1-20
// Of the hand, a critically damped spring on the station's mass. Against the feet's friction of
// some 300 N a station of 35 kg stays back by 2 mm. Assumed, 30-100.
constexpr double kStiffness_rad_s = 60.0;

// Minimum jerk (Flash and Hogan 1985): share of the way, and its rate times the whole time.
struct Share {
  double way = 0.0, rate = 0.0;
};
Share MinimumJerk(double t) {
  return {t * t * t * (10.0 + t * (-15.0 + 6.0 * t)), 30.0 * t * t * (1.0 - t) * (1.0 - t)};
}

double HeadingOf(const Pose3& X) { return std::atan2(X.R(1, 0), X.R(0, 0)); }

}  // namespace

bool StationHand::Holds(double time_s) const {
  return time_s >= move_.at_s && time_s < move_.at_s + kSeconds;
}

void StationHand::Hold(double time_s, StationBody& station) {
  const Eigen::Vector3d p_GC = station.CentreOfMass();
  if (!begun_) {
    begun_ = true;
    p_GM_ = station.X_GM().p;
    p_MC_G_ = p_GC - p_GM_;
    heading_rad_ = HeadingOf(station.motion().X_GL);
  }
  const Share share = MinimumJerk((time_s - move_.at_s) / kSeconds);
  const Eigen::Vector3d whole_G =
      RotZ(heading_rad_) * Eigen::Vector3d(move_.forward_m, move_.left_m, 0.0);
  carried_G_ = share.way * whole_G;
  const Eigen::Vector3d lever_G = RotZ(share.way * move_.turn_rad) * p_MC_G_;
  const double turn_rate = share.rate * move_.turn_rad / kSeconds;
  const Eigen::Vector3d v_wanted =
      share.rate / kSeconds * whole_G + turn_rate * Eigen::Vector3d::UnitZ().cross(lever_G);
  const Eigen::Vector3d away = p_GM_ + carried_G_ + lever_G - p_GC;
  const LinkMotion& motion = station.motion();
  const Eigen::Vector3d v = motion.VelocityAt(p_GC);
  const double w = kStiffness_rad_s;
  Eigen::Vector3d force_G = station.link().mass_kg * (w * w * away + 2.0 * w * (v_wanted - v));
  force_G.z() = 0.0;
  station.AddForce(force_G, p_GC);
  const double turn = WrapPi(heading_rad_ + share.way * move_.turn_rad - HeadingOf(motion.X_GL));
  const double turn_about_z = w * w * turn + 2.0 * w * (turn_rate - motion.w_GL_G.z());
  station.AddTorque(Eigen::Vector3d(0.0, 0.0, turn_about_z / station.InverseInertia()(2, 2)));
}

}  // namespace dockyard::axel
