#include "models/read/load_rover_plan.h"

#include <cmath>

#include "models/read/load_obstacles.h"

namespace dockyard {
namespace {

constexpr double kOnTheLine_m = 1e-6;

std::vector<WheelPlan> ReadWheels(const YamlReader& in) {
  const YamlNode& list = in.List("wheels", 2, 24);
  std::vector<WheelPlan> wheels;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const YamlReader one(list.items[i], YamlReader::PathOf("wheels", i),
                         {"name", "x_m", "y_m", "steer_limit_deg"});
    wheels.push_back({one.Text("name"), ReadPlace(one),
                      one.DegreesOr("steer_limit_deg", 0.0, Between(0.0, 180.0))});
    for (std::size_t k = 0; k < i; ++k) {
      if (wheels[k].name == wheels[i].name) one.Refuse("name", "a name of its own");
    }
  }
  return wheels;
}

std::vector<Polygon> ReadBody(const YamlReader& in) {
  const YamlNode& list = in.List("body", 1, 20);
  std::vector<Polygon> body;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const YamlReader part(list.items[i], YamlReader::PathOf("body", i), {"corners"});
    body.push_back(ReadPolygon(part, "corners"));
  }
  return body;
}

ViewPlan ReadView(const YamlReader& rover) {
  const YamlReader in(rover.Child("view"), "view",
                      {"x_m", "y_m", "azimuth_deg", "half_width_deg", "near_m", "far_m"});
  ViewPlan view;
  view.p_RC = ReadPlace(in);
  view.azimuth_rad = in.DegreesOr("azimuth_deg", 0.0, Between(-180.0, 180.0));
  view.half_width_rad = in.Degrees("half_width_deg", {0.0, 90.0, true});
  view.near_m = in.Number("near_m", NonNegative(1e3));
  view.far_m = in.Number("far_m", Positive(1e3));
  if (view.far_m <= view.near_m) in.Refuse("far_m", "a number above near_m");
  return view;
}

}  // namespace

RoverPlan LoadRoverPlan(const std::string& file) {
  const YamlNode root = LoadYaml(file);
  const YamlReader in(root, "",
                      {"name", "source", "speed_m_s", "steer_rate_deg_s", "wheel", "wheels", "body",
                       "point", "view"});
  RoverPlan rover;
  rover.name = in.Text("name");
  in.Text("source");
  rover.speed_m_s = in.Number("speed_m_s", Positive(10.0));
  rover.steer_rate_rad_s = in.Degrees("steer_rate_deg_s", {0.0, 1e4, true});
  const YamlReader wheel(in.Child("wheel"), "wheel", {"radius_m", "width_m"});
  rover.wheel_radius_m = wheel.Number("radius_m", Positive(2.0));
  rover.wheel_width_m = wheel.Number("width_m", Positive(2.0));
  rover.wheels = ReadWheels(in);
  const std::optional<double> line_m = TurningLine_m(rover.wheels);
  if (line_m && std::abs(*line_m) > kOnTheLine_m) {
    in.Refuse("wheels", "fixed wheels whose places have a mean x_m of 0",
              "one of " + std::to_string(*line_m));
  }
  rover.body = ReadBody(in);
  rover.p_RP = ReadPlace(YamlReader(in.Child("point"), "point", {"x_m", "y_m"}));
  if (in.Has("view")) rover.view = ReadView(in);
  return rover;
}

}  // namespace dockyard
