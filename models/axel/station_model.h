// The docking station: the central module on frictional feet, with cone, board and tether anchor.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <string>
#include <vector>

#include "controller/geometry/board.h"
#include "models/axel/axel_model.h"
#include "models/parts/board_cutout.h"

namespace dockyard::axel {

/// The docking cone: a flat annular face at the mouth, a funnel, a straight socket. Surfaces of
/// revolution about the cone's axis; depth counts inward from the mouth plane.
struct ConeModel {
  double mouth_radius_m = 0.0;
  double funnel_length_m = 0.0;
  double throat_radius_m = 0.0;
  double socket_end_m = 0.0;  // depth at which the straight socket ends
  // A plate across the socket, with a hole for the tether, seats the tip at this depth; 0: none.
  double stop_depth_m = 0.0;
  double face_outer_radius_m = 0.0;                   // of the annular face round the mouth
  double funnel_friction = 0.0, face_friction = 0.0;  // against the arm
  double rated_force_n = std::numeric_limits<double>::infinity();  // that the arm may load it with
  double contact_stiffness_n_per_m = 0.0;
  double contact_damping_ns_per_m = 0.0;
};

struct FootModel {
  Eigen::Vector3d p_SF{0, 0, 0};  // the sole's centre in the station body, standing level
};

/// Station body frame S: origin below the mouth's centre, on the soles' plane; x out of the cone's
/// mouth, z up; the module inside is tipped forward by tip_angle_rad about the mouth's centre, so
/// that the cone's axis, going out, points towards the ground.
struct StationModel {
  std::string name;
  LinkModel module;                   // URDF link; its frame is S standing level and not tipped
  std::vector<Visual> stand_visuals;  // feet and legs, in S: they stay when the module is tipped
  double tip_angle_rad = 0.0;         // Tsai et al., V-F: 5 deg
  double mouth_height_m = 0.0;        // centre of the mouth above the soles
  ConeModel cone;
  // Of the rover with all but the mating's surfaces: painted metal on rubber or metal (friction
  // assumed, range 0.3-0.6). A file that leaves its stiffness and damping out has the cone's.
  ContactMaterial body_contact{.friction = 0.4};
  FiducialBoard board;
  double board_height_above_axis_m = 0.0;  // board's centre above the mouth's centre, in the face
  Pose3 board_mounting;         // of the board with its hole about its middle, in M's axes
  double anchor_depth_m = 0.0;  // tether anchor on the axis, behind the mouth plane
  std::vector<FootModel> feet;
  double foot_friction = 0.0;           // Coulomb, feet on soil
  double foot_stiffness_n_per_m = 0.0;  // each foot, vertical and tangential
  double foot_damping_ratio = 0.3;      // share of critical, soil under a pad; assumed, 0.1-0.5
  double sole_diameter_m = 0.0;         // round soles that sink into the soil; 0: hard feet
};

/// Poses on the station in its own frame S, for the world, the renderer and the controller's
/// nominal parameters.
Pose3 MouthInStation(const StationModel& station);  // M: centre of the mouth, x out along the axis
Pose3 BoardInStation(const StationModel& station);  // B
/// Where the cone's mouth and face pass through the board.
BoardCutout CutoutOf(const StationModel& station);
/// Board in the dock frame D (D and S coincide when the station stands where it was put).
Pose3 BoardInDock(const StationModel& station);

}  // namespace dockyard::axel
