#include "models/read/load_rover.h"

#include <algorithm>
#include <cmath>

#include "models/read/config_error.h"
#include "models/read/load_arm.h"
#include "models/read/load_contact.h"
#include "models/read/load_mast.h"
#include "models/read/load_motor.h"
#include "models/read/load_obstacles.h"
#include "models/read/load_wheel.h"

namespace dockyard {
namespace {

constexpr double kOnTheLine_m = 1e-6;

void VisitWheels(Keys& keys, std::vector<WheelPlan>& wheels) {
  keys.Items("wheels", wheels, 2, 24, [&](Keys& in, WheelPlan& wheel) {
    in.Text("name", wheel.name);
    VisitPlace(in, wheel.p_RW);
    in.Degrees(Optional("steer_limit_deg"), wheel.steer_limit_rad, Between(0.0, 180.0));
    const auto same = [&](const WheelPlan& other) { return other.name == wheel.name; };
    in.Check("name", std::count_if(wheels.begin(), wheels.end(), same) == 1, "a name of its own");
  });
}

void VisitView(Keys& keys, ViewPlan& view) {
  VisitPlace(keys, view.p_RC);
  keys.Degrees(Optional("azimuth_deg"), view.azimuth_rad, Between(-180.0, 180.0));
  keys.Degrees("half_width_deg", view.half_width_rad, Positive(90.0));
  keys.Number("near_m", view.near_m, NonNegative(1e3));
  keys.Number("far_m", view.far_m, Positive(1e3));
  keys.Check("far_m", view.far_m > view.near_m, "a number above near_m");
}

void VisitPlan(Keys& keys, RoverPlan& plan) {
  std::string source;
  YamlNode body;  // ReadBody reads it
  keys.Text("name", plan.name);
  keys.Text("source", source);
  keys.Number("speed_m_s", plan.speed_m_s, Positive(10.0));
  keys.Degrees("steer_rate_deg_s", plan.steer_rate_rad_s, Positive(1e4));
  keys.Mapping("wheel", [&](Keys& in) {
    in.Number("radius_m", plan.wheel_radius_m, Positive(2.0));
    in.Number("width_m", plan.wheel_width_m, Positive(2.0));
  });
  VisitWheels(keys, plan.wheels);
  const double line_m = TurningLine_m(plan.wheels).value_or(0.0);
  keys.Check("wheels", std::abs(line_m) <= kOnTheLine_m,
             "fixed wheels whose places have a mean x_m of 0", "one of " + std::to_string(line_m));
  keys.Tree("body", body, YamlNode::Kind::kNull);
  keys.Mapping("point", [&](Keys& in) { VisitPlace(in, plan.p_RP); });
  keys.Mapping(Unset("view"),
               [&](Keys& in) { VisitView(in, plan.view ? *plan.view : plan.view.emplace()); });
}

// A box of even density.
void VisitBox(Keys& keys, LinkModel& body) {
  body.name = "body";
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  keys.Number("mass_kg", body.mass_kg, Positive(1e4));
  keys.Number("x_m", body.p_LoCom_L.x(), Between(-10.0, 10.0));
  keys.Number("z_m", body.p_LoCom_L.z(), Between(-10.0, 10.0));
  keys.Number("length_m", size.x(), Positive(10.0));
  keys.Number("width_m", size.y(), Positive(10.0));
  keys.Number("height_m", size.z(), Positive(10.0));
  const Eigen::Vector3d squares = size.cwiseProduct(size);
  body.I_LCom_L.diagonal() =
      body.mass_kg / 12.0 * (Eigen::Vector3d::Constant(squares.sum()) - squares);
  body.collisions = {{"body", BoxShape{size}, {Eigen::Matrix3d::Identity(), body.p_LoCom_L}}};
}

void VisitSuspension(Keys& keys, SuspensionModel& suspension) {
  YamlNode on_bogies;  // ReadOnBogies reads it
  keys.Choice("kind", suspension.kind, {"rigid", "rocker_bogie"});
  const bool bogie = suspension.kind == SuspensionKind::kRockerBogie;
  const auto number = [&](const char* key, double& value, const Range& range) {
    keys.Number(keys.NeededIf(bogie, key), value, range);
  };
  number("pivot_x_m", suspension.pivot_x_m, Between(-10.0, 10.0));
  number("pivot_z_m", suspension.pivot_z_m, Between(-10.0, 10.0));
  number("bogie_x_m", suspension.bogie_x_m, Between(-10.0, 10.0));
  number("bogie_z_m", suspension.bogie_z_m, Between(-10.0, 10.0));
  number("rocker_mass_kg", suspension.rocker_kg, Positive(1e3));
  number("bogie_mass_kg", suspension.bogie_kg, Positive(1e3));
  number("friction_nm", suspension.friction_nm, NonNegative(100.0));
  keys.Degrees(keys.NeededIf(bogie, "rocker_stop_deg"), suspension.rocker_stop_rad, Positive(90.0));
  keys.Degrees(keys.NeededIf(bogie, "bogie_stop_deg"), suspension.bogie_stop_rad, Positive(90.0));
  keys.Mapping(keys.NeededIf(bogie, "stop"), [&](Keys& in) { VisitStop(in, suspension.stop); });
  keys.Tree(Unset("on_bogies"), on_bogies, YamlNode::Kind::kNull);
}

void VisitBuild(Keys& keys, RoverModel& rover) {
  keys.Mapping("body", [&](Keys& in) { VisitBox(in, rover.body); });
  keys.Mapping("suspension", [&](Keys& in) { VisitSuspension(in, rover.suspension); });
  keys.Number("wheel_mass_kg", rover.wheel_kg, Positive(1e3));
  keys.Number("bracket_mass_kg", rover.bracket_kg, Positive(1e3));
  VisitPaddles(keys, rover.tyre);
  keys.Mapping("drive", [&](Keys& in) { VisitMotor(in, rover.drive); });
  keys.Mapping("steer", [&](Keys& in) { VisitMotor(in, rover.steer); });
  keys.Mapping(Optional("contacts"), [&](Keys& in) {
    const auto Of = [&](const char* part, ContactMaterial& material) {
      in.Mapping(Optional(part), [&](Keys& of) { VisitYield(of, material, Presence::kDefault); });
    };
    Of("wheels", rover.contacts.wheels);
    Of("arm", rover.contacts.arm);
    Of("body", rover.contacts.body);
  });
  keys.Mapping(Unset("arm"),
               [&](Keys& in) { VisitArm(in, rover.arm ? *rover.arm : rover.arm.emplace()); });
  keys.Mapping(Unset("mast"),
               [&](Keys& in) { VisitMast(in, rover.mast ? *rover.mast : rover.mast.emplace()); });
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

// What the visit leaves: the body's outline, and what wheels and suspension must have in common.
void FinishRover(const YamlReader& in, RoverModel& rover) {
  rover.plan.body = ReadBody(in);
  const YamlReader build(in.Child("build"), "build",
                         KeyNames([&](Keys& keys) { VisitBuild(keys, rover); }));
  rover.on_bogie.assign(rover.plan.wheels.size(), false);
  if (rover.suspension.kind == SuspensionKind::kRockerBogie) {
    rover.on_bogie = ReadOnBogies(build, rover.plan);
  } else if (build.Child("suspension").keys.size() > 1) {
    const auto visit = [&](Keys& keys) { VisitSuspension(keys, rover.suspension); };
    YamlReader(build.Child("suspension"), "build.suspension", KeyNames(visit))
        .Refuse("kind", "no other key beside rigid");
  }
  rover.tyre.rim_radius_m = rover.plan.wheel_radius_m;
  rover.tyre.width_m = rover.plan.wheel_width_m;
}

}  // namespace

void VisitRover(Keys& keys, RoverModel& rover) {
  VisitPlan(keys, rover.plan);
  keys.Mapping("build", [&](Keys& in) { VisitBuild(in, rover); });
}

RoverPlan LoadRoverPlan(const std::string& file) {
  const YamlNode root = LoadYaml(file);
  RoverPlan plan;
  const auto visit = [&](Keys& keys) {
    YamlNode build;  // not read
    VisitPlan(keys, plan);
    keys.Tree(Unset("build"), build, YamlNode::Kind::kNull);
  };
  ReadKeys(root, "", visit);
  plan.body = ReadBody(YamlReader(root, "", KeyNames(visit)));
  return plan;
}

RoverModel LoadRover(const std::string& file) {
  RoverModel rover;
  ReadRover(
      LoadYaml(file), [&](Keys& keys) { VisitRover(keys, rover); }, rover);
  return rover;
}

void ReadRover(const YamlNode& root, const Keys::Visit& visit, RoverModel& rover) {
  ReadKeys(root, "", visit);
  FinishRover(YamlReader(root, "", KeyNames(visit)), rover);
}

}  // namespace dockyard
