// Perception of a target on the ground: an image pair and what odometry predicts in, a detection
// out.
#pragma once

#include <memory>
#include <optional>

#include "controller/io/belief.h"
#include "controller/rocky7/ground_stereo.h"
#include "controller/rocky7/target_odometry.h"

namespace dockyard::rocky7 {

/// What is kept from one image pair to the next.
struct GroundMemory {
  std::unique_ptr<TargetTracker> tracker;
  bool begun = false;                   // the tracker has its target
  bool compares = false;                // the ground of two pairs, for the motion between them
  std::optional<GroundImage> ground{};  // of the last pair
};

/// Corrects the prediction where the ground of the last pair and of this one shows the motion
/// between them.
void CompareGround(GroundImage picture, const ExposurePrior& prior, GroundMemory& memory,
                   GroundDetection& detection);

GroundDetection DetectTarget(const GroundStereo& stereo, const StereoImages& images,
                             const ExposurePrior& prior, const Eigen::Vector2d& click_px,
                             GroundMemory& memory);

SightingReport ReportOf(const TargetSighting& sighting, const Nominal& nominal,
                        const ImuSample& attitude);

/// The pixel of the left front camera that shows a place of the ground.
std::optional<Eigen::Vector2d> FrontPixel(const Nominal& nominal, const ImuSample& attitude,
                                          const Eigen::Vector2d& p_E);

}  // namespace dockyard::rocky7
