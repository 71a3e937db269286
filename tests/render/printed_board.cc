#include "render/printed_board.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;

double TwiceArea(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return std::abs(sum);
}

/// The part of a convex polygon where sign * (coordinate - limit) <= 0 (Sutherland and Hodgman,
/// 1974).
Polygon Cut(const Polygon& polygon, int axis, double limit, double sign) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double over_a = sign * (a[axis] - limit), over_b = sign * (b[axis] - limit);
    if (over_a <= 0.0) kept.push_back(a);
    if ((over_a < 0.0 && over_b > 0.0) || (over_a > 0.0 && over_b < 0.0)) {
      kept.push_back(a + over_a / (over_a - over_b) * (b - a));
    }
  }
  return kept;
}

/// The points where the corners of a camera's pixels meet the board's plane, each computed on first
/// use.
class Footprints {
 public:
  Footprints(const Camera& camera, const Pose3& X_BC)
      : camera_(camera),
        X_BC_(X_BC),
        known_(static_cast<std::size_t>(camera.width + 1) * (camera.height + 1)),
        corners_(known_.size()) {}
  std::array<Eigen::Vector2d, 4> Of(int x, int y) {
    return {Corner(x, y), Corner(x + 1, y), Corner(x + 1, y + 1), Corner(x, y + 1)};
  }

 private:
  const Eigen::Vector2d& Corner(int x, int y) {
    const std::size_t at = static_cast<std::size_t>(y) * (camera_.width + 1) + x;
    if (!known_[at]) {
      const LensRay ray = camera_.Ray({x - 0.5, y - 0.5});
      const Eigen::Vector3d origin_B = X_BC_ * ray.origin, along_B = X_BC_.R * ray.direction;
      corners_[at] = (origin_B - origin_B.z() / along_B.z() * along_B).head<2>();
      known_[at] = true;
    }
    return corners_[at];
  }

  const Camera& camera_;
  Pose3 X_BC_;
  std::vector<bool> known_;
  std::vector<Eigen::Vector2d> corners_;
};

}  // namespace

double InkShare(const PrintedImage& print, const std::array<Eigen::Vector2d, 4>& corners_B) {
  const double half = 0.5 * print.modules;
  Polygon pixel;  // in modules, from the pattern's top left corner
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (const Eigen::Vector2d& corner : corners_B) {
    pixel.push_back((corner - print.p_BM) / print.module_m + Eigen::Vector2d(half, half));
    low = low.cwiseMin(pixel.back());
    high = high.cwiseMax(pixel.back());
  }
  if (low.maxCoeff() >= print.modules || high.minCoeff() <= 0.0) return 0.0;
  const auto module = [&](double at) {
    return static_cast<int>(std::clamp(std::floor(at), 0.0, print.modules - 1.0));
  };
  double black = 0.0;
  for (int row = module(low.y()); row <= module(high.y()); ++row) {
    const Polygon strip = Cut(Cut(pixel, 1, row, -1.0), 1, row + 1, 1.0);
    for (int column = module(low.x()); column <= module(high.x()); ++column) {
      if (!print.IsBlack(column, row)) continue;
      black += TwiceArea(Cut(Cut(strip, 0, column, -1.0), 0, column + 1, 1.0));
    }
  }
  return black / TwiceArea(pixel);
}

std::array<RadianceImage, 2> RenderPrinted(StereoRenderer& renderer, const Scene& scene,
                                           const StereoRig& rig, const Pose3& X_WR,
                                           const std::vector<PrintedImage>& prints) {
  Scene plain = scene;
  plain.boards[0].board.fiducials.clear();
  std::array<RadianceImage, 2> views = renderer.RenderRadiance(plain, rig, X_WR);
  plain.boards[0].white_albedo = plain.boards[0].black_albedo;
  const std::array<RadianceImage, 2> black = renderer.RenderRadiance(plain, rig, X_WR);
  for (std::size_t view = 0; view < 2; ++view) {
    const Camera& camera = view == 0 ? rig.left : rig.right;
    const Pose3 X_WC = X_WR * (view == 0 ? rig.X_RL : rig.X_RQ);
    Footprints footprints(camera, Inverse(scene.boards[0].X_WB) * X_WC);
    for (int y = 0; y < camera.height; ++y) {
      for (int x = 0; x < camera.width; ++x) {
        float& value = views[view].values[static_cast<std::size_t>(y) * camera.width + x];
        const float all_black = black[view].at(x, y);
        if (value == all_black) continue;  // no part of it shows the board
        const std::array<Eigen::Vector2d, 4> corners_B = footprints.Of(x, y);
        double ink = 0.0;
        for (const PrintedImage& print : prints) ink += InkShare(print, corners_B);
        value += static_cast<float>(ink) * (all_black - value);
      }
    }
  }
  return views;
}

}  // namespace dockyard
