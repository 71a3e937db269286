#include "sim/rocky7/rover_shapes.h"

#include "models/parts/scoop_shape.h"
#include "models/read/mesh_loader.h"
#include "sim/vehicles/rover_parts.h"

namespace dockyard::rocky7 {
namespace {

using Eigen::Vector3d;

// Linear albedos. Assumed: dark solar panel 0.03-0.1, anodised bars 0.3-0.6, wheels 0.2-0.5.
const Vector3d kPanel(0.04, 0.04, 0.08), kBody(0.5, 0.45, 0.35), kBars(0.45, 0.45, 0.45),
    kWheels(0.3, 0.3, 0.3), kPaddles(0.2, 0.2, 0.2);
// Of bars; assumed, 10-40 mm.
constexpr double kBar_m = 0.02;
// Height of the panel over the body's middle, so that the cameras look out below its edge: the
// body's box and half the panel.
double PanelHeight(const LinkModel& body) {
  const auto* box = std::get_if<BoxShape>(&body.collisions.front().shape);
  return body.p_LoCom_L.z() + 0.5 * (box->size_m.z() + kPanel_m);
}

Visual Part(const char* name, TriangleMesh mesh, const Pose3& X_LV, const Vector3d& rgb) {
  return {name, std::make_shared<const TriangleMesh>(std::move(mesh)), X_LV, rgb};
}

// A bar from one point to another.
Visual Bar(const Vector3d& from, const Vector3d& to) {
  const Vector3d along = to - from;
  Pose3 X_LV;
  X_LV.R = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitX(), along).toRotationMatrix();
  X_LV.p = 0.5 * (from + to);
  return Part("bar", BoxMesh({along.norm(), kBar_m, kBar_m}), X_LV, kBars);
}

std::vector<Visual> BodyLook(const RoverModel& rover) {
  const auto* box = std::get_if<BoxShape>(&rover.body.collisions.front().shape);
  std::vector<Visual> parts{Part("box", BoxMesh(box->size_m),
                                 {Eigen::Matrix3d::Identity(), rover.body.p_LoCom_L}, kBody)};
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const Polygon& polygon : rover.plan.body) {
    for (const Eigen::Vector2d& corner : polygon) {
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  const Vector3d size(high.x() - low.x(), high.y() - low.y(), kPanel_m);
  const Vector3d middle(0.5 * (low.x() + high.x()), 0.5 * (low.y() + high.y()),
                        PanelHeight(rover.body));
  parts.push_back(Part("panel", BoxMesh(size), {Eigen::Matrix3d::Identity(), middle}, kPanel));
  return parts;
}

std::vector<Visual> WheelLook(const RoverModel& rover) {
  const WheelModel& tyre = rover.tyre;
  Pose3 X_LV;
  X_LV.R = RotX(kPi / 2);
  std::vector<Visual> parts{
      Part("rim", CylinderMesh(tyre.rim_radius_m, tyre.width_m), X_LV, kWheels)};
  TriangleMesh paddles;
  const TriangleMesh paddle =
      BoxMesh({tyre.paddle_height_m, tyre.width_m, tyre.paddle_thickness_m});
  for (int i = 0; i < tyre.paddle_count; ++i) {
    const Eigen::Matrix3d R = RotY(2.0 * kPi * i / tyre.paddle_count);
    const Vector3d out(tyre.rim_radius_m + 0.5 * tyre.paddle_height_m, 0.0, 0.0);
    const auto first = static_cast<std::uint32_t>(paddles.vertices.size());
    for (const Vector3d& vertex : paddle.vertices) paddles.vertices.push_back(R * (out + vertex));
    for (const auto& t : paddle.triangles) {
      paddles.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  if (tyre.paddle_count > 0) parts.push_back(Part("paddles", std::move(paddles), {}, kPaddles));
  return parts;
}

// The instrument as a can.
Visual Can(const MastModel& mast) {
  Pose3 X_LV;
  X_LV.R = RotZ(kPi / 2);  // a cylinder's axis is y
  X_LV.p = {mast.link2_m - 0.5 * mast.instrument.length_m, 0.0, 0.0};
  return Part("can", CylinderMesh(mast.instrument.radius_m, mast.instrument.length_m), X_LV,
              kWheels);
}

}  // namespace

std::vector<LinkLook> LooksOf(const RoverModel& rover, const WheeledBody& body) {
  const TreeBody& tree = body.tree();
  std::vector<LinkLook> looks(static_cast<std::size_t>(tree.link_count()));
  looks[0] = {"robot", BodyLook(rover)};
  std::vector<bool> is_wheel(looks.size(), false);
  for (std::size_t i = 0; i < rover.plan.wheels.size(); ++i) {
    const auto link = static_cast<std::size_t>(body.wheel_link(static_cast<int>(i)));
    looks[link] = {rover.plan.wheels[i].name, WheelLook(rover)};
    is_wheel[link] = true;
  }
  if (body.has_arm()) {
    const auto look = [&](int motor) -> LinkLook& {
      return looks[static_cast<std::size_t>(body.arm().link(motor))];
    };
    look(kArmRoll).name = "shoulder";
    look(kArmPitch) = {"arm", {Part("bar", ArmBar(*rover.arm), {}, kBars)}};
    for (const bool front : {true, false}) {
      LinkLook& scoop = look(front ? kFrontScoop : kBackScoop);
      scoop.name = front ? "front_scoop" : "back_scoop";
      for (TriangleMesh& plate : ScoopPlates(rover.arm->scoop, front)) {
        scoop.visuals.push_back(Part("plate", std::move(plate), {}, kBars));
      }
    }
  }
  if (rover.mast) {
    const MastModel& mast = *rover.mast;
    const auto look = [&](int link) -> LinkLook& {
      return looks[static_cast<std::size_t>(body.mast_link(link))];
    };
    look(kMastRoll).name = "mast";
    look(kMastShoulder) = {"mast_link_1", {Bar(Vector3d::Zero(), {mast.link1_m, 0.0, 0.0})}};
    const double bar_m = mast.link2_m - mast.instrument.length_m;
    look(kMastElbow) = {"mast_link_2", {Bar(Vector3d::Zero(), {bar_m, 0.0, 0.0})}};
    look(kMastCan) = {"instrument", {Can(mast)}};
  }
  // A link that carries others has a bar to each of their hinges.
  for (std::size_t i = 1; i < looks.size(); ++i) {
    if (!looks[i].name.empty() && !is_wheel[i]) continue;
    if (!is_wheel[i]) looks[i].name = "link_" + std::to_string(i);
    const TreeLink& link = tree.link(static_cast<int>(i));
    if (link.parent > 0 && link.p_PL.norm() > kBar_m) {
      looks[static_cast<std::size_t>(link.parent)].visuals.push_back(
          Bar(Vector3d::Zero(), link.p_PL));
    }
  }
  return looks;
}

}  // namespace dockyard::rocky7
