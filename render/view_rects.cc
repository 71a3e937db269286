#include "render/view_rects.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

std::optional<TanRect> BoardRect(const BoardView& view, const Pose3& X_WC, const TanRect& image) {
  const Pose3 X_CB = Inverse(X_WC) * view.X_WB;
  // The box that holds a bent one, too.
  TanRect rect{.left = 1e9, .top = 1e9, .right = -1e9, .bottom = -1e9};
  for (int i = 0; i < (view.flatness_m == 0.0 ? 4 : 8); ++i) {
    const double x = i & 2 ? 0.5 : -0.5, y = i & 1 ? 0.5 : -0.5;
    const double z = i & 4 ? -std::abs(view.flatness_m) : 0.0;
    const Eigen::Vector3d p_C =
        X_CB * Eigen::Vector3d(x * view.board.width_m, y * view.board.height_m, z);
    if (p_C.z() < 0.05) return std::nullopt;
    const Eigen::Vector2d tan = p_C.head<2>() / p_C.z();
    rect.left = std::min(rect.left, tan.x());
    rect.right = std::max(rect.right, tan.x());
    rect.top = std::min(rect.top, tan.y());
    rect.bottom = std::max(rect.bottom, tan.y());
  }
  const double margin = 0.03 * (rect.right - rect.left + rect.bottom - rect.top) + 0.01;
  rect = {std::max(rect.left - margin, image.left), std::max(rect.top - margin, image.top),
          std::min(rect.right + margin, image.right), std::min(rect.bottom + margin, image.bottom)};
  if (rect.right - rect.left < 0.01 || rect.bottom - rect.top < 0.01) return std::nullopt;
  return rect;
}

// The part of the image that a ball covers, in the tan plane: bounded by the planes through the
// camera's x or y axis that touch the ball.
std::optional<TanRect> BallRect(const Interest& ball, const Pose3& X_WC, const TanRect& image) {
  const Eigen::Vector3d p_C = Inverse(X_WC) * ball.p_W;
  if (p_C.z() < ball.radius_m + 0.02) return std::nullopt;
  const auto edge = [&](double across, double side) {
    const double away = std::hypot(across, p_C.z());
    return std::tan(std::atan2(across, p_C.z()) + side * std::asin(ball.radius_m / away));
  };
  const TanRect rect{
      std::max(edge(p_C.x(), -1.0), image.left), std::max(edge(p_C.y(), -1.0), image.top),
      std::min(edge(p_C.x(), 1.0), image.right), std::min(edge(p_C.y(), 1.0), image.bottom)};
  if (rect.right - rect.left < 0.01 || rect.bottom - rect.top < 0.01) return std::nullopt;
  return rect;
}

}  // namespace

void SizeView(const Camera& camera, const TanRect& rect, double density, double most_pixels,
              FlatView& view) {
  const double w = rect.right - rect.left, h = rect.bottom - rect.top;
  const Eigen::Vector2d f = camera.focal_px();
  const double wanted = density * density * f.x() * f.y() * w * h;
  const double scale = density * std::min(1.0, std::sqrt(most_pixels / wanted));
  view.rect = rect;
  view.width = std::max(2, static_cast<int>(std::ceil(scale * f.x() * w)));
  view.height = std::max(2, static_cast<int>(std::ceil(scale * f.y() * h)));
}

std::optional<TanRect> CloseRect(const Scene& scene, const Pose3& X_WC, const TanRect& image) {
  if (scene.interest) return BallRect(*scene.interest, X_WC, image);
  std::optional<TanRect> largest;
  const auto area = [](const TanRect& r) { return (r.right - r.left) * (r.bottom - r.top); };
  for (const BoardView& board : scene.boards) {
    const auto rect = BoardRect(board, X_WC, image);
    if (rect && (!largest || area(*rect) > area(*largest))) largest = rect;
  }
  return largest;
}

}  // namespace dockyard
