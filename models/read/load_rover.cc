#include "models/read/load_rover.h"

#include <algorithm>
#include <cmath>

#include "models/read/config_error.h"
#include "models/read/load_arm.h"
#include "models/read/load_mast.h"
#include "models/read/load_motor.h"
#include "models/read/load_obstacles.h"
#include "models/read/load_wheel.h"

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

RoverPlan ReadPlan(const YamlReader& in) {
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

// A box of even density.
LinkModel ReadBox(const YamlReader& build) {
  const YamlReader in(build.Child("body"), build.PathOf("body"),
                      {"mass_kg", "x_m", "z_m", "length_m", "width_m", "height_m"});
  LinkModel body;
  body.name = "body";
  body.mass_kg = in.Number("mass_kg", Positive(1e4));
  body.p_LoCom_L = {in.Number("x_m", Between(-10.0, 10.0)), 0.0,
                    in.Number("z_m", Between(-10.0, 10.0))};
  const Eigen::Vector3d size(in.Number("length_m", Positive(10.0)),
                             in.Number("width_m", Positive(10.0)),
                             in.Number("height_m", Positive(10.0)));
  const Eigen::Vector3d squares = size.cwiseProduct(size);
  body.I_LCom_L.diagonal() =
      body.mass_kg / 12.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
  body.collisions = {{"body", BoxShape{size}, {Eigen::Matrix3d::Identity(), body.p_LoCom_L}}};
  return body;
}

SuspensionModel ReadSuspension(const YamlReader& build) {
  const std::string path = build.PathOf("suspension");
  const YamlReader in(
      build.Child("suspension"), path,
      {"kind", "pivot_x_m", "pivot_z_m", "bogie_x_m", "bogie_z_m", "rocker_mass_kg",
       "bogie_mass_kg", "friction_nm", "rocker_stop_deg", "bogie_stop_deg", "on_bogies"});
  SuspensionModel suspension;
  if (in.Choice("kind", {"rigid", "rocker_bogie"}) == 0) {
    if (build.Child("suspension").keys.size() > 1) in.Refuse("kind", "no other key beside rigid");
    return suspension;
  }
  suspension.kind = SuspensionKind::kRockerBogie;
  suspension.pivot_x_m = in.Number("pivot_x_m", Between(-10.0, 10.0));
  suspension.pivot_z_m = in.Number("pivot_z_m", Between(-10.0, 10.0));
  suspension.bogie_x_m = in.Number("bogie_x_m", Between(-10.0, 10.0));
  suspension.bogie_z_m = in.Number("bogie_z_m", Between(-10.0, 10.0));
  suspension.rocker_kg = in.Number("rocker_mass_kg", Positive(1e3));
  suspension.bogie_kg = in.Number("bogie_mass_kg", Positive(1e3));
  suspension.friction_nm = in.Number("friction_nm", NonNegative(100.0));
  suspension.rocker_stop_rad = in.Degrees("rocker_stop_deg", {0.0, 90.0, true});
  suspension.bogie_stop_rad = in.Degrees("bogie_stop_deg", {0.0, 90.0, true});
  return suspension;
}

// Each side's rocker and bogie carry wheels.
void CheckSides(const YamlReader& build, const RoverPlan& plan, const std::vector<bool>& on_bogie) {
  int carried[2][2] = {};
  for (std::size_t i = 0; i < plan.wheels.size(); ++i) {
    const double y = plan.wheels[i].p_RW.y();
    if (y == 0.0) build.Refuse("suspension", "wheels on either side, none on the middle line");
    ++carried[y > 0.0][on_bogie[i]];
  }
  for (const auto& side : carried) {
    if (side[0] > 0 && side[1] > 0) continue;
    build.Refuse("suspension", "on_bogies with some of each side's wheels, not all");
  }
}

// By wheel, from the list of names.
std::vector<bool> ReadOnBogies(const YamlReader& build, const RoverPlan& plan) {
  std::vector<bool> on_bogie(plan.wheels.size(), false);
  const YamlNode* names = build.Child("suspension").Find("on_bogies");
  if (names == nullptr) build.Refuse("suspension", "on_bogies, the wheels that the bogies carry");
  for (const YamlNode& name : names->items) {
    const auto named =
        std::find_if(plan.wheels.begin(), plan.wheels.end(),
                     [&](const WheelPlan& wheel) { return wheel.name == name.scalar; });
    if (named == plan.wheels.end()) {
      throw ConfigError(name.place.Text() + ": expected the name of a wheel, found " +
                        name.Found());
    }
    on_bogie[static_cast<std::size_t>(named - plan.wheels.begin())] = true;
  }
  CheckSides(build, plan, on_bogie);
  return on_bogie;
}

const std::vector<std::string> kKeys{"name",  "source", "speed_m_s", "steer_rate_deg_s",
                                     "wheel", "wheels", "body",      "point",
                                     "view",  "build"};

}  // namespace

RoverPlan LoadRoverPlan(const std::string& file) {
  const YamlNode root = LoadYaml(file);
  return ReadPlan(YamlReader(root, "", kKeys));
}

std::vector<std::string> RoverKeys(const std::vector<std::string>& more) {
  std::vector<std::string> keys = kKeys;
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

RoverModel LoadRover(const std::string& file) {
  const YamlNode root = LoadYaml(file);
  return ReadRover(YamlReader(root, "", kKeys));
}

RoverModel ReadRover(const YamlReader& in) {
  RoverModel rover;
  rover.plan = ReadPlan(in);
  const YamlReader build(in.Child("build"), "build",
                         {"body", "wheel_mass_kg", "bracket_mass_kg", "paddles", "suspension",
                          "drive", "steer", "arm", "mast"});
  rover.body = ReadBox(build);
  rover.suspension = ReadSuspension(build);
  rover.on_bogie.assign(rover.plan.wheels.size(), false);
  if (rover.suspension.kind == SuspensionKind::kRockerBogie) {
    rover.on_bogie = ReadOnBogies(build, rover.plan);
  }
  rover.wheel_kg = build.Number("wheel_mass_kg", Positive(1e3));
  rover.bracket_kg = build.Number("bracket_mass_kg", Positive(1e3));
  rover.tyre.rim_radius_m = rover.plan.wheel_radius_m;
  rover.tyre.width_m = rover.plan.wheel_width_m;
  ReadPaddles(build, rover.tyre);
  rover.drive = ReadMotor(build.Child("drive"), build.PathOf("drive"));
  rover.steer = ReadMotor(build.Child("steer"), build.PathOf("steer"));
  if (build.Has("arm")) rover.arm = ReadArm(build.Child("arm"), build.PathOf("arm"));
  if (build.Has("mast")) rover.mast = ReadMast(build.Child("mast"), build.PathOf("mast"));
  return rover;
}

}  // namespace dockyard
