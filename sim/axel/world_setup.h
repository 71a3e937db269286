// What the world of one run is made of.
#pragma once

#include <vector>

#include "models/axel/axel_model.h"
#include "models/axel/station_model.h"
#include "models/parts/soil_model.h"
#include "sim/axel/rock_bed.h"
#include "sim/axel/station_hand.h"
#include "sim/rigid/slope.h"
#include "sim/soil/height_grid.h"

namespace dockyard::axel {

struct WorldSetup {
  RoverModel rover;
  StationModel station;
  SoilModel soil;
  std::vector<SoilModel> patch_soils;  // of the ground's numbers 1, 2 ...
  HeightGrid ground;                   // in the site frame G
  Pose2 X_WG;                          // site in the world, before it is tilted
  Slope slope;                         // of the site, under rover and station
  RockBed rocks;                       // in the ground, in G
  Pose2 X_GD;                          // dock in the site: where the station is put
  Pose2 X_DR_start;
  double arm_start_rad = 0.0;    // arm against body, tip-down positive
  double pitch_start_rad = 0.0;  // body about the axle, nose-down positive; 180 deg: upside down
  double slack_start_m = 0.0;    // exposed tether beyond the straight path at the start, >= 0
  StationMove station_move{};    // while the run is under way
  bool paddles_print = false;    // the wheels' paddles leave prints in their ruts
  bool body_marks_soil = false;  // tip, body and further links press and plough the soil
  double step_s = 1e-3;
  bool may_rest = true;               // off: every step is computed, nothing moving or not
  bool add_right_side_first = false;  // order in which the bodies are added (mirror test)
};

/// Gravity in the site [m/s^2]: that of the soil's place, leaning where the site is a slope.
Eigen::Vector3d GravityOf(const WorldSetup& setup);

}  // namespace dockyard::axel
