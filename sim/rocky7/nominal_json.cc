#include "sim/rocky7/nominal_json.h"

#include "models/read/config_error.h"
#include "sim/run/nominal_parts.h"

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

Nominal ReadNominal(const Json& json) {
  Nominal nominal;
  nominal.plan = PlanFromJson(json.at("plan"));
  for (const Json& motor : json.at("motors")) nominal.motors.push_back(MotorFromJson(motor));
  nominal.rolling_radius_m = json.at("rolling_radius_m");
  const Json& front = json.at("front");
  nominal.front = {CameraFromJson(front.at("left")), CameraFromJson(front.at("right")),
                   Pose3FromJson(front.at("X_RL")), Pose3FromJson(front.at("X_RQ"))};
  nominal.arm = ArmFromJson(json.at("arm"));
  nominal.task = json.at("task") == "grasp" ? Task::kGrasp : Task::kReach;
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
  const StereoRig& front = nominal.front;
  return {{"plan", PlanToJson(nominal.plan)},
          {"motors", motors},
          {"rolling_radius_m", nominal.rolling_radius_m},
          {"front",
           {{"left", CameraToJson(front.left)},
            {"right", CameraToJson(front.right)},
            {"X_RL", ToJson(front.X_RL)},
            {"X_RQ", ToJson(front.X_RQ)}}},
          {"arm", ArmToJson(nominal.arm)},
          {"task", nominal.task == Task::kGrasp ? "grasp" : "reach"},
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
