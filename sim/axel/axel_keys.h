// The keys of a scenario under `axel`.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "controller/axel/nominal/rock_map.h"
#include "controller/axel/nominal/tsai2013_options.h"
#include "controller/io/vision_settings.h"
#include "sim/axel/station_hand.h"
#include "sim/scenario/keys.h"
#include "sim/scenario/scenario.h"

namespace dockyard::axel {

enum class ArmPlace { kLeading, kTrailing };

/// How body and arm lie about the axle at the start, the arm's tip on the ground. Of body and arm
/// one angle gives the other. NaN: not given; then the body is level.
struct StartKeys {
  ArmPlace arm = ArmPlace::kLeading;
  double body_pitch_rad = std::numeric_limits<double>::quiet_NaN();  // nose-down positive
  double arm_rad = std::numeric_limits<double>::quiet_NaN();  // against the body, tip-down positive
  double rock_m = 0.0;  // height of a rock under the left wheel
};

/// Which marks soil keeps: the wheels' ruts, the prints of their paddles in these, and those of
/// tip, body and further links, each with what comes before.
enum class SoilMarks { kRuts, kPrints, kAll };

/// Some of the board's marks are dirtier than the rest.
struct DirtyMarks {
  int count = 0;
  double dust = 0.8;  // mean share of each under dust
};

/// The controller's map of rocks: made from those of the world with a survey's errors, or given.
struct RockMapKeys {
  bool made = false;
  double sigma_m = 0.03;  // of each coordinate of a place; assumed, 0.01-0.10 (a lander's stereo)
  double least_height_m = 0.10;     // lower rocks are not in a made map; assumed, 0.05-0.2
  YamlNode given{};                 // a list of x_m, y_m, radius_m, height_m; kNull: none
  std::vector<MappedRock> rocks{};  // as given
};

struct AxelKeys {
  std::string station_file;  // resolved path
  VisionSettings vision{};   // of the controller's perception; its bracket is the next
  // As of VisionSettings; NaN: its own default where a bracket can be taken, else none.
  double bracket_stops = std::numeric_limits<double>::quiet_NaN();
  double tip_angle_rad =
      std::numeric_limits<double>::quiet_NaN();  // of the cone; NaN: as in the station's file
  double board_dust = 0.0;                       // mean share of the board's face under dust
  DirtyMarks dirty_marks{};
  StartKeys start{};
  Tsai2013Options tsai2013{};  // of the controller of that name; its vision's are in `vision`
  StationMove station_move{};
  RockMapKeys rock_map{};
  double excursion_m = 0.0;  // of a rover that starts seated; 0: it starts outside
  SoilMarks soil_marks = SoilMarks::kRuts;
};

/// Names every key: for reading, and for docs/reference/scenarios.md.
void VisitAxelKeys(Keys& keys, AxelKeys& values);
/// Reads and checks them. Throws ConfigError.
AxelKeys ReadAxelKeys(const Scenario& scenario);

}  // namespace dockyard::axel
