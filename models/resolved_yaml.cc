#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <string>

#include "controller/base/check.h"
#include "models/load_scenario.h"
#include "models/yaml_reader.h"

namespace dockyard {
namespace {

/// The number of degrees, as short as can be, that Radians turns into exactly this angle.
std::string DegreesText(double angle_rad) {
  const double nearest = Degrees(angle_rad);
  for (const double scale : {1.0, 10.0, 1e3, 1e6, 1e9}) {
    const double rounded = std::round(nearest * scale) / scale;
    if (Radians(rounded) == angle_rad) return NumberText(rounded == 0.0 ? 0.0 : rounded);
  }
  double below = nearest, above = nearest;
  for (int i = 0; i < 8; ++i) {
    if (Radians(below) == angle_rad) return NumberText(below);
    if (Radians(above) == angle_rad) return NumberText(above);
    below = std::nextafter(below, -std::numeric_limits<double>::infinity());
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
  }
  return NumberText(nearest);
}

std::string Quoted(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + '"';
}

std::string PathText(const std::string& file) {
  return Quoted(std::filesystem::absolute(file).lexically_normal().string());
}

std::string StartText(const StartPose& start) {
  return "r_m: " + NumberText(start.r_m) + ", alpha_deg: " + DegreesText(start.alpha_rad) +
         ", heading_deg: " + DegreesText(start.heading_rad);
}

/// Only what the file said.
std::string SunText(const SunModel& sun) {
  std::string text;
  const auto add = [&](bool said, const char* key, const std::string& value) {
    if (said) text += (text.empty() ? "{" : ", ") + std::string(key) + ": " + value;
  };
  add(!std::isnan(sun.azimuth_rad), "azimuth_deg", DegreesText(sun.azimuth_rad));
  add(!std::isnan(sun.elevation_rad), "elevation_deg", DegreesText(sun.elevation_rad));
  add(sun.temperature_k > 0.0, "temperature_k", NumberText(sun.temperature_k));
  add(sun.sky_temperature_k > 0.0, "sky_temperature_k", NumberText(sun.sky_temperature_k));
  return text.empty() ? text : text + "}";
}

/// What the runs of a campaign have in common, each line indented.
std::string CommonText(const Scenario& s, const std::string& indent) {
  const auto line = [&](const std::string& key, const std::string& value) {
    return indent + key + ": " + value + "\n";
  };
  std::string text = line("rover", PathText(s.rover_file));
  text += line("station", PathText(s.station_file));
  text += line("controller", s.controller);
  text += line("vision", std::string("{pipeline: ") + PipelineName(s.vision.pipeline) +
                             ", min_points: " + std::to_string(s.vision.min_points) + "}");
  text += line(
      "yard", "{length_m: " + NumberText(s.yard.length_m) + ", width_m: " +
                  NumberText(s.yard.width_m) + ", cell_m: " + NumberText(s.yard.cell_m) +
                  ", undulation_rms_m: " + NumberText(s.yard.undulation_rms_m) +
                  ", undulation_wavelength_m: " + NumberText(s.yard.undulation_wavelength_m) + "}");
  std::string camera;
  if (!s.camera_file.empty()) camera = "file: " + PathText(s.camera_file);
  if (s.image_width > 0) {
    camera += (camera.empty() ? "" : ", ") + ("width_px: " + std::to_string(s.image_width)) +
              ", height_px: " + std::to_string(s.image_height);
  }
  if (s.colour) camera += (camera.empty() ? "" : ", ") + std::string("colour: true");
  if (!camera.empty()) text += line("camera", "{" + camera + "}");
  if (const std::string sun = SunText(s.sun); !sun.empty()) text += line("sun", sun);
  if (s.board_dust > 0.0) text += line("board_dust", NumberText(s.board_dust));
  text += line("time_limit_s", NumberText(s.time_limit_s));
  text += line("physics_step_s", NumberText(s.physics_step_s));
  if (s.tip_angle_rad >= 0.0) text += line("tip_angle_deg", DegreesText(s.tip_angle_rad));
  text += line("site", "{x_m: " + NumberText(s.X_WG.x) + ", y_m: " + NumberText(s.X_WG.y) +
                           ", heading_deg: " + DegreesText(s.X_WG.heading) + "}");
  if (s.changes.kind == YamlNode::Kind::kMapping) text += line("changes", FlowText(s.changes));
  text += line("log_images", s.log_images ? "true" : "false");
  return text;
}

}  // namespace

std::string ResolvedYaml(const Scenario& scenario) {
  std::string text = "name: " + Quoted(scenario.name) + "\n";
  text += "seed: " + std::to_string(scenario.seed) + "\n";
  text += "start: {" + StartText(scenario.start) + "}\n";
  text += std::string("light: ") + LightName(scenario.light) + "\n";
  text += "soil: " + PathText(scenario.soil_file) + "\n";
  return text + CommonText(scenario, "");
}

std::string ResolvedYaml(const Campaign& campaign) {
  DOCKYARD_CHECK(!campaign.runs.empty());
  std::map<std::string, std::string> soils;
  for (const CampaignRun& run : campaign.runs) soils[run.soil] = run.scenario.soil_file;
  std::string text = "campaign: " + Quoted(campaign.name) + "\n";
  text += "seed: " + std::to_string(campaign.seed) + "\n";
  text += "scenario:\n" + CommonText(campaign.runs.front().scenario, "  ");
  text += "soils:\n";
  for (const auto& [name, file] : soils) text += "  " + Quoted(name) + ": " + PathText(file) + "\n";
  text += "runs:\n";
  for (const CampaignRun& run : campaign.runs) {
    text += "  - {run: " + std::to_string(run.run) + ", day: " + std::to_string(run.day) +
            ", region: " + run.region + ", soil: " + Quoted(run.soil) +
            ", light: " + LightName(run.scenario.light) + ", " + StartText(run.scenario.start) +
            "}\n";
  }
  return text;
}

}  // namespace dockyard
