#include "controller/motion/clearance.h"

#include <algorithm>

#include "controller/motion/arc_distance.h"
#include "controller/motion/polygon.h"
#include "controller/motion/steering.h"

namespace dockyard {
namespace {

using Eigen::Vector2d;

/// Parts of the rover that drive an arc. They must outlive it.
class Sweep {
 public:
  Sweep(const Pose2& X_AR, const Arc& arc, const std::vector<Polygon>& parts) : arc_(X_AR, arc) {
    for (const Polygon& part : parts) {
      parts_.push_back(RoundOf(part));
      reach_m_ = std::max(reach_m_, parts_.back().middle.norm() + parts_.back().reach_m);
    }
  }

  /// From the disc to the nearest part, negative within; no more than enough_m.
  double FromDisc(const Disc& disc, double enough_m) const {
    const Vector2d centre_R = arc_.InR(disc.centre);
    if (IsFar(centre_R, disc.radius_m, enough_m)) return enough_m;
    const double far_m = enough_m + disc.radius_m, apart_m = FromPoint(centre_R, far_m, parts_);
    return apart_m < far_m ? apart_m - disc.radius_m : enough_m;
  }

  double FromPolygon(const Polygon& polygon_A, double enough_m) const {
    const Rounded round_A = RoundOf(polygon_A);
    const Vector2d middle_R = arc_.InR(round_A.middle);
    if (IsFar(middle_R, round_A.reach_m, enough_m)) return enough_m;
    Polygon polygon_R;
    for (const Vector2d& corner : polygon_A) polygon_R.push_back(arc_.InR(corner));
    std::vector<Rounded> near;
    for (const Rounded& part : parts_) {
      const double apart_m = arc_.OfPart(part.middle, part.middle, middle_R);
      if (apart_m - part.reach_m - round_A.reach_m < enough_m) near.push_back(part);
    }
    double least = enough_m;
    for (const Vector2d& corner : polygon_R) {
      least = std::min(least, FromPoint(corner, least, near));
    }
    for (const Rounded& part : near) {
      if (Contains(polygon_R, part.corners->front())) least = std::min(least, 0.0);
      for (const Vector2d& corner : *part.corners) {
        if (arc_.OfPart(corner, corner, middle_R) - round_A.reach_m >= least) continue;
        ForEachSide(polygon_R, [&](const Vector2d& a, const Vector2d& b) {
          least = std::min(least, arc_.OfPoint(corner, a, b));
        });
      }
    }
    if (least > 0.0) return least;
    const double within_m = std::max(0.0, DepthIn(polygon_R, middle_R));
    return std::min(least, FromPoint(middle_R, within_m, near) - within_m);
  }

 private:
  /// A polygon and a circle round it.
  struct Rounded {
    const Polygon* corners = nullptr;
    Vector2d middle{0, 0};
    double reach_m = 0.0;
  };
  static Rounded RoundOf(const Polygon& polygon) {
    Rounded round{&polygon, MeanCorner(polygon)};
    for (const Vector2d& corner : polygon) {
      round.reach_m = std::max(round.reach_m, (corner - round.middle).norm());
    }
    return round;
  }

  bool IsFar(const Vector2d& middle_R, double reach_m, double enough_m) const {
    return arc_.OfPart({0, 0}, {0, 0}, middle_R) > reach_m + reach_m_ + enough_m;
  }
  // From a fixed point to the nearest of these parts, no more than enough_m; 0 where one passes
  // over it.
  double FromPoint(const Vector2d& p_R, double enough_m, const std::vector<Rounded>& parts) const {
    double least = enough_m;
    for (const Rounded& part : parts) {
      const double apart_m = arc_.OfPart(part.middle, part.middle, p_R);
      if (apart_m - part.reach_m >= least) continue;
      if (Contains(*part.corners, p_R)) return std::min(least, 0.0);
      ForEachSide(*part.corners, [&](const Vector2d& a, const Vector2d& b) {
        least = std::min(least, arc_.OfPart(a, b, p_R));
      });
    }
    return least;
  }

  SweptArc arc_;
  std::vector<Rounded> parts_;
  double reach_m_ = 0.0;  // from R
};

double FromAll(const Sweep& sweep, const Obstacles& obstacles, double enough_m) {
  double least = enough_m;
  for (const Disc& disc : obstacles.discs) least = std::min(least, sweep.FromDisc(disc, least));
  for (const Polygon& polygon : obstacles.polygons) {
    least = std::min(least, sweep.FromPolygon(polygon, least));
  }
  return least;
}

}  // namespace

std::vector<Polygon> OutlineOn(const RoverPlan& rover, const Arc& arc) {
  std::vector<Polygon> parts = rover.body;
  for (const WheelPlan& wheel : rover.wheels) {
    const Pose2 X_RW{wheel.p_RW.x(), wheel.p_RW.y(), OnArc(wheel, arc).steer_rad};
    parts.push_back(Moved(X_RW, WheelOutline(rover)));
  }
  return parts;
}

double Clearance(const RoverPlan& rover, const std::vector<Arc>& path, const Obstacles& obstacles,
                 double enough_m) {
  if (obstacles.discs.empty() && obstacles.polygons.empty()) return enough_m;
  const std::vector<Polygon> wheel{WheelOutline(rover)};
  double least = enough_m;
  Pose2 X_AR;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const std::vector<Polygon> outline = OutlineOn(rover, path[i]);
    least = std::min(least, FromAll(Sweep(X_AR, path[i], outline), obstacles, least));
    X_AR = Advance(X_AR, path[i]);
    if (i + 1 == path.size()) break;
    for (const WheelPlan& mount : rover.wheels) {
      const double before = OnArc(mount, path[i]).steer_rad;
      const double after = OnArc(mount, path[i + 1]).steer_rad;
      if (before == after) continue;
      const Pose2 X_AW = X_AR * Pose2{mount.p_RW.x(), mount.p_RW.y(), before};
      least = std::min(least, FromAll(Sweep(X_AW, {0.0, after - before}, wheel), obstacles, least));
    }
  }
  return least;
}

double StandingClearance(const RoverPlan& rover, const Pose2& X_AR, const Obstacles& obstacles,
                         double enough_m) {
  return FromAll(Sweep(X_AR, {}, rover.body), obstacles, enough_m);
}

}  // namespace dockyard
