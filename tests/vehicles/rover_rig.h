// A rover of models/rovers on level ground, driven by arcs without a controller.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "controller/motion/steering.h"
#include "models/parts/gravity.h"
#include "models/read/load_rover.h"
#include "models/read/load_soil.h"
#include "sim/vehicles/wheeled_body.h"
#include "support/bad_files.h"

namespace dockyard {

class RoverRig {
 public:
  static constexpr double kStep_s = 1e-3;

  static RoverModel Model(const std::string& rover) {
    return LoadRover(SourceFile("models/rovers/" + rover + ".yaml"));
  }

  RoverRig(const RoverModel& rover, const std::string& soil, double cell_m = 5e-3,
           double reach_m = 2.5)
      : model(rover),
        ground(LevelGrid(-reach_m, 2.0 * reach_m, 2.0 * reach_m, cell_m)),
        body(world, rover, {LoadSoil(SourceFile("models/soils/" + soil + ".yaml"))},
             Pose3::Translation(0.0, 0.0, RollingRadius(rover.tyre))),
        commands_(static_cast<std::size_t>(body.motor_count())) {}

  void Run(double time_s) {
    for (int i = 0; i < std::lround(time_s / kStep_s); ++i) {
      body.AddLoads(commands_, kStep_s, ground);
      world.Step(kStep_s);
    }
  }

  /// Wheels to an arc's angles, standing.
  void Steer(const Arc& arc) {
    std::size_t motor = model.plan.wheels.size();
    for (const WheelPlan& wheel : model.plan.wheels) {
      if (wheel.steer_limit_rad == 0.0) continue;
      commands_[motor++] = {MotorMode::kPosition, OnArc(wheel, arc).steer_rad, 0.5, 2.0, 2.0};
    }
    Run(4.0);
  }

  /// Along an arc at the rover's speed; then stops.
  void Drive(const Arc& arc) {
    double most_m = 0.0;
    for (const WheelPlan& wheel : model.plan.wheels) {
      most_m = std::max(most_m, std::abs(OnArc(wheel, arc).way_m));
    }
    const double time_s = most_m / model.plan.speed_m_s;
    for (std::size_t i = 0; i < model.plan.wheels.size(); ++i) {
      const double rate =
          OnArc(model.plan.wheels[i], arc).way_m / time_s / RollingRadius(model.tyre);
      commands_[i] = {MotorMode::kVelocity, rate, 0.0, 1.5, 2.0};
    }
    Run(time_s);
    for (std::size_t i = 0; i < model.plan.wheels.size(); ++i) commands_[i] = {};
    Run(0.5);
  }

  Pose2 X_GR() const { return ToGround(body.body().X_GL); }

  RoverModel model;
  HeightGrid ground;
  RigidWorld world{{0.0, 0.0, -kEarthGravity_m_s2}};
  WheeledBody body;

 private:
  std::vector<MotorCommand> commands_;  // braked at first
};

}  // namespace dockyard
