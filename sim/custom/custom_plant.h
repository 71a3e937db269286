// A robot, a dock and the ground, all described by files, as the plant of one run.
#pragma once

#include <memory>
#include <vector>

#include "sim/custom/build_run.h"
#include "sim/custom/custom_columns.h"
#include "sim/custom/custom_view.h"
#include "sim/custom/world.h"
#include "sim/drives/sensor_suite.h"
#include "sim/plant/camera_view.h"
#include "sim/run/world_plant.h"

namespace dockyard::custom {

class CustomPlant final : public WorldPlant<World, BuiltRun> {
 public:
  /// Throws ConfigError when the robot would start in the dock.
  CustomPlant(const Scenario& scenario, BuiltRun built, std::shared_ptr<KeptRenderer> renderer);

  SensorFrame Sense() override;
  std::vector<CameraImage> TakeImages(const std::vector<int>& cameras,
                                      double exposure_stops) override;
  void Advance(const Commands& commands) override;
  RobotPose X_DR() const override { return RobotPose(truth_.X_DR); }
  Stage Look() const override;
  RobotPose MeasuredPose(const SightingReport& report) const override {
    return RobotPose(Inverse(report.X_RB));
  }
  std::uint64_t FinalHash(std::uint64_t seed) const override;

  StageShapes shapes() const { return scene_.Shapes(); }
  /// An electrical contact as it is now; null for an empty name.
  const ContactTruth* Contact(const std::string& name) const;
  /// A level force on the robot's root from now on, in D; with a frequency it swings as a sine [N].
  void Push(const Eigen::Vector3d& force_D, double frequency_hz);

 private:
  double NearestBoard_m(const Eigen::Vector3d& p_W) const;

  SensorSuite sensors_;
  SceneBuilder scene_;
  std::vector<SimulatedCamera> cameras_;
  Eigen::Vector3d push_D_{0, 0, 0};
  double push_hz_ = 0.0, pushed_s_ = 0.0;
};

}  // namespace dockyard::custom
