#include "controller/motion/keep_in_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "controller/motion/circle_way.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

// What the ring's part is made of, as values that the target must keep above 0.
struct Borders {
  Vector2d camera, left, right;  // inward normals of the two sides
  double near_m = 0.0, far_m = 0.0;
};

Borders BordersOf(const ViewPlan& view) {
  const double to_left = view.azimuth_rad + view.half_width_rad;
  const double to_right = view.azimuth_rad - view.half_width_rad;
  return {view.p_RC,
          {std::sin(to_left), -std::cos(to_left)},
          {-std::sin(to_right), std::cos(to_right)},
          view.near_m,
          view.far_m};
}

// Seen from the rover the target goes straight.
double SpareOnLine(const Borders& in, const Vector2d& from, const Vector2d& to) {
  const double nearest = ToSegment(in.camera, from, to);
  const double farthest = std::max((from - in.camera).norm(), (to - in.camera).norm());
  double least = std::min(nearest - in.near_m, in.far_m - farthest);
  for (const Vector2d& inward : {in.left, in.right}) {
    least = std::min({least, inward.dot(from - in.camera), inward.dot(to - in.camera)});
  }
  return least;
}

double SpareOnCircle(const Borders& in, const CircleWay& way) {
  double least =
      std::min(way.DistanceTo(in.camera) - in.near_m, in.far_m - way.FarthestFrom(in.camera));
  for (const Vector2d& inward : {in.left, in.right}) {
    least = std::min(least, way.LeastAlong(inward) - inward.dot(in.camera));
  }
  return least;
}

}  // namespace

double SpareInView(const ViewPlan& view, const std::vector<Arc>& path, const Vector2d& p_AT) {
  const Borders borders = BordersOf(view);
  double least = std::numeric_limits<double>::infinity();
  Pose2 X_AR;
  for (const Arc& arc : path) {
    const Vector2d p_RT = Inverse(X_AR) * p_AT;
    if (std::abs(arc.turn_rad) < kStraight_rad) {
      least = std::min(least, SpareOnLine(borders, p_RT, p_RT - Vector2d(arc.length_m, 0.0)));
    } else {
      const Vector2d centre(0.0, arc.length_m / arc.turn_rad);
      least = std::min(least, SpareOnCircle(borders, {centre, p_RT, -arc.turn_rad}));
    }
    X_AR = Advance(X_AR, arc);
  }
  return least;
}

}  // namespace dockyard
