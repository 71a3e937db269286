// One run to be simulated: which system, robot, soil, light, start and controller. Read from
// scenarios/*.yaml.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "controller/geometry/pose.h"
#include "models/parts/rock_field.h"
#include "models/read/yaml_tree.h"
#include "sim/base/random.h"
#include "sim/scenario/scenery.h"
#include "sim/scenario/start.h"

namespace dockyard {

enum class Light { kEven, kSpeckled, kHardShadow, kRoom };
/// even | speckled | hard_shadow | room, as in the files.
const char* LightName(Light light);

/// Stray light of the lenses of all cameras, under `camera.stray`. None by default. Sources:
/// docs/reference/images.md.
struct StrayModel {
  double veil = 0.0;               // share of the light that is scattered
  double core_rad = Radians(0.5);  // of the scattered light; assumed, 0.2-2 deg
  double ghosts = 0.0;             // share of the sun's light in ghosts
};

/// Overrides of the light's defaults. NaN (angles) or 0 (temperatures) keeps the default: random
/// angles, white light.
struct SunModel {
  double azimuth_rad = std::numeric_limits<double>::quiet_NaN();    // from the way the target faces
  double elevation_rad = std::numeric_limits<double>::quiet_NaN();  // above the level
  double temperature_k = 0.0, sky_temperature_k = 0.0;
  // Optical depth of the air, by which the light follows the sun's height; NaN: it does not.
  double opacity = std::numeric_limits<double>::quiet_NaN();
  StrayModel stray{};
  // Instead of the two angles (sun_date.h): month and day, and the local solar time.
  std::string date{};
  double hour = std::numeric_limits<double>::quiet_NaN();
  // Whether it moves during a run (sun_path.h), and where on the Earth: the Mars Yard at JPL,
  // 34.20 deg N.
  bool moving = false;
  double latitude_rad = Radians(34.2);
  // Of the north, as azimuth_rad; NaN: the sun is in the meridian at the start.
  double north_rad = std::numeric_limits<double>::quiet_NaN();
};

/// The yard: a slope with gentle undulation, deterministic in the run's seed.
/// A file of heights: sim/plant/height_file.h.
struct YardHeights {
  std::string file{};                                        // resolved path; empty: none
  double cell_m = std::numeric_limits<double>::quiet_NaN();  // NaN: as the file says
  double scale_m = 1.0;                                      // of 1 in the file
  Pose2 X_GM{};  // of the map's middle, x along its rows, y up its columns
};

/// A part of the yard with a soil of its own: a rectangle, a disc or a polygon.
struct YardPatch {
  std::string soil_file;                     // resolved path
  Pose2 X_DP;                                // of rectangle and disc
  double length_m = 0.0, width_m = 0.0;      // of a rectangle
  double radius_m = 0.0;                     // of a disc
  std::vector<Eigen::Vector2d> corners_D{};  // of a polygon
  std::string place;                         // "file:line:column: yard.patches[0]"
};

struct YardModel {
  // Gentle undulation as on the Mars Yard's docking site ("relatively small terrain undulations",
  // Tsai et al., IV): assumed 10 mm rms, range 0-30 mm, over 2 m, range 1-5 m. The yard reaches 3 m
  // beyond the farthest start of 7 m; cells of 20 mm, range 10-40 mm.
  double length_m = 12.0;  // x, from kYardBehind_m behind the target outwards
  double width_m = 12.0;   // y, centred
  double cell_m = 0.02;
  double undulation_rms_m = 0.010;
  double undulation_wavelength_m = 2.0;
  double slope_rad = 0.0;     // of the whole yard
  double downhill_rad = 0.0;  // the way down, from the way the target faces
  YardHeights heights{};
  std::vector<YardPatch> patches{};  // later ones lie on earlier ones
  YamlNode given_patches{};          // the same as they are written. kNull: none
};
/// The grid begins this far behind the target.
inline constexpr double kYardBehind_m = 1.5;

/// Faults of one camera. In the picture, sides count from the right, counter-clockwise.
struct EyeFaults {
  enum class Picture { kNormal, kDark, kNone };
  Picture picture = Picture::kNormal;
  double cover_share = 0.0, cover_side_rad = 0.0;  // of an opaque cover on the window
  double dust_share = 0.0;                         // of the picture, behind clumps of dust
  double dust_clump_m = 3e-4;                      // median diameter; assumed, 0.1-1 mm
  // Bright dust scatters most of the light on it, and part of that into the pupil.
  double dust_scatter = 0.3;  // of that light, what veils the picture; assumed, 0.1-0.6
};

/// Faults of a robot's cameras. None by default.
struct CameraFaults {
  double delay_s = 0.0;  // from a picture's exposure to its arrival
  double lost = 0.0;     // probability that what was asked for never arrives
  // Ahead of the controller's clock: at power-on, and the share that it gains [1e-6].
  double clock_offset_s = 0.0, clock_drift_ppm = 0.0;
  // The pupil of the rovers' hazard cameras: 5.58 mm at f/15 (Maki et al., JGR 108, 2003; MER).
  // Range 0.3-1.2 mm; the Navcams' is 1.22 mm (14.67 mm at f/12).
  double pupil_m = 0.37e-3;
  double window_m = 0.02;  // from the pupil to cover and dust; assumed, 5-50 mm
  EyeFaults left, right;
};

/// Whether the camera is dead or anything lies on its window.
bool Spoils(const EyeFaults& eye);

struct Scenario {
  std::string name;
  std::string system;                              // name of a system
  std::string robot_file, soil_file, camera_file;  // resolved paths; empty: none named
  std::string controller;                          // a name that the system knows
  std::vector<std::string> command;                // else: a program that is the controller,
  std::vector<std::string> command_files{};        // that it needs, from there on
  std::string command_folder;                      // and where it runs: its file's folder
  std::uint64_t controller_seed = 1;               // of the program's own draws
  Start start;
  // "file:line:column: start", for messages
  std::string start_place, camera_place, yard_place, rocks_place, sun_place, step_place;
  Light light = Light::kEven;
  SunModel sun;
  YardModel yard;
  RockField rocks;
  std::vector<SceneryItem> scenery;
  YamlNode given_scenery;                 // the same as it is written. kNull: none
  YamlNode given_rocks;                   // RockField::given as it is written. kNull: none
  int image_width = 0, image_height = 0;  // 0: as the cameras' file says, else the system's default
  CameraFaults camera_faults;
  bool colour = false;  // view writes colour images beside the grey ones
  double time_limit_s = 600.0;
  double physics_step_s = 1e-3;  // 1e-3 unless a convergence study changes it
  Seed seed;
  Pose2 X_WG;  // where the whole yard lies in the world (default identity)
  bool log_images = true;
  // Of the images that a log keeps of a camera, but at a change of phase; 0: all are kept.
  double log_image_gap_s = 0.0;
  YamlNode of_system;  // the mapping under the system's own name; the system reads it. kNull: none
  YamlNode changes;    // keys on top of the model files, by model; the system reads it. kNull: none
  YamlNode
      as_built;     // the same on top of `changes`, in the world alone; the controller is not told
  YamlNode script;  // open-loop commands in place of a controller; the system reads it. kNull: none
};

/// A model under `changes` and `as_built`, and the scenario's dotted key that names its file.
struct ModelRoot {
  std::string name;      // "station"
  std::string file_key;  // "axel.station"
};

/// A name that files of earlier versions give.
struct FormerName {
  std::string former, now;
};

/// The part of a system that a reader needs to check a scenario.
struct KnownSystem {
  std::string name{};
  std::vector<std::string> controllers{};  // the first is the default
  std::vector<std::string> file_keys{};    // keys under its own name whose values are files
  // The same under `changes` and `as_built`. The reader makes all absolute, so that a scenario can
  // be written into another folder.
  std::vector<std::string> changes_file_keys{};
  std::vector<ModelRoot> model_roots{};  // models whose files may have spreads
  bool spoiled_pictures = false;         // whether its cameras may be dead, covered or dusty
  bool rocks = false;                    // whether rocks may lie in its yard
  std::vector<FormerName> former_controllers{};
  Start start{};                         // the numbers that a start has
  std::vector<std::string> root_keys{};  // keys under its own name that may be at the root instead
};

/// One run of many, or alone.
struct CampaignRun {
  int run = 0;
  std::vector<std::string> labels;  // by the campaign's names of labels
  Scenario scenario;                // fully resolved
};

}  // namespace dockyard
