#include "sim/paths/path_json.h"

namespace dockyard {
namespace {

Json ArcJson(const Arc& arc) { return {{"length_m", arc.length_m}, {"turn_rad", arc.turn_rad}}; }

Json WheelsJson(const RoverPlan& rover, const Arc& arc) {
  Json wheels = Json::object();
  for (const WheelPlan& wheel : rover.wheels) {
    const WheelOnArc on = OnArc(wheel, arc);
    wheels[wheel.name] = {
        {"steer_rad", on.steer_rad}, {"way_m", on.way_m}, {"side_slip_rad", on.side_slip_rad}};
  }
  return wheels;
}

}  // namespace

Json PathJson(const PathTask& task, const PlannedPath& plan,
              const std::vector<std::string>& warnings) {
  Json arcs = Json::array(), candidates = Json::array();
  for (const Arc& arc : plan.best ? plan.best->arcs : std::vector<Arc>{}) {
    Json json = ArcJson(arc);
    if (!task.rover.wheels.empty()) json["wheels"] = WheelsJson(task.rover, arc);
    arcs.push_back(json);
  }
  for (const Candidate& candidate : plan.candidates) {
    Json its = Json::array();
    for (const Arc& arc : candidate.arcs) its.push_back(ArcJson(arc));
    candidates.push_back({{"arcs", its},
                          {"cost_m", candidate.cost_m},
                          {"keeps_limits", candidate.keeps},
                          {"missing_m", candidate.missing_m}});
  }
  return {{"feasible", plan.best.has_value()},
          {"arcs", arcs},
          {"cost_m", plan.best ? Json(plan.best->cost_m) : Json()},
          {"candidates", candidates},
          {"warnings", warnings}};
}

}  // namespace dockyard
