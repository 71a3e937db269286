#include "sim/custom/docked_findings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "controller/base/number_text.h"
#include "models/custom/make_nominal.h"
#include "models/read/yaml_path.h"
#include "sim/custom/tree_in_world.h"
#include "sim/rigid/body_contact.h"
#include "sim/vehicles/spring_pins.h"

namespace dockyard::custom {
namespace {

using Eigen::Vector3d;

/// A solid that no joint carries away, in the root's frame.
struct SteadySolid {
  std::string name;
  ConvexBody body_R;
};

/// How deep two solids are in each other.
struct Overlap {
  double depth_m = 0.0;
  std::string of_robot, of_dock;
};

std::string NameOf(const LinkModel& link, const Collision& part) {
  return "'" + link.name + "'" + (part.name.empty() ? "" : " (" + part.name + ")");
}

void AddSolids(const LinkModel& link, const Pose3& X_RL, std::vector<SteadySolid>& solids) {
  for (const Collision& part : link.collisions) {
    solids.push_back({NameOf(link, part), X_RL * SolidOf(part)});
  }
}

/// Those of the root, and wheels on it, which turn in their places.
std::vector<SteadySolid> SteadySolids(const LinkTree& tree, const std::vector<WheelFit>& wheels) {
  std::vector<SteadySolid> solids;
  const std::vector<Pose3> X_RL = StartPoses(tree);
  AddSolids(tree.root, Pose3{}, solids);
  for (const WheelFit& wheel : wheels) {
    if (wheel.link == 0 || tree.joint(wheel.link).carrier != 0) continue;
    AddSolids(tree.link(wheel.link), X_RL[static_cast<std::size_t>(wheel.link)], solids);
  }
  return solids;
}

Overlap DeepestAt(const std::vector<SteadySolid>& robot, const std::vector<SteadySolid>& dock,
                  const Pose3& X_DR) {
  Overlap deepest;
  std::vector<BodyContact> found;
  for (const SteadySolid& a : robot) {
    const ConvexBody a_D = X_DR * a.body_R;
    for (const SteadySolid& b : dock) {
      const double near_m = a_D.radius_m + b.body_R.radius_m;
      if ((a_D.centre - b.body_R.centre).squaredNorm() > near_m * near_m) continue;
      found.clear();
      AddHullContacts(b.body_R, a_D, 0, found);
      for (const BodyContact& at : found) {
        if (at.depth_m > deepest.depth_m) deepest = {at.depth_m, a.name, b.name};
      }
    }
  }
  return deepest;
}

/// The docked pose of the drawings, and those of the judge's box about it.
class DockedPoses {
 public:
  DockedPoses(const CustomModels& models)
      : box_(models.keys.judge.docked.pose),
        X_RP_(FrameIn(models.nominal.robot.tree, box_.robot)),
        X_DQ_(FrameIn(models.nominal.dock.tree, box_.dock)),
        height_m_(MakeNominal(models.nominal.robot, models.nominal.dock).height_m) {}

  /// Of R in D, upright on its wheels, with P off Q by this much in the plane of the ground.
  Pose3 At(const Pose2& off) const {
    return FromGround(ToGround(X_DQ_ * FromGround(off, 0.0) * Inverse(X_RP_)), height_m_);
  }
  /// Places all over the box; empty: it has no end.
  std::vector<Pose2> Box() const {
    std::vector<Pose2> box;
    if (std::isnan(box_.x_m) || std::isnan(box_.y_m)) return box;
    for (const double x : {0.0, 0.5, -0.5, 1.0, -1.0}) {
      for (const double y : {0.0, 0.5, -0.5, 1.0, -1.0}) {
        for (const double turn : Turns()) box.push_back({x * box_.x_m, y * box_.y_m, turn});
      }
    }
    return box;
  }

 private:
  static Pose3 FrameIn(const LinkTree& tree, const std::string& name) {
    const NamedFrame& frame = *tree.Frame(name);
    return StartPoses(tree)[static_cast<std::size_t>(frame.link)] * frame.X_LF;
  }
  std::vector<double> Turns() const {
    if (!std::isnan(box_.yaw_rad)) return {0.0, box_.yaw_rad, -box_.yaw_rad};
    std::vector<double> all_round;
    for (int i = 0; i < 24; ++i) all_round.push_back(i * kPi / 12.0);
    return all_round;
  }

