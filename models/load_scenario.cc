#include "models/load_scenario.h"

#include <cmath>

#include "models/config_error.h"
#include "models/load_cameras.h"
#include "models/load_rover.h"
#include "models/load_soil.h"
#include "models/load_station.h"
#include "models/scenario_reader.h"

namespace dockyard {
namespace {

// Gentle undulation as on the Mars Yard's docking site ("relatively small terrain undulations",
// Tsai et al., IV): assumed 10 mm rms, range 0-30 mm, over 2 m, range 1-5 m. The yard reaches 3 m
// beyond the farthest start of 7 m; cells of 20 mm, range 10-40 mm.
constexpr YardModel kDefaultYard{.length_m = 12.0,
                                 .width_m = 12.0,
                                 .cell_m = 0.02,
                                 .undulation_rms_m = 0.010,
                                 .undulation_wavelength_m = 2.0};
constexpr double kYardBehindDock_m = 2.0;  // as in YardModel
constexpr double kMaxCells = 4e6;

YardModel ReadYard(const YamlReader& root) {
  if (!root.Has("yard")) return kDefaultYard;
  const YamlReader in(
      root.Child("yard"), root.PathOf("yard"),
      {"length_m", "width_m", "cell_m", "undulation_rms_m", "undulation_wavelength_m"});
  YardModel yard;
  yard.length_m = in.NumberOr("length_m", kDefaultYard.length_m, Between(4.0, 200.0));
  yard.width_m = in.NumberOr("width_m", kDefaultYard.width_m, Between(4.0, 200.0));
  yard.cell_m = in.NumberOr("cell_m", kDefaultYard.cell_m, Between(0.002, 0.2));
  yard.undulation_rms_m =
      in.NumberOr("undulation_rms_m", kDefaultYard.undulation_rms_m, NonNegative(0.2));
  yard.undulation_wavelength_m = in.NumberOr(
      "undulation_wavelength_m", kDefaultYard.undulation_wavelength_m, Between(0.2, 50.0));
  if (yard.length_m * yard.width_m / (yard.cell_m * yard.cell_m) > kMaxCells) {
    root.Refuse("yard", "at most 4 million cells");
  }
  return yard;
}

void ReadCamera(const YamlReader& root, Scenario& scenario) {
  if (!root.Has("camera")) return;
  const YamlReader in(root.Child("camera"), root.PathOf("camera"),
                      {"file", "width_px", "height_px", "colour"});
  if (in.Has("file")) scenario.camera_file = in.File("file");
  if (in.Has("width_px") || in.Has("height_px")) {
    scenario.image_width = in.IntegerOr("width_px", kDefaultImageWidth, 64, 4096);
    scenario.image_height = in.IntegerOr("height_px", kDefaultImageHeight, 64, 4096);
  }
  scenario.colour = in.BoolOr("colour", scenario.colour);
}

VisionSettings ReadVision(const YamlReader& root) {
  VisionSettings vision;
  if (!root.Has("vision")) return vision;
  const YamlReader in(root.Child("vision"), root.PathOf("vision"), {"pipeline", "min_points"});
  const std::vector<std::string> pipelines{PipelineName(VisionPipeline::kDockyard),
                                           PipelineName(VisionPipeline::kTsai2013)};
  vision.pipeline = static_cast<VisionPipeline>(in.ChoiceOr("pipeline", 0, pipelines));
  vision.min_points = in.IntegerOr("min_points", vision.min_points, 4, 5);
  return vision;
}

SunModel ReadSun(const YamlReader& root) {
  SunModel sun;
  if (!root.Has("sun")) return sun;
  const YamlReader in(root.Child("sun"), root.PathOf("sun"),
                      {"azimuth_deg", "elevation_deg", "temperature_k", "sky_temperature_k"});
  sun.azimuth_rad = in.DegreesOr("azimuth_deg", sun.azimuth_rad, Between(-180.0, 180.0));
  sun.elevation_rad = in.DegreesOr("elevation_deg", sun.elevation_rad, Between(2.0, 90.0));
  // The Planckian locus is known from 1667 to 25000 K.
  sun.temperature_k = in.NumberOr("temperature_k", sun.temperature_k, Between(1667.0, 25000.0));
  sun.sky_temperature_k =
      in.NumberOr("sky_temperature_k", sun.sky_temperature_k, Between(1667.0, 25000.0));
  return sun;
}

Pose2 ReadSite(const YamlReader& root) {
  if (!root.Has("site")) return {};
  const YamlReader in(root.Child("site"), root.PathOf("site"), {"x_m", "y_m", "heading_deg"});
  return {.x = in.NumberOr("x_m", 0.0, Between(-1e6, 1e6)),
          .y = in.NumberOr("y_m", 0.0, Between(-1e6, 1e6)),
          .heading = in.DegreesOr("heading_deg", 0.0, Between(-180.0, 180.0))};
}

YamlNode LoadWith(const std::string& file, const std::vector<std::string>& overrides) {
  YamlNode root = LoadYaml(file);
  for (const std::string& assignment : overrides) SetYaml(root, assignment);
  return root;
}

}  // namespace

const std::vector<std::string>& LightWords() {
  static const std::vector<std::string> words{LightName(Light::kEven), LightName(Light::kSpeckled),
                                              LightName(Light::kHardShadow)};
  return words;
}

StartPose ReadStart(const YamlReader& in) {
  StartPose start;
  start.r_m = in.Number("r_m", Between(0.5, 100.0));
  start.alpha_rad = in.Degrees("alpha_deg", Between(-90.0, 90.0));
  start.heading_rad = in.Degrees("heading_deg", Between(-180.0, 180.0));
  return start;
}

void CheckStartInYard(const Scenario& scenario, const YamlReader& start) {
  constexpr double kMargin_m = 1.0;
  const double x = scenario.start.r_m * std::cos(scenario.start.alpha_rad);
  const double y = scenario.start.r_m * std::sin(scenario.start.alpha_rad);
  const double x_end = scenario.yard.length_m - kYardBehindDock_m - kMargin_m;
  const double y_end = 0.5 * scenario.yard.width_m - kMargin_m;
  if (x > x_end || std::abs(y) > y_end) {
    start.Refuse("r_m", "a start inside the yard (x up to " + NumberText(x_end) + " m, y up to +-" +
                            NumberText(y_end) + " m)");
  }
}

Scenario ReadScenario(const YamlNode& node, const std::string& path, ScenarioPart part) {
  const YamlReader in(node, path,
                      {"name", "rover", "station", "soil", "controller", "vision", "start", "light",
                       "sun", "board_dust", "yard", "camera", "time_limit_s", "physics_step_s",
                       "tip_angle_deg", "seed", "site", "log_images", "changes"});
  const bool whole = part == ScenarioPart::kWhole;
  Scenario scenario;
  if (whole || in.Has("name")) scenario.name = in.Text("name");
  scenario.rover_file = in.File("rover");
  scenario.station_file = in.File("station");
  if (whole || in.Has("soil")) scenario.soil_file = in.File("soil");
  const std::vector<std::string> controllers{"axel", "reel_only"};
  scenario.controller =
      controllers[static_cast<std::size_t>(in.ChoiceOr("controller", 0, controllers))];
  scenario.vision = ReadVision(in);
  scenario.light = static_cast<Light>(in.ChoiceOr("light", 0, LightWords()));
  scenario.sun = ReadSun(in);
  scenario.board_dust = in.NumberOr("board_dust", scenario.board_dust, NonNegative(0.6));
  scenario.yard = ReadYard(in);
  ReadCamera(in, scenario);
  scenario.time_limit_s = in.NumberOr("time_limit_s", scenario.time_limit_s, Positive(1e5));
  scenario.physics_step_s =
      in.NumberOr("physics_step_s", scenario.physics_step_s, Between(1e-5, 1e-2));
  scenario.tip_angle_rad =
      in.DegreesOr("tip_angle_deg", scenario.tip_angle_rad, Between(0.0, 30.0));
  scenario.seed = in.SeedOr("seed", scenario.seed);
  scenario.X_WG = ReadSite(in);
  if (in.Has("changes")) {
    // Only named here; what they change checks them, when the models are loaded.
    const YamlReader known(in.Child("changes"), in.PathOf("changes"), {"rover", "station", "soil"});
    scenario.changes = in.Child("changes");
  }
  scenario.log_images = in.BoolOr("log_images", scenario.log_images);
  if (whole || in.Has("start")) {
    const YamlReader start(in.Child("start"), in.PathOf("start"),
                           {"r_m", "alpha_deg", "heading_deg"});
    scenario.start = ReadStart(start);
    CheckStartInYard(scenario, start);
  }
  return scenario;
}

Scenario LoadScenario(const std::string& file, const std::vector<std::string>& overrides) {
  const YamlNode root = LoadWith(file, overrides);
  if (root.Find("campaign") != nullptr) {
    throw ConfigError(root.place.Text() + ": expected one scenario, found a campaign");
  }
  return ReadScenario(root, "", ScenarioPart::kWhole);
}

ScenarioModels LoadModels(const Scenario& scenario) {
  const YamlNode& changes = scenario.changes;
  ScenarioModels models{LoadRover(scenario.rover_file, scenario.image_width, scenario.image_height,
                                  changes.Find("rover")),
                        LoadStation(scenario.station_file, changes.Find("station")),
                        LoadSoil(scenario.soil_file, changes.Find("soil"))};
  CheckCarries(models.soil, scenario.soil_file, models.rover.left_wheel_soil);
  if (!scenario.camera_file.empty()) {
    models.rover.stereo.nominal =
        LoadRig(scenario.camera_file, scenario.image_width, scenario.image_height);
  }
  if (scenario.vision.pipeline == VisionPipeline::kTsai2013 &&
      !HasTwoOfEachRotation(models.station.board)) {
    throw ConfigError(scenario.station_file +
                      ": board: expected two bars of each rotation, as vision.pipeline: tsai2013 "
                      "needs them, found others");
  }
  if (scenario.tip_angle_rad >= 0.0) models.station.tip_angle_rad = scenario.tip_angle_rad;
  if (models.rover.tip.radius_m >= models.station.cone.throat_radius_m) {
    throw ConfigError(scenario.station_file + ": cone.throat_radius_m: expected more than the " +
                      NumberText(models.rover.tip.radius_m) + " m of the arm's tip in " +
                      scenario.rover_file + ", found '" +
                      NumberText(models.station.cone.throat_radius_m) + "'");
  }
  return models;
}

}  // namespace dockyard
