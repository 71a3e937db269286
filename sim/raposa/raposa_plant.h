// RAPOSA, its pyramid and the ground as the plant of one run.
#pragma once

#include <memory>
#include <optional>

#include "sim/drives/sensor_suite.h"
#include "sim/raposa/build_run.h"
#include "sim/raposa/raposa_columns.h"
#include "sim/raposa/raposa_view.h"
#include "sim/raposa/world.h"
#include "sim/run/world_plant.h"

namespace dockyard::raposa {

class RaposaPlant final : public WorldPlant<World, BuiltRun> {
 public:
  RaposaPlant(const Scenario& scenario, BuiltRun built, std::shared_ptr<KeptRenderer> renderer);

  SensorFrame Sense() override;
  std::vector<CameraImage> TakeImages(const std::vector<int>& cameras,
                                      double exposure_stops) override;
  void Advance(const Commands& commands) override;
  RobotPose X_DR() const override { return RobotPose(truth_.X_DR_start); }
  Stage Look() const override;
  RobotPose MeasuredPose(const SightingReport& report) const override {
    return Inverse(ToGround(report.X_RB));
  }
  std::uint64_t FinalHash(std::uint64_t seed) const override { return StateHash(seed); }
  StageShapes shapes() const { return scene_.Shapes(); }

 private:
  SensorSuite sensors_;
  SceneBuilder scene_;
  ColourView view_;
  ColourSensorOptions sensor_;
  ColourSensorState sensor_state_;
  int pictures_ = 0;
  std::optional<Tick> last_picture_;
  bool lamps_on_ = false;
  Truth exposed_;  // exposed: of the image that is there by now
};

}  // namespace dockyard::raposa
