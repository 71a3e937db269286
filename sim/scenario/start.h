// Where a robot is at the start of a run: numbers by name, declared by its system.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "controller/geometry/robot_pose.h"
#include "sim/scenario/keys.h"

namespace dockyard {

/// A key under `start` of a scenario, with its value.
struct StartNumber {
  std::string name;     // with its unit: "r_m"
  std::string unit;     // "deg": an angle, whose value here is in radians
  Range range;          // in the file's unit
  std::string meaning;  // one line
  double value = 0.0;   // SI
};

class Start {
 public:
  /// On the plane, in docking coordinates: r_m, alpha_deg and heading_deg.
  Start(const DockingCoords& at = {.r = 4.0});
  Start(double r_m, double alpha_rad, double heading_rad)
      : Start(DockingCoords{r_m, alpha_rad, heading_rad}) {}
  /// A system's own numbers, and where they put the robot in its target's frame.
  using PoseOf = std::function<RobotPose(const Start&)>;
  Start(std::vector<StartNumber> numbers, PoseOf pose)
      : numbers_(std::move(numbers)), pose_(std::move(pose)) {}

  const std::vector<StartNumber>& numbers() const { return numbers_; }
  bool HasNames(const Start& other) const;
  /// SI: radians of an angle. There must be such a number.
  double Value(std::string_view name) const;
  /// Sets a number as a file would have it; false: there is none of that name.
  bool SetInFile(std::string_view name, double value);
  /// Names each of them as a required key.
  void Visit(Keys& keys);

  RobotPose pose() const { return pose_ ? pose_(*this) : RobotPose(FromDockingCoords(on_plane())); }
  bool IsOnPlane() const { return !pose_; }
  /// The numbers must be those of the plane.
  DockingCoords on_plane() const;

 private:
  std::vector<StartNumber> numbers_;
  PoseOf pose_{};  // empty: on the plane
};

}  // namespace dockyard
