#include "sim/custom/world_contacts.h"

#include <algorithm>

namespace dockyard::custom {
namespace {

constexpr int kRobot = 1, kDock = 2;  // bits of groups

std::vector<int> WheelLinks(const RobotModel& robot) {
  std::vector<int> links;
  for (const WheelFit& wheel : robot.wheels) links.push_back(wheel.link);
  return links;
}

bool IsWheel(const RobotModel& robot, int link) {
  return std::any_of(robot.wheels.begin(), robot.wheels.end(),
                     [&](const WheelFit& wheel) { return wheel.link == link; });
}

// Without the solids of wheels, which the ground bears by their tyres.
void AddToFloor(const LinkTree& model, const std::vector<int>& without, const TreeInWorld& tree,
                double grip, FloorContacts& floor) {
  for (LinkSolid& solid : SolidsOf(model, without)) {
    FloorPart part;
    part.at = tree.At(solid.link);
    part.body_L = std::move(solid.body_L);
    part.grip = grip;
    floor.Add(std::move(part));
  }
}

// Wheels first: they meet parts that are added later.
void AddParts(const WorldSetup& setup, const TreeInWorld& robot, const TreeInWorld& dock,
              PartContacts& parts) {
  const ContactMaterial& material = setup.dock.contact;
  for (const WheelFit& wheel : setup.robot.wheels) {
    if (wheel.tyre.ball || wheel.axle_L.cwiseAbs() != Eigen::Vector3d::UnitY()) continue;
    SolidPart part{.at = robot.At(wheel.link),
                   .body_L = WheelHull(wheel.on_soil),
                   .wheel = wheel.on_soil,
                   .material = material,
                   .groups = {kRobot, kDock}};
    parts.Add(part);
  }
  const auto add = [&](const LinkTree& model, const TreeInWorld& tree, const PartGroups& groups,
                       bool of_robot) {
    for (int i = 0; i < model.link_count(); ++i) {
      const bool round = of_robot && IsWheel(setup.robot, i);
      for (const Collision& shape : model.link(i).collisions) {
        const bool taken = round && std::holds_alternative<CylinderShape>(shape.shape);
        if (taken) continue;
        parts.Add({.at = tree.At(i),
                   .body_L = SolidOf(shape),
                   .is_bar = true,
                   .material = material,
                   .groups = groups});
      }
    }
  };
  add(setup.robot.tree, robot, {kRobot, kDock}, true);
  add(setup.dock.tree, dock, {kDock, kRobot}, false);
}

std::vector<LinkParts> OwnParts(const LinkTree& model, const RobotModel* robot) {
  std::vector<LinkParts> parts;
  for (int i = 0; i < model.link_count(); ++i) {
    LinkParts& part = parts.emplace_back();
    part.collisions = model.link(i).collisions;
    if (robot == nullptr) continue;
    // A wheel turns in its fork, whose shape often reaches into the wheel's.
    if (IsWheel(*robot, i)) part.collisions.clear();
  }
  return parts;
}

}  // namespace

WorldContacts::WorldContacts(const WorldSetup& setup, RigidWorld& in, const TreeInWorld& robot,
                             const TreeInWorld& dock)
    : world(in),
      parts(in),
      robot_floor(in, setup.ground),
      dock_floor(in, setup.ground),
      dock_body(dock.body) {
  AddParts(setup, robot, dock, parts);
  AddToFloor(setup.robot.tree, WheelLinks(setup.robot), robot, setup.robot.floor_grip, robot_floor);
  if (!setup.dock.fixed) AddToFloor(setup.dock.tree, {}, dock, setup.dock.floor_grip, dock_floor);
  if (!setup.robot.tree.joints.empty()) {
    robot_own.emplace(in, robot.body, setup.robot.tree.joints, robot.places,
                      OwnParts(setup.robot.tree, &setup.robot));
  }
  if (!setup.dock.tree.joints.empty()) {
    dock_own.emplace(in, dock.body, setup.dock.tree.joints, dock.places,
                     OwnParts(setup.dock.tree, nullptr));
  }
  const auto side = [](const TreeInWorld& tree, const LinkTree& model,
                       const ElectricalParts& electrical) {
    return PinSide{.body = tree.body,
                   .places = tree.places,
                   .pins = electrical.pins,
                   .pads = electrical.pads,
                   .solids = SolidsOf(model)};
  };
  pins = SpringPins(side(robot, setup.robot.tree, setup.robot.electrical),
                    side(dock, setup.dock.tree, setup.dock.electrical));
}

void WorldContacts::AddAll(double step_s) {
  robot_floor.AddContacts(step_s);
  parts.AddContacts();
  pins.AddContacts(world);
  if (!world.asleep(dock_body)) dock_floor.AddContacts(step_s);
  if (robot_own) robot_own->AddContacts();
  if (dock_own) dock_own->AddContacts();
}

double WorldContacts::TakeForces(double step_s) {
  pins.TakeForces(world, step_s);
  double sum_n = 0.0;
  for (const SpringPins::State& pin : pins.states()) sum_n += pin.force_n;
  for (const PartContacts::Met& met : parts.met()) {
    const WorldContact& contact = world.contacts()[static_cast<std::size_t>(met.contact)];
    sum_n += contact.normal_G.dot(contact.impulse_G) / step_s;
  }
  return sum_n;
}

}  // namespace dockyard::custom
