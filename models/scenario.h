// One docking to be simulated: which rover, station, soil, light, start and controller. Read from
// scenarios/*.yaml; a campaign file holds a base scenario and a table of runs.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "controller/io/vision_settings.h"
#include "models/yaml_tree.h"

namespace dockyard {

enum class Light { kEven, kSpeckled, kHardShadow };
const char* LightName(Light light);  // even | speckled | hard_shadow, as in the files

struct StartPose {
  double r_m = 4.0;
  double alpha_rad = 0.0;    // file: alpha_deg
  double heading_rad = 0.0;  // file: heading_deg
};

/// What of the light is not left to its kind; NaN or 0: as the kind draws it, white.
struct SunModel {
  double azimuth_rad = std::numeric_limits<double>::quiet_NaN();    // from the way the board faces
  double elevation_rad = std::numeric_limits<double>::quiet_NaN();  // above the level
  double temperature_k = 0.0, sky_temperature_k = 0.0;              // 0: white
};

/// The yard's grid begins this far behind the dock: clear of the station, which is 0.8 m deep
/// (station.urdf). Assumed, range 1-3 m; it fixes the cells' places and with them every run's bits.
inline constexpr double kYardBehindDock_m = 1.5;

/// The yard: gentle undulation, deterministic in the run's seed.
struct YardModel {
  // Extent of the grid: x from kYardBehindDock_m behind the dock outwards; y centred.
  double length_m = 0.0, width_m = 0.0;
  double cell_m = 0.0;
  double undulation_rms_m = 0.0;
  double undulation_wavelength_m = 0.0;
};

struct Scenario {
  std::string name;
  std::string rover_file, station_file, soil_file;  // resolved paths
  std::string controller = "axel";                  // axel | reel_only
  VisionSettings vision{};
  StartPose start;
  Light light = Light::kEven;
  SunModel sun;
  double board_dust = 0.0;  // mean share of the board's face under dust
  YardModel yard;
  std::string camera_file;                // empty: the rover's own cameras
  int image_width = 0, image_height = 0;  // 0: as the cameras' file says, else 1024 x 768
  bool colour = false;                    // view writes colour pictures beside the grey ones
  double time_limit_s = 600.0;
  double physics_step_s = 1e-3;  // 1e-3 unless a convergence study changes it
  double tip_angle_rad = -1.0;   // < 0: as the station's file says
  // Keys on top of the files of rover, station and soil, by these names; none: kNull.
  YamlNode changes;
  std::uint64_t seed = 1;
  Pose2 X_WG;  // where the whole yard lies in the world (default identity)
  bool log_images = true;
};

/// A row of a campaign's table.
struct CampaignRun {
  int run = 0;
  int day = 0;
  std::string region;  // interior | boundary
  std::string soil;    // key of Campaign::soils
  Scenario scenario;   // fully resolved
};

struct Campaign {
  std::string name;
  std::string file;
  std::uint64_t seed = 1;
  std::vector<CampaignRun> runs;
  std::string resolved_yaml;  // everything, defaults included, for the results folder
};

}  // namespace dockyard
