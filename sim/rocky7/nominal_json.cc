#include "sim/rocky7/nominal_json.h"

#include "models/read/config_error.h"
#include "sim/plant/nominal_parts.h"

namespace dockyard::rocky7 {
namespace {

using dockyard::ToJson;

Eigen::Vector2d Vector2From(const Json& json) {
  const auto p = json.get<std::array<double, 2>>();
  return {p[0], p[1]};
}

Json PolygonToJson(const Polygon& polygon) {
  Json corners = Json::array();
  for (const Eigen::Vector2d& corner : polygon) corners.push_back(ToJson(corner));
  return corners;
}

Json PlanToJson(const RoverPlan& plan) {
  Json wheels = Json::array(), body = Json::array();
  for (const WheelPlan& wheel : plan.wheels) {
    wheels.push_back({{"name", wheel.name},
                      {"p_RW", ToJson(wheel.p_RW)},
                      {"steer_limit_rad", wheel.steer_limit_rad}});
  }
  for (const Polygon& part : plan.body) body.push_back(PolygonToJson(part));
  Json json{{"name", plan.name},
            {"wheels", wheels},
            {"wheel_radius_m", plan.wheel_radius_m},
            {"wheel_width_m", plan.wheel_width_m},
            {"body", body},
            {"p_RP", ToJson(plan.p_RP)},
            {"speed_m_s", plan.speed_m_s},
            {"steer_rate_rad_s", plan.steer_rate_rad_s}};
  if (plan.view) {
    json["view"] = {{"p_RC", ToJson(plan.view->p_RC)},
                    {"azimuth_rad", plan.view->azimuth_rad},
                    {"half_width_rad", plan.view->half_width_rad},
                    {"near_m", plan.view->near_m},
                    {"far_m", plan.view->far_m}};
  }
  return json;
}

RoverPlan PlanFromJson(const Json& json) {
  RoverPlan plan;
  plan.name = json.at("name");
  for (const Json& wheel : json.at("wheels")) {
    plan.wheels.push_back(
        {wheel.at("name"), Vector2From(wheel.at("p_RW")), wheel.at("steer_limit_rad")});
  }
  plan.wheel_radius_m = json.at("wheel_radius_m");
  plan.wheel_width_m = json.at("wheel_width_m");
  for (const Json& part : json.at("body")) {
    plan.body.emplace_back();
    for (const Json& corner : part) plan.body.back().push_back(Vector2From(corner));
  }
  plan.p_RP = Vector2From(json.at("p_RP"));
  plan.speed_m_s = json.at("speed_m_s");
  plan.steer_rate_rad_s = json.at("steer_rate_rad_s");
  if (json.contains("view")) {
    const Json& view = json.at("view");
    plan.view = ViewPlan{Vector2From(view.at("p_RC")), view.at("azimuth_rad"),
                         view.at("half_width_rad"), view.at("near_m"), view.at("far_m")};
  }
  return plan;
}

Json ArmToJson(const NominalArm& arm) {
  return {{"p_RA", {arm.p_RA.x(), arm.p_RA.y(), arm.p_RA.z()}},
          {"length_m", arm.length_m},
          {"scoop_depth_m", arm.scoop_depth_m},
          {"open_rad", arm.open_rad}};
}

NominalArm ArmFromJson(const Json& json) {
  const auto p = json.at("p_RA").get<std::array<double, 3>>();
  return {{p[0], p[1], p[2]}, json.at("length_m"), json.at("scoop_depth_m"), json.at("open_rad")};
}

Json RigToJson(const StereoRig& rig) {
  return {{"left", CameraToJson(rig.left)},
          {"right", CameraToJson(rig.right)},
          {"X_RL", ToJson(rig.X_RL)},
          {"X_RQ", ToJson(rig.X_RQ)}};
}

StereoRig RigFromJson(const Json& json) {
  return {CameraFromJson(json.at("left")), CameraFromJson(json.at("right")),
          Pose3FromJson(json.at("X_RL")), Pose3FromJson(json.at("X_RQ"))};
}

Json MastToJson(const NominalMast& mast) {
  return {{"p_RM", {mast.p_RM.x(), mast.p_RM.y(), mast.p_RM.z()}},
          {"link1_m", mast.link1_m},
          {"link2_m", mast.link2_m},
          {"low_rad", mast.low_rad},
          {"high_rad", mast.high_rad},
          {"stowed_rad", mast.stowed_rad},
          {"watch_rad", mast.watch_rad},
          {"switch_radius_m", mast.switch_radius_m},
          {"pair_K", RigToJson(mast.pair_K)}};
}

NominalMast MastFromJson(const Json& json) {
  const auto p = json.at("p_RM").get<std::array<double, 3>>();
  const auto angles = [&](const char* key) { return json.at(key).get<std::array<double, 3>>(); };
  return {.p_RM = {p[0], p[1], p[2]},
          .link1_m = json.at("link1_m"),
          .link2_m = json.at("link2_m"),
          .low_rad = angles("low_rad"),
          .high_rad = angles("high_rad"),
          .stowed_rad = angles("stowed_rad"),
          .watch_rad = angles("watch_rad"),
          .switch_radius_m = json.at("switch_radius_m"),
          .pair_K = RigFromJson(json.at("pair_K"))};
}

constexpr const char* kTasks[] = {"reach", "grasp", "place"};  // in the order of Task

Task TaskFrom(const std::string& name) {
  return name == "grasp" ? Task::kGrasp : name == "place" ? Task::kPlace : Task::kReach;
}

Nominal ReadNominal(const Json& json) {
  Nominal nominal;
  nominal.plan = PlanFromJson(json.at("plan"));
  for (const Json& motor : json.at("motors")) nominal.motors.push_back(MotorFromJson(motor));
  nominal.rolling_radius_m = json.at("rolling_radius_m");
  nominal.front = RigFromJson(json.at("front"));
  nominal.back = RigFromJson(json.at("back"));
  nominal.arm = ArmFromJson(json.at("arm"));
  nominal.mast = MastFromJson(json.at("mast"));
  nominal.task = TaskFrom(json.at("task"));
  nominal.reach_m = json.at("reach_m");
  nominal.target_px = Vector2From(json.at("target_px"));
  const Json& nesnas = json.at("nesnas");
  nominal.nesnas = {nesnas.at("window_m"), nesnas.at("image_share"), nesnas.at("least_step_m")};
  return nominal;
}
static_assert(sizeof(NesnasTracking) == 3 * sizeof(double));

}  // namespace

Json ToJson(const Nominal& nominal) {
  Json motors = Json::array();
  for (const NominalMotor& motor : nominal.motors) motors.push_back(MotorToJson(motor));
  return {{"plan", PlanToJson(nominal.plan)},
          {"motors", motors},
          {"rolling_radius_m", nominal.rolling_radius_m},
          {"front", RigToJson(nominal.front)},
          {"back", RigToJson(nominal.back)},
          {"arm", ArmToJson(nominal.arm)},
          {"mast", MastToJson(nominal.mast)},
          {"task", kTasks[static_cast<int>(nominal.task)]},
          {"reach_m", nominal.reach_m},
          {"target_px", ToJson(nominal.target_px)},
          {"nesnas",
           {{"window_m", nominal.nesnas.window_m},
            {"image_share", nominal.nesnas.image_share},
            {"least_step_m", nominal.nesnas.least_step_m}}}};
}

Nominal NominalFromJson(const Json& json) {
  try {
    return ReadNominal(json);
  } catch (const Json::exception& error) {
    throw ConfigError(std::string("nominal parameters: expected Rocky 7's, found others: ") +
                      error.what());
  }
}

}  // namespace dockyard::rocky7
