#include "models/parts/stretch.h"

#include <cmath>
#include <memory>
#include <utility>

namespace dockyard {
namespace {

constexpr double kSame = 1e-9;

/// The factors along the shape's own axes; false if the link's axes are not among them.
bool AlongShape(const Pose3& X_LG, const Eigen::Vector3d& factors, Eigen::Vector3d& along) {
  const Eigen::Matrix3d stretch = X_LG.R.transpose() * factors.asDiagonal() * X_LG.R;
  along = stretch.diagonal();
  return (stretch - Eigen::Matrix3d(along.asDiagonal())).cwiseAbs().maxCoeff() < kSame;
}

bool Same(double a, double b) { return std::abs(a - b) < kSame; }

bool Stretch(Collision& part, const Eigen::Vector3d& factors) {
  if (auto* hull = std::get_if<HullShape>(&part.shape)) {
    for (Eigen::Vector3d& p : hull->points) {
      p = Inverse(part.X_LG) * factors.cwiseProduct(part.X_LG * p).eval();
    }
    return true;  // the frame stays: its points carry the growth
  }
  Eigen::Vector3d along;
  const bool straight = AlongShape(part.X_LG, factors, along);
  part.X_LG.p = factors.cwiseProduct(part.X_LG.p);
  if (auto* box = std::get_if<BoxShape>(&part.shape)) {
    box->size_m = box->size_m.cwiseProduct(along);
    return straight;
  }
  if (auto* cylinder = std::get_if<CylinderShape>(&part.shape)) {
    cylinder->radius_m *= along.x();
    cylinder->length_m *= along.z();
    return straight && Same(along.x(), along.y());
  }
  if (auto* sphere = std::get_if<SphereShape>(&part.shape)) {
    sphere->radius_m *= along.x();
    return straight && Same(along.x(), along.y()) && Same(along.x(), along.z());
  }
  auto& turned = std::get<TurnedShape>(part.shape);
  for (Eigen::Vector2d& p : turned.profile_m) p = {along.z() * p.x(), along.x() * p.y()};
  return straight && Same(along.x(), along.y());
}

}  // namespace

bool StretchShapes(LinkModel& link, const Eigen::Vector3d& factors) {
  for (Visual& visual : link.visuals) {
    auto mesh = std::make_shared<TriangleMesh>(*visual.mesh);
    for (Eigen::Vector3d& v : mesh->vertices) v = factors.cwiseProduct(visual.X_LV * v).eval();
    visual.mesh = std::move(mesh);
    visual.X_LV = Pose3{};
  }
  for (Collision& part : link.collisions) {
    if (!Stretch(part, factors)) return false;
  }
  return true;
}

}  // namespace dockyard
