#include "render/measure.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace dockyard {

double RadianceAt(const RadianceImage& image, const Eigen::Vector2d& pixel) {
  const int x = static_cast<int>(std::floor(pixel.x())),
            y = static_cast<int>(std::floor(pixel.y()));
  const double fx = pixel.x() - x, fy = pixel.y() - y;
  const double top = image.at(x, y) * (1 - fx) + image.at(x + 1, y) * fx;
  const double low = image.at(x, y + 1) * (1 - fx) + image.at(x + 1, y + 1) * fx;
  return top * (1 - fy) + low * fy;
}

double LargestRelativeDifference(const RadianceImage& a, const RadianceImage& b) {
  double difference = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    difference = std::max<double>(difference, std::abs(a.values[i] - b.values[i]));
    largest = std::max<double>(largest, a.values[i]);
  }
  return difference / largest;
}

Eigen::Vector2d CentroidOfDark(const RadianceImage& image, const Eigen::Vector2d& middle,
                               double half_window_px, double white_radiance) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double total = 0.0;
  for (int y = static_cast<int>(middle.y() - half_window_px); y <= middle.y() + half_window_px;
       ++y) {
    for (int x = static_cast<int>(middle.x() - half_window_px); x <= middle.x() + half_window_px;
         ++x) {
      const double dark = white_radiance - image.at(x, y);
      total += dark;
      sum += dark * Eigen::Vector2d(x, y);
    }
  }
  return sum / total;
}

Eigen::Vector3d OnFlatBoard(const Eigen::Vector2d& p_print) {
  return {p_print.x(), p_print.y(), 0.0};
}

Eigen::Vector2d ExactBlackCentroid(const FiducialBoard& board, const Fiducial& fiducial,
                                   const Camera& camera, const Pose3& X_CB,
                                   const PlaceOfPrint& place) {
  constexpr int kCells = 120;
  const double radius = 0.5 * board.disc_diameter_m, cell = 2.0 * radius / kCells;
  const Eigen::Vector2d along(std::cos(fiducial.rotation), -std::sin(fiducial.rotation));
  const auto project = [&](double x, double y) {
    return *camera.Project(X_CB * place({fiducial.p_BF.x() + x, fiducial.p_BF.y() + y}));
  };
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double total = 0.0;
  for (int j = 0; j < kCells; ++j) {
    for (int i = 0; i < kCells; ++i) {
      const double x = (i + 0.5) * cell - radius, y = (j + 0.5) * cell - radius;
      if (x * x + y * y > radius * radius) continue;
      const double a = x * along.x() + y * along.y(), b = x * along.y() - y * along.x();
      if (std::abs(a) < 0.5 * board.bar_length_m && std::abs(b) < 0.5 * board.bar_width_m) continue;
      const Eigen::Vector2d du = project(x + 1e-5, y) - project(x - 1e-5, y);
      const Eigen::Vector2d dv = project(x, y + 1e-5) - project(x, y - 1e-5);
      const double area = std::abs(du.x() * dv.y() - du.y() * dv.x());
      total += area;
      sum += area * project(x, y);
    }
  }
  return sum / total;
}

double UnshadedRadiance(const SunAndSky& light, const Eigen::Vector3d& normal_W, double albedo) {
  const double sun = light.sun_irradiance * std::max(0.0, normal_W.dot(light.to_sun_W));
  const double sky = 0.5 * (1.0 + normal_W.z()) * light.sky_irradiance;
  const double on_level =
      light.sun_irradiance * std::max(0.0, light.to_sun_W.z()) + light.sky_irradiance;
  const double bounce = 0.5 * (1.0 - normal_W.z()) * light.ground_bounce_albedo * on_level;
  return albedo / kPi * (sun + sky + bounce);
}

StereoRig RigAt(const Camera& camera, const Pose3& X_WC) {
  const Pose3 beside = X_WC * Pose3::Translation(0.35, 0, 0);
  return {.left = camera, .right = camera, .X_RL = X_WC, .X_RQ = beside};
}

Pose3 LookAt(const Eigen::Vector3d& from_W, const Eigen::Vector3d& target_W) {
  const Eigen::Vector3d forward = (target_W - from_W).normalized();
  const Eigen::Vector3d right = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  Pose3 X_WC;
  X_WC.R << right, forward.cross(right), forward;
  X_WC.p = from_W;
  return X_WC;
}

}  // namespace dockyard
