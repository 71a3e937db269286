#include "models/custom/robot_file.h"

#include "models/read/load_motor.h"
#include "models/read/load_spreads.h"
#include "models/read/load_tyre.h"
#include "models/read/read_imu.h"

namespace dockyard::custom {
namespace {

using enum Presence;

constexpr std::size_t kMostWheels = 16, kMostMotors = 20, kMostSensors = 16;

void VisitWheels(Keys& keys, WheelsFile& wheels) {
  keys.Texts({"links", "", "of the URDF file; each is a wheel", kRequired}, wheels.links,
             kMostWheels);
  keys.Mapping({"tyre", "", ""}, [&](Keys& in) { VisitTyre(in, wheels.tyre); });
  keys.Mapping(Unset("paddles"), [&](Keys& in) {
    in.Integer({"count", "", "of paddles, for a wheel on soil", kRequired},
               wheels.on_soil.paddle_count, 1, 100);
    in.Number(
        {"height_m", "m", "of a paddle beyond the rim; the radius is at their tips", kRequired},
        wheels.on_soil.paddle_height_m, Positive(0.5));
    in.Number({"thickness_m", "m", "of a paddle", kRequired}, wheels.on_soil.paddle_thickness_m,
              Positive(0.5));
  });
}

void VisitMotors(Keys& keys, MotorsFile& motors) {
  keys.Texts({"joints", "", "of the URDF file; each has such a motor", kRequired}, motors.joints,
             kMostMotors);
  VisitMotor(keys, motors.model);
  keys.Number({"lead_m_per_turn", "m", "travel of a slide for a turn of its motor", kUnset},
              motors.lead_m_per_turn, Positive(10.0));
}

void VisitTimes(Keys& keys, SensorTimes& times) {
  keys.Number({"rate_hz", "Hz", "of its readings"}, times.rate_hz, Between(0.1, 1000.0));
  keys.Number({"latency_s", "s", "from a reading to its arrival"}, times.latency_s,
              NonNegative(10.0));
}

void VisitSwitch(Keys& keys, SwitchFile& file) {
  keys.Text({"name", "", "of the sensor", kRequired}, file.name);
  keys.Text({"joint", "", "of the URDF file", kRequired}, file.joint);
  keys.Number({"closes_m", "m", "while a slide has moved so far from its start", kUnset},
              file.closes_m, Positive(1.0));
  keys.Degrees({"closes_deg", "deg", "the same of a joint that turns", kUnset}, file.closes_rad,
               Positive(360.0));
  VisitTimes(keys, file.times);
}

void VisitRange(Keys& keys, RangeFile& file) {
  RangeFinder& finder = file.finder;
  keys.Text({"name", "", "of the sensor", kRequired}, finder.name);
  keys.Text({"link", "", "along whose x axis it measures", kRequired}, file.link);
  keys.Number({"least_m", "m", "nearer things read as none"}, finder.least_m, NonNegative(100.0));
  keys.Number({"most_m", "m", "what it reads where there is nothing", kRequired}, finder.most_m,
              Positive(1000.0));
  keys.Number({"noise_m", "m", "1 sigma of a reading"}, finder.noise_m, NonNegative(10.0));
  keys.Number({"step_m", "m", "of a reading; 0: none"}, finder.step_m, NonNegative(1.0));
  VisitTimes(keys, finder.times);
  keys.Check("most_m", finder.most_m > finder.least_m, "more than least_m");
}

void VisitCharge(Keys& keys, ChargeSensors& charge) {
  keys.Number({"voltage_noise_v", "V", "1 sigma of a reading"}, charge.voltage_noise_v,
              NonNegative(100.0));
  keys.Number({"current_noise_a", "A", "1 sigma of a reading"}, charge.current_noise_a,
              NonNegative(100.0));
  VisitTimes(keys, charge.times);
}

void VisitErrors(Keys& keys, RobotErrors& errors) {
  keys.Number({"left_radius_scale", "", "of the wheels on the left"}, errors.left_radius_scale,
              Between(0.5, 2.0));
  keys.Number({"right_radius_scale", "", "of the wheels on the right"}, errors.right_radius_scale,
              Between(0.5, 2.0));
  keys.Number({"gear_friction_scale", "", "of all motors"}, errors.gear_friction_scale,
              Between(0.0, 20.0));
  keys.Number({"tyre_grip_scale", "", "of all tyres"}, errors.tyre_grip_scale, Between(0.05, 5.0));
  keys.Number({"pins_x_m", "m", "of all pins and pads off their places, in their links"},
              errors.pad_L.x(), Between(-0.5, 0.5));
  keys.Number({"pins_y_m", "m", "the same"}, errors.pad_L.y(), Between(-0.5, 0.5));
  keys.Number({"pins_z_m", "m", "the same"}, errors.pad_L.z(), Between(-0.5, 0.5));
}

}  // namespace

void VisitRobot(Keys& keys, RobotModel& robot, RobotFile& file) {
  keys.Text({"name", "", "shown in messages", kRequired}, robot.name);
  keys.File({"urdf", "", "its links and joints", kRequired}, file.urdf);
  keys.Items({"wheels", "", "groups of like wheels", kRequired}, file.wheels, 1, kMostWheels,
             VisitWheels);
  keys.Items({"motors", "", "groups of like motors that the controller commands", kRequired},
             file.motors, 1, kMostMotors, VisitMotors);
  keys.Items({"cameras", "", "in the controller's order", kUnset}, file.cameras, 0, kMostSensors,
             VisitCamera);
  keys.Mapping(Unset("imu"),
               [&](Keys& in) { VisitImu(in, robot.imu ? *robot.imu : robot.imu.emplace()); });
  keys.Items({"switches", "", "on joints, such as a bumper's", kUnset}, file.switches, 0,
             kMostSensors, VisitSwitch);
  keys.Items({"range_finders", "", "of one beam each", kUnset}, file.ranges, 0, kMostSensors,
             VisitRange);
  keys.Mapping(Optional("charge_sensors"), [&](Keys& in) { VisitCharge(in, robot.charge); });
  VisitPins(keys, file.pins);
  VisitJoints(keys, file.joints);
  keys.Number({"floor_grip", "", "of its solids on the floor, a share of rubber's"},
              robot.floor_grip, NonNegative(3.0));
  keys.Mapping({"as_built", "", ""}, [&](Keys& in) { VisitErrors(in, file.errors); });
  keys.Number({"mass_scale", "", "of all its links"}, file.mass_scale, Between(0.1, 10.0));
  NameSpreads(keys);
}

}  // namespace dockyard::custom
