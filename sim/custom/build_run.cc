#include "sim/custom/build_run.h"

#include <algorithm>
#include <cmath>

#include "controller/base/number_text.h"
#include "models/custom/make_nominal.h"
#include "models/read/config_error.h"
#include "models/read/load_soil.h"
#include "sim/plant/built_cameras.h"
#include "sim/plant/scenery.h"
#include "sim/plant/yard.h"

namespace dockyard::custom {
namespace {

// Level about the dock. Assumed, 0.2-1 m.
constexpr double kFlatRadius_m = 0.5;

void CheckStep(const Scenario& scenario) {
  if (scenario.physics_step_s <= kLongestStep_s) return;
  throw ConfigError(scenario.step_place + ": expected at most " + NumberText(kLongestStep_s) +
                    " s, found " + NumberText(scenario.physics_step_s));
}

// The floors or soils of the yard and of its patches, by the ground's numbers.
void TakeGround(const Scenario& scenario, const CustomModels& models, WorldSetup& world) {
  const GroundModel& ground = models.built.ground;
  world.ground.heights = YardGround(scenario.yard, kFlatRadius_m, scenario.seed);
  world.ground.floors.push_back(ground.floor);
  double width_m = 0.0;
  for (const WheelFit& wheel : world.robot.wheels) {
    width_m = std::max(width_m, wheel.on_soil.width_m);
  }
  if (ground.soil) {
    CheckCarries(*ground.soil, scenario.soil_file, width_m);
    world.soils.push_back(*ground.soil);
  }
  for (const std::string& file : PatchSoilFiles(scenario.yard)) {
    const GroundModel patch = LoadGround(file);
    if (patch.soil.has_value() != ground.soil.has_value()) {
      throw ConfigError(scenario.yard_place + ": patches: expected " +
                        (ground.soil ? "soils, as the yard's, found the floor '"
                                     : "floors, as the yard's, found the soil '") +
                        patch.floor.name + "'");
    }
    world.ground.floors.push_back(patch.floor);
    if (patch.soil) world.soils.push_back(*patch.soil);
  }
}

void AddContactNames(const ElectricalParts& parts, std::vector<std::string>& names) {
  for (const SpringPin& pin : parts.pins) {
    if (std::find(names.begin(), names.end(), pin.contact) == names.end()) {
      names.push_back(pin.contact);
    }
  }
}

Pose3 FrameAtStart(const LinkTree& tree, const std::string& name) {
  const NamedFrame& frame = *tree.Frame(name);
  return StartPoses(tree)[static_cast<std::size_t>(frame.link)] * frame.X_LF;
}

void TakeNominal(const CustomModels& models, BuiltRun& run) {
  const ModelSet& drawn = models.nominal;
  run.nominal = MakeNominal(drawn.robot, drawn.dock);
  run.nominal.control_period_s = static_cast<double>(kControlPeriod) * kTickSeconds;
  const PoseBox& pose = models.keys.judge.docked.pose;
  run.nominal.X_RP = FrameAtStart(drawn.robot.tree, pose.robot);
  run.nominal.X_DQ = FrameAtStart(drawn.dock.tree, pose.dock);
  run.nominal.contact = models.keys.judge.docked.contact.pins;
  run.nominal.docking = models.keys.docking;
  run.nominal.has_imu = drawn.robot.imu.has_value();
  for (const ElectricalParts* parts : {&drawn.robot.electrical, &drawn.dock.electrical}) {
    for (const ContactSupply& supply : parts->supplies) {
      if (supply.contact == run.nominal.contact) run.nominal.contact_voltage_v = supply.open_v;
    }
  }
  for (const NamedSensor& sensor : SensorsOf(drawn.robot, run.world.contacts)) {
    run.nominal.sensors.push_back(sensor.name);
  }
}

}  // namespace

std::vector<NamedSensor> SensorsOf(const RobotModel& robot,
                                   const std::vector<std::string>& contacts) {
  std::vector<NamedSensor> sensors;
  const auto add = [&](std::string name, const char* unit, const char* meaning,
                       const SensorTimes& times, double noise) {
    const auto period = std::max<Tick>(1, std::llround(1.0 / (times.rate_hz * kTickSeconds)));
    sensors.push_back({std::move(name), unit, meaning, period,
                       std::llround(times.latency_s / kTickSeconds), noise});
  };
  for (const JointSwitch& each : robot.switches) {
    add(each.name, "", "switch of a joint, 1 closed", each.times, 0.0);
  }
  for (const RangeFinder& each : robot.ranges) {
    add(each.name + "_m", "m", "along its beam", each.times, each.noise_m);
  }
  for (const std::string& name : contacts) {
    add(name + "_voltage_v", "V", "of the charging contact", robot.charge.times,
        robot.charge.voltage_noise_v);
    add(name + "_current_a", "A", "of the charging contact", robot.charge.times,
        robot.charge.current_noise_a);
  }
  return sensors;
}

BuiltRun BuildRun(const Scenario& scenario, const CustomModels& models) {
  CheckStep(scenario);
  BuiltRun run;
  WorldSetup& world = run.world;
  world.robot = models.built.robot;
  world.dock = models.built.dock;
  TakeGround(scenario, models, world);
  world.X_WG = scenario.X_WG;
  world.slope = {scenario.yard.slope_rad, scenario.yard.downhill_rad};
  DockingCoords at = scenario.start.on_plane();
  if (!std::isnan(models.keys.off_dock_rad)) at.h = at.alpha + models.keys.off_dock_rad;
  world.X_GR_start = FromDockingCoords(at);
  run.judge = models.keys.judge;
  world.robot_frame = run.judge.docked.pose.robot;
  world.dock_frame = run.judge.docked.pose.dock;
  AddContactNames(world.robot.electrical, world.contacts);
  AddContactNames(world.dock.electrical, world.contacts);
  world.step_s = scenario.physics_step_s;
  for (const CameraFit& camera : models.nominal.robot.cameras) {
    CheckImagesCanBeDrawn(StereoRig{camera.model.nominal, camera.model.nominal, {}, {}},
                          scenario.camera_place);
  }
  run.floor = models.built.ground.floor;
  const Pose3 X_WG = SiteInWorld(world.X_WG, world.slope);
  const Eigen::Vector3d p_DB =
      world.dock.boards.empty() ? Eigen::Vector3d(0.0, 0.0, 0.3) : world.dock.boards[0].X_LB.p;
  run.lighting = MakeLighting(scenario.light, X_WG, p_DB, scenario.seed, scenario.sun);
  AddScenery(scenario, world.ground.heights, X_WG, Pose2{}, run.lighting);
  TakeNominal(models, run);
  return run;
}

}  // namespace dockyard::custom