  const PoseBox& box_;
  Pose3 X_RP_, X_DQ_;
  double height_m_ = 0.0;
};

std::string PlaceOf(const Scenario& scenario, const char* path) {
  const YamlNode* node = FindPath(scenario.of_system, path);
  return (node == nullptr ? scenario.of_system : *node).place.Text() + ": " + path + ": ";
}

std::string Millimetres(double length_m) { return Fixed(1e3 * length_m, 1) + " mm"; }

std::string TextOf(const Overlap& overlap) {
  return overlap.of_robot + " of the robot " + Millimetres(overlap.depth_m) + " in " +
         overlap.of_dock + " of the dock";
}

Findings FindOverlap(const Scenario& scenario, const CustomModels& models,
                     const DockedPoses& poses) {
  Findings findings;
  const JudgeKeys& judge = models.keys.judge;
  const std::vector<SteadySolid> robot =
      SteadySolids(models.nominal.robot.tree, models.nominal.robot.wheels);
  const std::vector<SteadySolid> dock = SteadySolids(models.nominal.dock.tree, {});
  // The force that the judge allows presses solids into each other by this.
  const double allowed_n = std::isnan(judge.docked.most_n)
                               ? judge.collided_n
                               : std::min(judge.docked.most_n, judge.collided_n);
  const double yields_m = allowed_n / models.nominal.dock.contact.stiffness_n_per_m;
  const Overlap drawn = DeepestAt(robot, dock, poses.At({}));
  if (drawn.depth_m <= yields_m) return findings;
  const std::vector<Pose2> box = poses.Box();
  Overlap least = drawn;
  for (const Pose2& off : box) {
    const Overlap there = DeepestAt(robot, dock, poses.At(off));
    if (there.depth_m < least.depth_m) least = there;
    if (least.depth_m <= yields_m) break;
  }
  const bool never = !box.empty() && least.depth_m > yields_m;
  const std::string text =
      PlaceOf(scenario, "judge.docked.pose") + "expected robot and dock apart where '" +
      judge.docked.pose.robot + "' lies on '" + judge.docked.pose.dock + "', found " +
      TextOf(drawn) + ", and contacts yield by " + Millimetres(yields_m) +
      (never ? "; nowhere in the judge's box is it less than " + Millimetres(least.depth_m)
             : "; the robot docks elsewhere in the judge's box, if at all") +
      ": move one of the two links" + kWhatIsChecked;
  (never ? findings.faults : findings.doubts).push_back(text);
  return findings;
}

/// Pins, pads and solids of one side.
struct Side {
  const ElectricalParts& electrical;
  std::vector<SteadySolid> solids;
  Pose3 X_DS;  // of its root
};

/// How a pin is at the docked pose; empty: it is pressed onto its pad.
std::string FaultOfPin(const SpringPin& pin, const Side& from, const Side& on) {
  constexpr double kAhead_m = 0.1;  // assumed, 0.05-0.5: farther things are no part of it
  const Pose3 X_OF = Inverse(on.X_DS) * from.X_DS;
  const Vector3d tip_O = X_OF * pin.p_L, out_O = X_OF.R * pin.out_L;
  const double back_m = 2.0 * pin.stroke_m, length_m = back_m + kAhead_m;
  std::optional<double> hit_m;  // from the tip on
  for (const SteadySolid& solid : on.solids) {
    const auto in = PressEdge(solid.body_R, tip_O - back_m * out_O, tip_O + kAhead_m * out_O);
    if (!in || in->to <= in->from) continue;
    const double at_m = in->from * length_m - back_m;
    hit_m = std::min(hit_m.value_or(at_m), at_m);
  }
  if (!hit_m) return "nothing before it";
  if (*hit_m >= 0.0) return "it " + Millimetres(*hit_m) + " before what it is to press on";
  if (-*hit_m > pin.stroke_m) {
    return "it pressed in by more than its stroke of " + Millimetres(pin.stroke_m);
  }
  if (!MeetsPad(pin, on.electrical.pads, 0, tip_O + *hit_m * out_O)) return "it off its pad";
  return "";
}

/// Of the poles of the contact that is to close; those of links that move are left out.
Findings FindOpenPoles(const Scenario& scenario, const CustomModels& models,
                       const DockedPoses& poses) {
  Findings findings;
  const ContactAsked& asked = models.keys.judge.docked.contact;
  if (asked.pins.empty() || !asked.closed) return findings;
  const ModelSet& set = models.nominal;
  const Side robot{set.robot.electrical, SteadySolids(set.robot.tree, {}), poses.At({})};
  const Side dock{set.dock.electrical, SteadySolids(set.dock.tree, {}), Pose3{}};
  struct Pole {
    std::string name, fault;
  };
  std::vector<Pole> poles;
  for (const auto& [from, on] : {std::pair(&robot, &dock), std::pair(&dock, &robot)}) {
    for (const SpringPin& pin : from->electrical.pins) {
      if (pin.contact != asked.pins) continue;
      const std::string fault = pin.link == 0 ? FaultOfPin(pin, *from, *on) : "";
      const auto known = std::find_if(poles.begin(), poles.end(),
                                      [&](const Pole& pole) { return pole.name == pin.pole; });
      if (known == poles.end()) {
        poles.push_back({pin.pole, fault});
      } else if (fault.empty()) {
        known->fault = "";
      }
    }
  }
  for (const Pole& pole : poles) {
    if (pole.fault.empty()) continue;
    findings.doubts.push_back(PlaceOf(scenario, "judge.docked.contact.pins") +
                              "expected the pin '" + pole.name + "' of '" + asked.pins +
                              "' pressed onto its pad at the docked pose, found " + pole.fault +
                              kWhatIsChecked);
  }
  return findings;
}

/// As a scenario's start, 1 m from the border.
Findings FindStagingOutside(const Scenario& scenario, const CustomModels& models,
                            const DockedPoses& poses) {
  constexpr double kMargin_m = 1.0;
  Findings findings;
  if (scenario.controller != "graceful" || !scenario.command.empty()) return findings;
  const Pose3 docked = poses.At({});
  const double x_m = docked.p.x() + models.keys.docking.staging_m;
  const double y_m = std::round(1e3 * docked.p.y()) / 1e3 + 0.0;  // no -0 for the text
  const double x_end_m = scenario.yard.length_m - kYardBehind_m - kMargin_m;
  const double y_end_m = 0.5 * scenario.yard.width_m - kMargin_m;
  if (x_m <= x_end_m && std::abs(y_m) <= y_end_m) return findings;
  findings.faults.push_back(PlaceOf(scenario, "graceful.staging_m") +
                            "expected a staging pose inside the yard (x up to " +
                            Fixed(x_end_m, 2) + " m, y up to +-" + Fixed(y_end_m, 2) +
                            " m), found it at x = " + Fixed(x_m, 2) + " m, y = " + Fixed(y_m, 2) +
                            " m: lower staging_m or enlarge the yard" + kWhatIsChecked);
  return findings;
}

}  // namespace

Findings FindInDocking(const Scenario& scenario, const CustomModels& models) {
  const PoseBox& pose = models.keys.judge.docked.pose;
  // Where a joint carries one of the frames, the docked pose is not known.
  if (models.nominal.robot.tree.Frame(pose.robot)->link != 0 ||
      models.nominal.dock.tree.Frame(pose.dock)->link != 0) {
    return {};
  }
  const DockedPoses poses(models);
  Findings findings = FindOverlap(scenario, models, poses);
  Append(FindOpenPoles(scenario, models, poses), findings);
  Append(FindStagingOutside(scenario, models, poses), findings);
  return findings;
}

Findings FindInScenario(const Scenario& scenario, const CustomModels& models) {
  Findings findings = FindInRobot(models.nominal.robot, scenario.robot_file);
  Append(FindInDock(models.nominal.dock, models.keys.dock_file), findings);
  Append(FindInDocking(scenario, models), findings);
  return findings;
}

}  // namespace dockyard::custom
