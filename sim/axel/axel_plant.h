// Axel, its station and the yard as the plant of one run.
#pragma once

#include <memory>
#include <optional>

#include "controller/geometry/axle_attitude.h"
#include "render/kept_exposure.h"
#include "sim/axel/axel_columns.h"
#include "sim/axel/axel_view.h"
#include "sim/axel/build_run.h"
#include "sim/axel/tether_sensor.h"
#include "sim/axel/world.h"
#include "sim/drives/sensor_suite.h"
#include "sim/run/world_plant.h"

namespace dockyard::axel {

class AxelPlant final : public WorldPlant<World, BuiltRun> {
 public:
  /// Throws ConfigError when rover and station overlapped at the start.
  AxelPlant(const Scenario& scenario, BuiltRun built, std::shared_ptr<KeptRenderer> renderer);

  SensorFrame Sense() override;
  std::vector<CameraImage> TakeImages(const std::vector<int>& cameras,
                                      double exposure_stops) override;
  void Advance(const Commands& commands) override;
  RobotPose X_DR() const override { return {truth_.X_DR, AxleOnGround(truth_.X_DR)}; }
  Stage Look() const override;
  RobotPose MeasuredPose(const SightingReport& report) const override;

  /// The truth when the latest images were exposed. No older ones are still on their way
  /// (ImageLink).
  const Truth& exposed_truth() const { return exposed_truth_; }

 private:
  StereoImages Picture(const SensorOptions& sensor);

  CameraFaults camera_faults_;
  SensorSuite sensors_;
  std::optional<TetherSensing> tether_sensing_;  // where the robot has one
  SceneBuilder scene_;
  std::vector<Eigen::Vector3d> rock_corners_W_;
  int pairs_taken_ = 0;
  KeptExposure exposure_;  // that the pair before set
  Truth exposed_truth_;
};

}  // namespace dockyard::axel
