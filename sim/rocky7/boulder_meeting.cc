#include "sim/rocky7/boulder_meeting.h"

#include <cmath>
#include <variant>

namespace dockyard::rocky7 {
namespace {

using Eigen::Vector3d;

// Beyond this from R no part of the rover is.
constexpr double kReach_m = 1.3;
constexpr int kOnRim = 12, kOnLink = 8;

}  // namespace

bool MeetsBoulder(const WheeledBody& rover, const RobotModel& robot, const StarBody& boulder_G) {
  const Pose3& X_GB = rover.body().X_GL;
  if ((X_GB.p - boulder_G.centre).norm() > boulder_G.radius_m + kReach_m) return false;
  const auto in = [&](const Vector3d& p_G) { return DepthIn(boulder_G, p_G).depth_m > 0.0; };
  const WheelModel& tyre = robot.rover.tyre;
  for (int w = 0; w < rover.wheel_count(); ++w) {
    for (int i = 0; i < 2 * kOnRim; ++i) {
      const double angle = 2.0 * kPi * i / kOnRim;
      const Vector3d p_K(tyre.rim_radius_m * std::cos(angle),
                         (i < kOnRim ? 0.5 : -0.5) * tyre.width_m,
                         tyre.rim_radius_m * std::sin(angle));
      if (in(rover.wheel(w).X_GL * p_K)) return true;
    }
  }
  const LinkModel& body = robot.rover.body;
  const auto* box = std::get_if<BoxShape>(&body.collisions.front().shape);
  const double bottom_m = body.p_LoCom_L.z() - 0.5 * box->size_m.z(),
               top_m = body.p_LoCom_L.z() + 0.5 * box->size_m.z();
  for (const Polygon& part : robot.rover.plan.body) {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Eigen::Vector2d &from = part[i], &to = part[(i + 1) % part.size()];
      for (int k = 0; k < kOnLink; ++k) {
        const Eigen::Vector2d at = from + (to - from) * k / kOnLink;
        if (in(X_GB * Vector3d(at.x(), at.y(), top_m))) return true;
        if (in(X_GB * Vector3d(at.x(), at.y(), bottom_m))) return true;
      }
    }
  }
  const MastModel& mast = *robot.rover.mast;
  const Pose3& X_GU = rover.tree().motion(rover.mast_link(kMastShoulder)).X_GL;
  const Pose3& X_GK = rover.tree().motion(rover.mast_link(kMastElbow)).X_GL;
  const double can_m = mast.link2_m - mast.instrument.length_m;
  for (int i = 0; i <= kOnLink; ++i) {
    const double share = static_cast<double>(i) / kOnLink;
    if (in(X_GU * Vector3d(share * mast.link1_m, 0.0, 0.0))) return true;
    if (in(X_GK * Vector3d(share * can_m, 0.0, 0.0))) return true;
    // The can's side; its front rim bears.
    const double angle = 2.0 * kPi * share, r = mast.instrument.radius_m;
    if (in(X_GK * Vector3d(can_m, r * std::cos(angle), r * std::sin(angle)))) return true;
  }
  const StereoRig& pair_K = robot.mast_pair.nominal;
  return in(X_GK * pair_K.X_RL.p) || in(X_GK * pair_K.X_RQ.p);
}

}  // namespace dockyard::rocky7
