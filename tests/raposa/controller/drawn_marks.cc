#include "raposa/controller/drawn_marks.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/base/random.h"

namespace dockyard::raposa {
namespace {

constexpr Colour kDark{4, 4, 4};  // beyond the hole

using Points = std::vector<Eigen::Vector2d>;

double Cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Andrew's monotone chain.
Points ConvexHull(Points points) {
  if (points.size() < 3) return {};
  std::ranges::sort(points, [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  Points hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const Eigen::Vector2d& p : points) {
      while (hull.size() >= first + 2 &&
             Cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::ranges::reverse(points);
  }
  return hull;
}

class Canvas {
 public:
  Canvas(int width, int height, const Colour& background)
      : width_(width),
        height_(height),
        pixels_(static_cast<std::size_t>(width * height), background) {}

  /// A convex polygon, by 8 x 8 samples a pixel. Holes: those samples are left out.
  void Fill(const Points& corners, const Points& hole, const Colour& colour) {
    const Points hull = ConvexHull(corners), cut = ConvexHull(hole);
    if (hull.size() < 3) return;
    double low_x = 1e9, low_y = 1e9, high_x = -1e9, high_y = -1e9;
    for (const Eigen::Vector2d& p : hull) {
      low_x = std::min(low_x, p.x());
      high_x = std::max(high_x, p.x());
      low_y = std::min(low_y, p.y());
      high_y = std::max(high_y, p.y());
    }
    const int x0 = std::max(0, static_cast<int>(std::floor(low_x - 1.0)));
    const int x1 = std::min(width_ - 1, static_cast<int>(std::ceil(high_x + 1.0)));
    const int y0 = std::max(0, static_cast<int>(std::floor(low_y - 1.0)));
    const int y1 = std::min(height_ - 1, static_cast<int>(std::ceil(high_y + 1.0)));
    for (int y = y0; y <= y1; ++y) {
      for (int x = x0; x <= x1; ++x) Blend(x, y, Share(hull, cut, x, y), colour);
    }
  }

  Colour& At(int x, int y) { return pixels_[static_cast<std::size_t>(y * width_ + x)]; }

 private:
  static bool Inside(const Points& hull, const Eigen::Vector2d& q) {
    for (std::size_t i = 0; i < hull.size(); ++i) {
      if (Cross(hull[(i + 1) % hull.size()] - hull[i], q - hull[i]) < 0.0) return false;
    }
    return hull.size() >= 3;
  }
  /// Of the point inside the polygon's nearest edge; next to a corner outside it is too small.
  static double Depth(const Points& hull, const Eigen::Vector2d& q) {
    double least = hull.size() < 3 ? -1e9 : 1e9;
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
      least = std::min(least, Cross(edge, q - hull[i]) / edge.norm());
    }
    return least;
  }
  static double Share(const Points& hull, const Points& cut, int x, int y) {
    constexpr double kPixel = 0.71;  // half its diagonal
    const Eigen::Vector2d middle(x, y);
    const double depth = Depth(hull, middle), in_cut = Depth(cut, middle);
    if (depth < -kPixel || in_cut > kPixel) return 0.0;
    if (depth > kPixel && in_cut < -kPixel) return 1.0;
    int inside = 0;
    for (int i = 0; i < 64; ++i) {
      const Eigen::Vector2d q(x - 0.5 + (i % 8 + 0.5) / 8.0, y - 0.5 + (i / 8 + 0.5) / 8.0);
      if (Inside(hull, q) && !Inside(cut, q)) ++inside;
    }
    return inside / 64.0;
  }
  void Blend(int x, int y, double share, const Colour& colour) {
    Colour& at = At(x, y);
    for (std::size_t i = 0; i < 3; ++i) at[i] += share * (colour[i] - at[i]);
  }

  int width_, height_;
  std::vector<Colour> pixels_;
};

/// The camera's axes in P: right, down, along.
Pose3 CameraPose(const Pose2& X_PC, const Scene& scene) {
  Eigen::Matrix3d R_level;  // x right, y down, z along the pose's x axis
  R_level << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {RotZ(X_PC.heading) * RotY(scene.pitch_rad) * R_level,
          {X_PC.x, X_PC.y, scene.camera_up_m}};
}

std::optional<Points> Project(const Camera& camera, const Pose3& X_CP,
                              const std::vector<Eigen::Vector3d>& points_P) {
  Points pixels;
  for (const Eigen::Vector3d& p_P : points_P) {
    const Eigen::Vector3d p_C = X_CP * p_P;
    if (p_C.z() < 0.01) return std::nullopt;
    const auto pixel = camera.Project(p_C);
    if (!pixel) return std::nullopt;
    pixels.push_back(*pixel);
  }
  return pixels;
}

/// The corners of an upright square, and of one depth_m before it.
std::vector<Eigen::Vector3d> Square(double x_m, double side_m, double depth_m = 0.0) {
  std::vector<Eigen::Vector3d> corners;
  for (const double y : {-0.5, 0.5}) {
    for (const double z : {-0.5, 0.5}) {
      corners.emplace_back(x_m, y * side_m, z * side_m);
      corners.emplace_back(x_m + depth_m, y * side_m, z * side_m);
    }
  }
  return corners;
}

/// Two cones, base to base.
std::vector<Eigen::Vector3d> BiCone(const Marks& marks) {
  std::vector<Eigen::Vector3d> points{{0.5 * marks.guide_length_m, 0, 0},
                                      {-0.5 * marks.guide_length_m, 0, 0}};
  for (int i = 0; i < 24; ++i) {
    const double turn = 2.0 * kPi * i / 24.0, radius = 0.5 * marks.guide_diameter_m;
    points.emplace_back(0.0, radius * std::cos(turn), radius * std::sin(turn));
  }
  return points;
}

void DrawPyramid(const Nominal& nominal, const Pose3& X_CP, const Scene& scene, Canvas* canvas) {
  const Marks& marks = nominal.marks;
  // Paint on sides and front of the square's edges.
  const auto square =
      Project(nominal.camera, X_CP, Square(-marks.behind_m, marks.edge_m, scene.strip_m));
  const double inner_m = scene.strip_m > 0.0 ? marks.edge_m - 2.0 * scene.strip_m : 0.0;
  const auto inner =
      Project(nominal.camera, X_CP, Square(-marks.behind_m + scene.strip_m, inner_m));
  if (square && inner) canvas->Fill(*square, inner_m > 0.0 ? *inner : Points{}, scene.blue);
  const auto guide = Project(nominal.camera, X_CP, BiCone(marks));
  if (guide) canvas->Fill(*guide, {}, scene.orange);
}

}  // namespace

Nominal TestNominal(double lever_m) {
  Nominal nominal;
  const NominalMotor belt{1e-4, 1.0, 0.1, 6.0, 5.0, 10.0};
  const NominalMotor slow{1e-4, 1.0, 0.1, 2.0, 1.0, 5.0};
  nominal.motors = {belt, belt, slow, slow, slow};
  nominal.camera = {320, 240, BrownPinhole{.fx = 377, .fy = 377, .cx = 159.5, .cy = 119.5}};
  Eigen::Matrix3d R_RC;  // faces along -x of R; x right of the view is R's left
  R_RC << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  nominal.X_RC = {R_RC, {-lever_m, 0.0, 0.0}};
  nominal.half_view_rad = Radians(12.5);
  nominal.marks = {.edge_m = 0.06,
                   .behind_m = 0.03 * std::tan(Radians(73.0)),
                   .guide_diameter_m = 0.030,
                   .guide_length_m = 0.050,
                   .guide_height_m = 0.045,
                   .strip_m = 0.01,
                   .rise_rad = Radians(17.0),
                   .guide_half_angle_rad = Radians(30.0),
                   .guide_up_rad = Radians(5.0),
                   .rod_radius_m = 0.004,
                   .guide_blunt_radius_m = 0.0025};
  nominal.sprocket_radius_m = 0.09;
  nominal.gauge_m = 0.426;
  nominal.effective_gauge_m = 0.577;
  nominal.body_belt_m = 0.386;
  nominal.arm_length_m = 0.18;
  nominal.door_pinion_radius_m = 0.01;
  nominal.door_travel_m = 0.02;
  nominal.p_RS = {-lever_m - 0.08, 0.0, 0.0};
  // Of the drawn paints.
  nominal.ferreira_vision.orange = {
      .hue_from = 4, .hue_to = 18, .saturation_from = 85, .value_from = 43};
  nominal.ferreira_vision.blue = {
      .hue_from = 100, .hue_to = 125, .saturation_from = 70, .value_from = 30};
  // Half as fine a camera as the robot's: a quarter of the area, twice the gains of a pixel.
  nominal.ferreira_vision.least_area_px2 = 12.0;
  nominal.ferreira_motion.k_angular_rad_s_px *= 2.0;
  nominal.ferreira_motion.k_arm_rad_px *= 2.0;
  return nominal;
}

Clutter Box(double left_px, double top_px, double right_px, double bottom_px, const Colour& colour,
            bool in_front) {
  return {{{left_px, top_px}, {right_px, top_px}, {right_px, bottom_px}, {left_px, bottom_px}},
          colour,
          in_front};
}

Pose2 CameraAt(double r_m, double alpha_rad, double bearing_rad) {
  return {r_m * std::cos(alpha_rad), r_m * std::sin(alpha_rad),
          WrapPi(alpha_rad + kPi + bearing_rad)};
}

RgbImage Draw(const Nominal& nominal, const Pose2& X_PC, const Scene& scene) {
  const Camera& camera = nominal.camera;
  Canvas canvas(camera.width, camera.height, scene.background);
  for (const Clutter& one : scene.clutter) {
    if (!one.in_front) canvas.Fill(one.corners_px, {}, one.colour);
  }
  if (scene.pyramid) DrawPyramid(nominal, Inverse(CameraPose(X_PC, scene)), scene, &canvas);
  for (const Clutter& one : scene.clutter) {
    if (one.in_front) canvas.Fill(one.corners_px, {}, one.colour);
  }
  const double hole_px = camera.focal_px().x() * std::tan(nominal.half_view_rad);
  const Eigen::Vector2d middle = camera.centre_px();
  RandomStream random(StreamKey(scene.seed, "pixels"));
  RgbImage image{camera.width, camera.height, {}};
  image.pixels.resize(static_cast<std::size_t>(3 * camera.width * camera.height));
  std::uint8_t* out = image.pixels.data();
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      const double u = x - middle.x(), v = y - middle.y();
      const Colour& colour = u * u + v * v > hole_px * hole_px ? kDark : canvas.At(x, y);
      for (const double channel : colour) {
        const double value = channel + (scene.noise > 0.0 ? scene.noise * random.Normal() : 0.0);
        *out++ = static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
      }
    }
  }
  return image;
}

}  // namespace dockyard::raposa
