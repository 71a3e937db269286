#include "controller/vision/board/detected_marks.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace dockyard {
namespace {

/// How far on the plane the gate reaches: over the least stretch of px_by_T, with a margin for
/// rounding.
double Reach(const SeenMark& seen) {
  const double squares = seen.px_by_T.squaredNorm();
  const double area = seen.px_by_T.determinant();
  const double root = std::sqrt(std::max(0.0, squares * squares - 4.0 * area * area));
  const double least = std::sqrt(std::max(0.0, 0.5 * (squares - root)));
  return 1.001 * seen.gate_px / least;
}

}  // namespace

DetectedMarks MarksOf(const std::vector<DetectedFiducial>& detections, const Camera& camera,
                      const FiducialBoard& board) {
  DetectedMarks marks;
  std::vector<Eigen::Vector3d> rays;
  for (const auto& detection : detections)
    rays.push_back(camera.Direction(detection.rim.centre_px));
  marks.plane = TangentPlaneAt(rays);
  for (std::size_t i = 0; i < detections.size(); ++i) {
    const Ellipse& rim = detections[i].rim;
    const auto on_plane = [&](double du, double dv) {
      return marks.plane.FromRay(camera.Direction(rim.centre_px + Eigen::Vector2d(du, dv)));
    };
    Eigen::Matrix2d T_by_px;
    T_by_px.col(0) = 0.5 * (on_plane(1, 0) - on_plane(-1, 0));
    T_by_px.col(1) = 0.5 * (on_plane(0, 1) - on_plane(0, -1));
    SeenMark seen;
    seen.at_T = marks.plane.FromRay(rays[i]);
    seen.px_by_T = T_by_px.inverse();
    seen.board_by_T = 0.5 * board.disc_diameter_m * rim.shape_px.inverse() * seen.px_by_T;
    seen.sight_C = rays[i];
    seen.radius_px = rim.mean_radius_px();
    seen.gate_px = 3.0 + 0.25 * seen.radius_px;
    marks.seen.push_back(seen);
    marks.by_x.push_back(i);
    const double reach_T = Reach(seen);
    if (!(reach_T <= marks.reach_T)) marks.reach_T = reach_T;
  }
  std::sort(marks.by_x.begin(), marks.by_x.end(), [&](std::size_t a, std::size_t b) {
    return marks.seen[a].at_T.x() < marks.seen[b].at_T.x();
  });
  if (!std::isfinite(marks.reach_T)) marks.reach_T = std::numeric_limits<double>::infinity();
  return marks;
}

Naming NameBy(const DetectedMarks& marks, const std::vector<Eigen::Vector2d>& places_T,
              const std::vector<double>& radii_px) {
  std::vector<std::tuple<double, int, int>> pairs;
  for (std::size_t id = 0; id < places_T.size(); ++id) {
    const Eigen::Vector2d& place = places_T[id];
    if (std::isnan(place.x())) continue;
    auto next = std::lower_bound(
        marks.by_x.begin(), marks.by_x.end(), place.x() - marks.reach_T,
        [&](std::size_t d, double least) { return marks.seen[d].at_T.x() < least; });
    for (; next != marks.by_x.end(); ++next) {
      const std::size_t d = *next;
      const SeenMark& seen = marks.seen[d];
      if (seen.at_T.x() > place.x() + marks.reach_T) break;
      if (std::abs(place.y() - seen.at_T.y()) > marks.reach_T) continue;
      const double ratio = radii_px[id] > 0.0 ? seen.radius_px / radii_px[id] : 1.0;
      if (ratio > kDiscSizeTolerance || ratio < 1.0 / kDiscSizeTolerance) continue;
      const double distance = (seen.px_by_T * (place - seen.at_T)).norm();
      if (distance < seen.gate_px) {
        pairs.emplace_back(distance, static_cast<int>(id), static_cast<int>(d));
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  Naming naming;
  std::vector<bool> id_taken(places_T.size(), false), detection_taken(marks.seen.size(), false);
  for (const auto& [distance, id, d] : pairs) {
    const std::size_t mark = static_cast<std::size_t>(id), detection = static_cast<std::size_t>(d);
    if (id_taken[mark] || detection_taken[detection]) continue;
    id_taken[mark] = detection_taken[detection] = true;
    naming.push_back({.id = id, .detection = d});
  }
  std::sort(naming.begin(), naming.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  return naming;
}

}  // namespace dockyard
