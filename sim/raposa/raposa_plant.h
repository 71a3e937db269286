// RAPOSA, its pyramid and the ground as the plant of one run.
#pragma once

#include <memory>
#include <optional>

#include "sim/drives/sensor_suite.h"
#include "sim/plant/renderer.h"
#include "sim/raposa/build_run.h"
#include "sim/raposa/raposa_view.h"
#include "sim/raposa/world.h"
#include "sim/run/plant.h"

namespace dockyard::raposa {

class RaposaPlant final : public Plant {
 public:
  /// The renderer may serve other plants too.
  RaposaPlant(const Scenario& scenario, BuiltRun built, std::shared_ptr<KeptRenderer> renderer);

  Tick tick() const override { return world_.tick(); }
  SensorFrame Sense() override;
  std::vector<CameraImage> TakeImages(const std::vector<int>& cameras,
                                      double exposure_stops) override;
  void Advance(const Commands& commands) override;
  RobotPose X_DR() const override { return RobotPose(truth_.X_DR_start); }
  void AppendChannels(std::vector<double>& values) const override;
  Stage Look() const override;
  RobotPose MeasuredPose(const SightingReport& report) const override {
    return Inverse(ToGround(report.X_RB));
  }
  std::uint64_t StateHash(std::uint64_t seed) const override { return world_.StateHash(seed); }

  const BuiltRun& built() const { return built_; }
  /// The truth at the last sensor reading.
  const Truth& truth() const { return truth_; }
  void RefreshTruth() { TakeTruth(world_.truth()); }
  void TakeTruth(const Truth& now) { truth_ = now; }
  World& world() { return world_; }
  StageShapes shapes() const { return scene_.Shapes(); }

 private:
  Seed seed_;
  double step_s_;
  BuiltRun built_;
  World world_;
  SensorSuite sensors_;
  SceneBuilder scene_;
  ColourView view_;
  ColourSensorOptions sensor_;
  ColourSensorState sensor_state_;
  std::shared_ptr<KeptRenderer> renderer_;
  int pictures_ = 0;
  std::optional<Tick> last_picture_;
  bool lamps_on_ = false;
  Truth truth_, exposed_;  // exposed: of the picture that is there by now
};

}  // namespace dockyard::raposa
