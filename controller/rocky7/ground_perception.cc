#include "controller/rocky7/ground_perception.h"

#include <array>
#include <utility>

namespace dockyard::rocky7 {
namespace {

// Of the turn by the inertial unit between two image pairs. Assumed, 0.1-0.5 deg.
constexpr double kYawSigma_rad = Radians(0.3);
// The motion is searched for about these shares of the distance that was counted: wheels may have
// been stuck. Assumed.
constexpr std::array<double, 3> kShares{1.0, 0.5, 0.0};

Eigen::Matrix3d TiltOf(const ImuSample& attitude) {  // R_ER
  return RotY(attitude.pitch_rad) * RotX(attitude.roll_rad);
}

}  // namespace

void CompareGround(GroundImage picture, const ExposurePrior& prior, GroundMemory& memory,
                   GroundDetection& detection) {
  GroundMotion motion;
  for (const double share : kShares) {
    if (!memory.ground || motion.found) break;
    const Pose2 X_BE_less{share * prior.X_BE.x, share * prior.X_BE.y, prior.X_BE.heading};
    motion = MotionBetween(*memory.ground, picture, Inverse(X_BE_less), kYawSigma_rad);
  }
  memory.ground = std::move(picture);
  if (!motion.found) return;
  detection.X_BE = Inverse(motion.X_NB);
  detection.predicted = InFrame(prior.before, motion.X_NB, detection.X_BE->heading);
  detection.predicted.spread_m2 += motion.spread_m2;
}

GroundDetection DetectTarget(const GroundStereo& stereo, const StereoImages& images,
                             const ExposurePrior& prior, const Eigen::Vector2d& click_px,
                             GroundMemory& memory) {
  GroundDetection detection{.predicted = prior.target};
  const GroundScan scan = stereo.Look(images, prior.attitude);
  if (memory.compares) CompareGround(stereo.ImageAhead(scan, images), prior, memory, detection);
  if (memory.begun) {
    detection.sighting = memory.tracker->Follow(stereo.MapsAbout(scan, detection.predicted.p_RT),
                                                detection.predicted.predicted());
  } else if (const auto clicked = stereo.ClickOf(scan, click_px)) {
    detection.sighting = memory.tracker->Begin(stereo.MapsAbout(scan, clicked->p_E), *clicked);
    memory.begun = detection.sighting.found;
  } else {
    detection.sighting.why = "no range data where the user clicked";
  }
  return detection;
}

SightingReport ReportOf(const TargetSighting& sighting, const Nominal& nominal,
                        const ImuSample& attitude) {
  SightingReport report;
  report.accepted = sighting.found;
  report.reason = sighting.found ? "" : sighting.why;
  report.method = "stereo";
  const Eigen::Matrix3d R_ER = TiltOf(attitude);
  const Eigen::Vector3d p_E(sighting.p_E.x(), sighting.p_E.y(),
                            sighting.height_m - nominal.rolling_radius_m);
  report.X_RB = {R_ER.transpose(), R_ER.transpose() * p_E};
  if (!sighting.found) return report;
  const auto pixel = nominal.front.left.Project(Inverse(nominal.front.X_RL) * report.X_RB.p);
  if (pixel) report.marks.push_back({0, kFrontLeft, pixel->x(), pixel->y()});
  report.detected = {1, 1};
  return report;
}

std::optional<Eigen::Vector2d> FrontPixel(const Nominal& nominal, const ImuSample& attitude,
                                          const Eigen::Vector2d& p_E) {
  const Eigen::Vector3d p(p_E.x(), p_E.y(), -nominal.rolling_radius_m);
  return nominal.front.left.Project(Inverse(nominal.front.X_RL) *
                                    Eigen::Vector3d(TiltOf(attitude).transpose() * p));
}

}  // namespace dockyard::rocky7
