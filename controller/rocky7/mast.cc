#include "controller/rocky7/mast.h"

#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

// The tool's tilt jumps with the stand-off where the mast is stretched out: at 15 deg between the
// links by 4.4 deg for each centimetre. Assumed, 10-30 deg.
constexpr double kLeastBend_rad = Radians(15.0);
// Of the search for the nearest tilt. Assumed, 0.02-0.2 deg: far below what matters.
constexpr double kTiltStep_rad = Radians(0.05);
constexpr double kMostTilt_rad = Radians(90.0);
// Rounds to aim the cameras. They swing about the joints as they turn.
constexpr int kAimRounds = 12;

bool WithinLimits(const NominalMast& mast, const MastAngles& angles) {
  for (std::size_t i = 0; i < angles.size(); ++i) {
    if (angles[i] < mast.low_rad[i] || angles[i] > mast.high_rad[i]) return false;
  }
  return true;
}

std::optional<Stance> StanceAt(const NominalMast& mast, double up_m, double tool_up_rad) {
  const double sine = (up_m - mast.link2_m * std::sin(tool_up_rad)) / mast.link1_m;
  if (std::abs(sine) > 1.0) return std::nullopt;
  const double first_up_rad = std::asin(sine);
  const double bend_rad = first_up_rad - tool_up_rad;
  const MastAngles angles{0.0, -first_up_rad, bend_rad};
  if (bend_rad < kLeastBend_rad || first_up_rad < 0.0 || !WithinLimits(mast, angles)) {
    return std::nullopt;
  }
  return Stance{
      .stand_off_m = mast.link1_m * std::cos(first_up_rad) + mast.link2_m * std::cos(tool_up_rad),
      .tool_up_rad = tool_up_rad,
      .first_up_rad = first_up_rad};
}

}  // namespace

Pose3 SecondLink(const NominalMast& mast, const MastAngles& angles) {
  const Eigen::Matrix3d R_roll = RotZ(angles[0]);
  const Eigen::Vector3d p_elbow =
      mast.p_RM + R_roll * RotY(angles[1]) * Eigen::Vector3d(mast.link1_m, 0.0, 0.0);
  return {R_roll * RotY(angles[1] + angles[2]), p_elbow};
}

Eigen::Vector3d FaceCentre(const NominalMast& mast, const MastAngles& angles) {
  return SecondLink(mast, angles) * Eigen::Vector3d(mast.link2_m, 0.0, 0.0);
}

std::optional<MastAngles> AnglesTo(const NominalMast& mast, const Eigen::Vector3d& p_RF) {
  const Eigen::Vector3d at = p_RF - mast.p_RM;
  const double out_m = at.head<2>().norm();
  const double away2_m2 = at.squaredNorm();
  const double cosine = (away2_m2 - mast.link1_m * mast.link1_m - mast.link2_m * mast.link2_m) /
                        (2.0 * mast.link1_m * mast.link2_m);
  if (out_m < 1e-6 || std::abs(cosine) > 1.0) return std::nullopt;
  const double bend_rad = std::acos(cosine);
  const double to_face_rad = std::atan2(at.z(), out_m);  // elevation, from the shoulder
  const double above_rad = std::atan2(mast.link2_m * std::sin(bend_rad),
                                      mast.link1_m + mast.link2_m * std::cos(bend_rad));
  const MastAngles angles{std::atan2(at.y(), at.x()), -(to_face_rad + above_rad), bend_rad};
  if (!WithinLimits(mast, angles)) return std::nullopt;
  return angles;
}

MastAngles AnglesToWatch(const NominalMast& mast, const Eigen::Vector3d& p_RT, double lean_rad) {
  MastAngles angles = mast.watch_rad;
  angles[1] = std::clamp(angles[1] + lean_rad, mast.low_rad[1], mast.high_rad[1]);
  const StereoRig& pair = mast.pair_K;
  const Pose3 X_KC{pair.X_RL.R, 0.5 * (pair.X_RL.p + pair.X_RQ.p)};
  const auto clamp = [&](std::size_t i) {
    angles[i] = std::clamp(angles[i], mast.low_rad[i], mast.high_rad[i]);
  };
  for (int round = 0; round < kAimRounds; ++round) {
    const Pose3 X_RC = SecondLink(mast, angles) * X_KC;
    const Eigen::Vector3d p_C = Inverse(X_RC) * p_RT;
    const double away_m = std::hypot(p_C.y(), p_C.z());
    const double from_roll_m = (X_RC.p - mast.p_RM).head<2>().norm(), from_elbow_m = X_KC.p.norm();
    angles[0] = WrapPi(angles[0] - std::atan2(p_C.x(), away_m) * away_m / (away_m + from_roll_m));
    angles[2] += std::atan2(p_C.y(), p_C.z()) * away_m / (away_m + from_elbow_m);
    clamp(0);
    clamp(2);
  }
  return angles;
}

std::optional<Stance> StanceFor(const NominalMast& mast, double up_m, double tool_up_rad,
                                double least_stand_off_m) {
  for (double off_rad = 0.0; off_rad <= kMostTilt_rad; off_rad += kTiltStep_rad) {
    for (const double off : {off_rad, -off_rad}) {
      auto stance = StanceAt(mast, up_m, tool_up_rad + off);
      if (!stance || stance->stand_off_m < least_stand_off_m) continue;
      stance->off_rad = off;
      return stance;
    }
  }
  return std::nullopt;
}

double AngleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace dockyard::rocky7
