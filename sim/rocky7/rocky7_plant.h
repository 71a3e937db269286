// Rocky 7, its target and the ground as the plant of one run.
#pragma once

#include <array>
#include <map>
#include <memory>

#include "render/kept_exposure.h"
#include "sim/drives/sensor_suite.h"
#include "sim/rocky7/build_run.h"
#include "sim/rocky7/rocky7_columns.h"
#include "sim/rocky7/rocky7_view.h"
#include "sim/rocky7/world.h"
#include "sim/run/world_plant.h"

namespace dockyard::rocky7 {

class Rocky7Plant final : public WorldPlant<World, BuiltRun> {
 public:
  /// Puts the user's click into the nominal parameters. Throws ConfigError when the cameras do not
  /// see the target at the start.
  Rocky7Plant(const Scenario& scenario, BuiltRun built, std::shared_ptr<KeptRenderer> renderer);

  SensorFrame Sense() override;
  std::vector<CameraImage> TakeImages(const std::vector<int>& cameras,
                                      double exposure_stops) override;
  void Advance(const Commands& commands) override;
  RobotPose X_DR() const override { return {Inverse(X_WG()) * truth_.X_WR, truth_.X_GR}; }
  Stage Look() const override;
  /// The place by the report, the heading by the truth: a stone has none of its own.
  RobotPose MeasuredPose(const SightingReport& report) const override;

  StageShapes shapes() const { return scene_.Shapes(); }
  const Pose3& X_WG() const { return world_.X_WG(); }
  /// What is to be reached: the target's middle at the start, or the point clicked on a boulder.
  const Eigen::Vector3d& target_G() const { return target_G_; }

 private:
  /// A pair of cameras, and how what carries it moves, in the world.
  struct PairView {
    const StereoModel& model;
    const StereoRig& built;
    const std::array<LensRipple, 2>& ripples;
    int left = 0;  // number of its left camera
    Eigen::Vector3d turning_rad_s, speed_m_s;
  };
  PairView PairOf(int camera) const;
  StereoImages TakePair(const PairView& pair, double exposure_stops);

  SensorSuite sensors_;
  SceneBuilder scene_;
  int pairs_taken_ = 0;
  std::map<int, KeptExposure> exposures_;  // of the pairs, by their left cameras
  Eigen::Vector3d target_G_{0, 0, 0};
};

}  // namespace dockyard::rocky7
