// Axel, its station and the yard as the plant of one run.
#pragma once

#include <memory>

#include "controller/geometry/axle_attitude.h"
#include "sim/axel/axel_view.h"
#include "sim/axel/build_run.h"
#include "sim/axel/world.h"
#include "sim/drives/sensor_suite.h"
#include "sim/plant/renderer.h"
#include "sim/run/plant.h"

namespace dockyard::axel {

class AxelPlant final : public Plant {
 public:
  /// The renderer may serve other plants too. Throws ConfigError when rover and station overlapped
  /// at the start.
  AxelPlant(const Scenario& scenario, BuiltRun built, std::shared_ptr<KeptRenderer> renderer);

  Tick tick() const override { return world_.tick(); }
  SensorFrame Sense() override;
  std::vector<CameraImage> TakeImages(const std::vector<int>& cameras,
                                      double exposure_stops) override;
  void Advance(const Commands& commands) override;
  RobotPose X_DR() const override { return {truth_.X_DR, AxleOnGround(truth_.X_DR)}; }
  void AppendChannels(std::vector<double>& values) const override;
  Stage Look() const override;
  RobotPose MeasuredPose(const SightingReport& report) const override;
  std::uint64_t StateHash(std::uint64_t seed) const override { return world_.StateHash(seed); }
  std::uint64_t FinalHash(std::uint64_t seed) const override;

  const BuiltRun& built() const { return built_; }
  /// The truth at the last sensor reading.
  const Truth& truth() const { return truth_; }
  /// The truth when the latest images were exposed. No older ones are still on their way
  /// (ImageLink).
  const Truth& exposed_truth() const { return exposed_truth_; }
  void RefreshTruth() { TakeTruth(world_.truth()); }
  void TakeTruth(const Truth& now) { truth_ = now; }
  World& world() { return world_; }

 private:
  StereoImages Picture(const SensorOptions& sensor);

  Seed seed_;
  double step_s_;
  CameraFaults camera_faults_;
  BuiltRun built_;
  World world_;
  SensorSuite sensors_;
  SceneBuilder scene_;
  std::vector<Eigen::Vector3d> rock_corners_W_;
  std::shared_ptr<KeptRenderer> renderer_;
  int pairs_taken_ = 0;
  Truth truth_, exposed_truth_;
};

}  // namespace dockyard::axel
