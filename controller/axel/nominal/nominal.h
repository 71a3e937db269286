// Axel's nominal parameters: the numbers from calibration and drawings that its controller uses.
// The world is built from its own numbers, which differ.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "controller/axel/nominal/motors.h"
#include "controller/axel/nominal/rock_map.h"
#include "controller/axel/nominal/tether_sensor.h"
#include "controller/axel/nominal/tsai2013_options.h"
#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/io/nominal_motor.h"
#include "controller/io/vision_settings.h"

namespace dockyard::axel {

struct Nominal {
  StereoRig rig;           // calibration, not truth
  double shutter_s = 0.0;  // for so long each picture is exposed
  FiducialBoard board;
  VisionSettings vision{};
  Pose3 X_DB;  // board in the dock, station standing level on flat ground
  std::array<NominalMotor, kMotorCount> motors;  // by Motor
  // The defaults of this, of mass, moment and play are Axel's: options.h has its numbers for them.
  double wheel_radius_m = 0.30;  // rolling radius on firm ground: rim plus paddle
  double paddle_pitch_m = 0.0;   // rolled from one paddle to the next; 0: smooth
  double track_m = 0.0;          // between the wheels' middles
  double arm_length_m = 0.0;     // axle to arm tip
  double arm_at_zero_rad = 0.0;  // arm against body at encoder zero, about +y: tip-down positive
  double drum_radius_m = 0.0;
  // Of the spool's gears, at the tether: it pulls this much less than the motor while it is reeled
  // in, and this much more while it is pulled out.
  double spool_friction_n = 0.0;
  double rover_mass_kg = 40.0;
  double arm_down_nm = 10.2;  // moment of the weights of level arm and body that keeps the arm down
  double seated_play_rad = 0.02545;  // by which the seated arm can turn to each side
  double gravity_m_s2 = 9.81;        // of the place, nominal
  double station_weight_n = 0.0;     // m g
  double station_friction = 0.0;     // of its soles on the ground
  // The middle of its soles behind the mouth, and how far they are from it, in the mean.
  double station_back_m = 0.0, station_spread_m = 0.0;
  double mouth_height_m = 0.0;   // centre of the cone's mouth above the ground
  double anchor_depth_m = 0.0;   // tether anchor behind the mouth plane, along the axis
  double throat_depth_m = 0.0;   // of the cone's throat behind the mouth plane
  double seat_depth_m = 0.0;     // of the socket's floor, on which the tip is seated
  double mating_depth_m = 0.25;  // how far to reel the tip in (Tsai et al., II)
  std::optional<TetherSensor> tether_sensor{};  // of a rover that has one
  RockMap rock_map{};                           // of a survey; none by default
  // The mission: the rover starts seated, and first goes this far out by its axle. 0: it starts
  // outside, and only docks.
  double excursion_m = 0.0;
  Tsai2013Options tsai2013{};  // of the controller of that name
};

}  // namespace dockyard::axel
