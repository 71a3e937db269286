#include "controller/vision/tags/tag_plane.h"

#include <vector>

namespace dockyard {

StraightPlane::StraightPlane(const TagCorners& corners_px, const Camera* camera) : camera_(camera) {
  if (camera == nullptr) return;
  std::vector<Eigen::Vector3d> rays_C;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : corners_px) {
    rays_C.push_back(camera->Direction(corner));
    middle += 0.25 * corner;
  }
  tangent_ = TangentPlaneAt(rays_C);
  const Eigen::Vector2d step = tangent_.FromRay(camera->Direction(middle + Eigen::Vector2d(1, 0))) -
                               tangent_.FromRay(camera->Direction(middle));
  scale_ = 1.0 / step.norm();
}

Eigen::Vector2d StraightPlane::FromPixel(const Eigen::Vector2d& pixel) const {
  if (camera_ == nullptr) return pixel;
  return scale_ * tangent_.FromRay(camera_->Direction(pixel));
}

std::optional<Eigen::Vector2d> StraightPlane::ToPixel(const Eigen::Vector2d& point) const {
  if (camera_ == nullptr) return point;
  constexpr double kFar_m =
      1e3;  // a ray's direction alone: the pupil's place does not matter there
  return camera_->Project(kFar_m * tangent_.ToRay(point / scale_));
}

std::optional<Eigen::Matrix3d> FromCells(const TagCorners& corners, int at_border) {
  const double half = 0.5 * at_border;
  return FitHomography({{.board = {-half, -half}, .image = corners[0]},
                        {.board = {half, -half}, .image = corners[1]},
                        {.board = {half, half}, .image = corners[2]},
                        {.board = {-half, half}, .image = corners[3]}});
}

}  // namespace dockyard
