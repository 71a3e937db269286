#include "models/axel/urdf_agreement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "models/parts/stretch.h"
#include "models/read/config_error.h"

namespace dockyard::axel {
namespace {

constexpr double kSame_m = 1e-3;

/// The wheel's shapes as large as the soil meets the wheel.
void FitWheel(const YamlReader& root, const WheelModel& drawn, const WheelModel& wanted,
              LinkModel& link) {
  const double across = RollingRadius(wanted) / RollingRadius(drawn);
  const double along = wanted.width_m / drawn.width_m;
  if (across == 1.0 && along == 1.0) return;
  if (StretchShapes(link, {across, along, across})) return;
  root.Refuse("wheels",
              "the radius and width that the URDF was drawn for: among the collisions of '" +
                  link.name + "' is one that cannot grow in radius by " + NumberText(across) +
                  " and in width by " + NumberText(along),
              NumberText(RollingRadius(wanted)));
}

void ShiftAlongX(double shift_m, LinkModel& link) {
  link.p_LoCom_L.x() += shift_m;
  for (Visual& visual : link.visuals) visual.X_LV.p.x() += shift_m;
  for (Collision& part : link.collisions) part.X_LG.p.x() += shift_m;
}

/// Moves the vertices of a visual on the link's left (y > 0) by one vector, those on its right by
/// another. `lowest_z`: those below keep their height.
void ShiftHalves(const Eigen::Vector3d& left_m, const Eigen::Vector3d& right_m, double lowest_z,
                 Visual& visual) {
  auto mesh = std::make_shared<TriangleMesh>(*visual.mesh);
  for (Eigen::Vector3d& v : mesh->vertices) {
    const Eigen::Vector3d p_L = visual.X_LV * v;
    v = p_L + (p_L.y() > 0.0 ? left_m : right_m);
    if (p_L.z() < lowest_z) v.z() = p_L.z();
  }
  visual.mesh = std::move(mesh);
  visual.X_LV = Pose3{};
}

/// Halfway between the lowest and the highest vertex of a visual, in its link.
double MiddleHeight(const Visual& visual) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Eigen::Vector3d& v : visual.mesh->vertices) {
    const double z = (visual.X_LV * v).z();
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return 0.5 * (low + high);
}

}  // namespace

void RequireAgreement(const YamlReader& root, const RoverModel& rover) {
  for (const Collision& part : rover.arm.collisions) {
    const auto* tip = std::get_if<CylinderShape>(&part.shape);
    if (part.name != "tip" || tip == nullptr) continue;
    const double front = part.X_LG.p.x() + 0.5 * tip->length_m;
    if (std::abs(tip->radius_m - rover.tip.radius_m) > kSame_m ||
        std::abs(front - rover.arm_length_m) > kSame_m) {
      root.Refuse("arm", "the radius and front of collision 'tip' of the URDF, " +
                             NumberText(tip->radius_m) + " and " + NumberText(front));
    }
  }
  const double tip_radius =
      rover.left_wheel_soil.rim_radius_m +
      (rover.left_wheel_soil.paddle_count > 0 ? rover.left_wheel_soil.paddle_height_m : 0.0);
  for (const LinkModel* wheel : {&rover.left_wheel, &rover.right_wheel}) {
    double largest = 0.0;  // smaller ones are hubs and caps
    for (const Collision& part : wheel->collisions) {
      const auto* disc = std::get_if<CylinderShape>(&part.shape);
      if (disc != nullptr) largest = std::max(largest, disc->radius_m);
    }
    if (largest == 0.0 || std::abs(largest - tip_radius) <= kSame_m) continue;
    root.Refuse("wheels",
                "rim and paddle to add up to the radius of the wheel's collision "
                "cylinder in the URDF, " +
                    NumberText(largest),
                NumberText(std::round(1e6 * tip_radius) / 1e6));
  }
}

void FitLinks(const YamlReader& root, const RoverModel& drawn, RoverModel& rover) {
  FitWheel(root, drawn.left_wheel_soil, rover.left_wheel_soil, rover.left_wheel);
  FitWheel(root, drawn.right_wheel_soil, rover.right_wheel_soil, rover.right_wheel);
  const double longer_m = rover.arm_length_m - drawn.arm_length_m;
  if (longer_m != 0.0) ShiftAlongX(longer_m, rover.arm);
}

void FitCameraHeads(const StereoFile& drawn, const StereoFile& cameras, LinkModel& body) {
  if (!drawn.rig.empty() || !cameras.rig.empty()) return;
  const Eigen::Vector3d left_m(cameras.forward_m - drawn.forward_m,
                               0.5 * (cameras.baseline_m - drawn.baseline_m),
                               cameras.height_m - drawn.height_m);
  const Eigen::Vector3d right_m(left_m.x(), -left_m.y(), left_m.z());
  if (left_m.isZero(0.0)) return;
  for (Visual& visual : body.visuals) {
    constexpr double kAll = -std::numeric_limits<double>::infinity();
    if (visual.name == "camera_heads") ShiftHalves(left_m, right_m, kAll, visual);
    if (visual.name == "camera_posts") {
      ShiftHalves(left_m, right_m, MiddleHeight(visual), visual);
    }
  }
  for (Collision& part : body.collisions) {
    if (part.name == "left_head") part.X_LG.p += left_m;
    if (part.name == "right_head") part.X_LG.p += right_m;
  }
}

}  // namespace dockyard::axel
