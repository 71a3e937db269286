#include "sim/spectator/aim_point.h"

#include <algorithm>

namespace dockyard {
namespace {

const StageBody* RobotOf(const StageShapes& shapes) {
  const auto at = std::find_if(shapes.bodies.begin(), shapes.bodies.end(),
                               [](const StageBody& body) { return body.robot; });
  return at == shapes.bodies.end() ? nullptr : &*at;
}

const StagePoint* PointOf(const std::string& name, const StageShapes& shapes) {
  const auto at = std::find_if(shapes.points.begin(), shapes.points.end(),
                               [&](const StagePoint& point) { return point.name == name; });
  return at == shapes.points.end() ? nullptr : &*at;
}

Eigen::Vector3d PlaceOn(const std::string& body, const Eigen::Vector3d& p_O, const LoggedRun& run,
                        std::size_t sample) {
  const auto at = std::find(run.body_names.begin(), run.body_names.end(), body);
  if (at == run.body_names.end()) throw DataError("the log has no body " + body);
  return run.X_WO[static_cast<std::size_t>(at - run.body_names.begin())][sample] * p_O;
}

}  // namespace

std::vector<std::string> AimNames(const StageShapes& shapes) {
  std::vector<std::string> names{"target"};
  const auto add = [&](const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  if (RobotOf(shapes) != nullptr) add("robot");
  for (const StagePoint& point : shapes.points) add(point.name);
  for (const StageBody& body : shapes.bodies) {
    if (!body.about) add(body.name);
  }
  return names;
}

Eigen::Vector3d AimPlace(const Aim& aim, const LoggedRun& run, const StageShapes& shapes,
                         std::size_t sample) {
  if (aim.p_D) return FromGround(ToGround(run.X_WD[sample]), run.X_WD[sample].p.z()) * *aim.p_D;
  if (const StagePoint* point = PointOf(aim.name, shapes)) {
    return PlaceOn(point->body, point->p_O, run, sample);
  }
  const StageBody* robot = RobotOf(shapes);
  if (aim.name == "robot" && robot != nullptr) {
    return PlaceOn(robot->name, Eigen::Vector3d::Zero(), run, sample);
  }
  const bool body =
      std::any_of(shapes.bodies.begin(), shapes.bodies.end(),
                  [&](const StageBody& each) { return each.name == aim.name && !each.about; });
  if (!body && aim.name == "target") return run.X_WD[sample].p;
  return PlaceOn(aim.name, Eigen::Vector3d::Zero(), run, sample);
}

}  // namespace dockyard
