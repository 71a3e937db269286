#include "sim/rigid/turned_solid.h"

#include <cmath>
#include <stdexcept>

namespace dockyard {
namespace {

constexpr int kSamples = 16;  // of a ring; two minima are further apart than three of them
constexpr double kSampleStep = 2.0 * kPi / kSamples;
// The root of the slope is found to this angle; the distance then errs by radius x 1e-12.
constexpr double kAngleError_rad = 1e-6;
constexpr int kMostRootSteps = 40;
constexpr double kRounding_m = 1e-9;  // far above that of a distance
constexpr double kFlat = 1.0 - 1e-9;  // a normal so near the axis belongs to a flat end
// A ring tilted by so much touches a flat end at one place alone: 300 N press a contact of 200 kN/m
// in by 1.5 mm. Assumed, range 0.5-2 mm.
constexpr double kTilted_m = 1e-3;

struct Probe {
  RingPoint point;
  bool on_flat_end = false;
  double slope_m = 0.0;  // of the distance over the angle
};

struct Direction {
  double angle_rad = 0.0, cos = 1.0, sin = 0.0;
  Direction() = default;
  explicit Direction(double angle) : angle_rad(angle), cos(std::cos(angle)), sin(std::sin(angle)) {}
};

const std::array<Direction, kSamples>& SampleDirections() {
  static const std::array<Direction, kSamples> directions = [] {
    std::array<Direction, kSamples> all;
    for (int i = 0; i < kSamples; ++i) all[i] = Direction(i * kSampleStep);
    return all;
  }();
  return directions;
}

Probe ProbeAt(const Ring& ring, const TurnedSolid& solid, const Direction& direction) {
  const double angle_rad = direction.angle_rad, c = direction.cos, s = direction.sin;
  Probe probe;
  RingPoint& point = probe.point;
  point.angle_rad = angle_rad;
  point.p = ring.centre + ring.radius_m * (c * ring.x + s * ring.y);
  const double r = std::hypot(point.p.x(), point.p.y());
  const TurnedSolid::Nearest nearest = solid.NearestTo({point.p.z(), r});
  point.distance_m = nearest.distance_m;
  point.on_side = nearest.on_side;
  probe.on_flat_end = nearest.on_side && std::abs(nearest.normal.x()) > kFlat;
  point.normal = {0.0, 0.0, nearest.normal.x()};
  if (r > 0.0) point.normal.head<2>() = nearest.normal.y() / r * point.p.head<2>();
  probe.slope_m = ring.radius_m * point.normal.dot(c * ring.y - s * ring.x);
  return probe;
}

// The root of the slope between a place where it falls and one where it rises: by regula falsi,
// halving the weight of an end that stays (the Illinois rule).
Probe Least(const Ring& ring, const TurnedSolid& solid, Probe low, Probe high) {
  double f_low = low.slope_m, f_high = high.slope_m;
  int stayed = 0;
  Probe middle = low;
  for (int i = 0; i < kMostRootSteps; ++i) {
    const double a = low.point.angle_rad, b = high.point.angle_rad;
    if (b - a < kAngleError_rad) break;
    double next = (a * f_high - b * f_low) / (f_high - f_low);
    if (!(next > a && next < b)) next = 0.5 * (a + b);
    const double last = middle.point.angle_rad;
    middle = ProbeAt(ring, solid, Direction(next));
    if (middle.slope_m < 0.0) {
      low = middle;
      f_low = middle.slope_m;
      if (stayed == 1) f_high *= 0.5;
      stayed = 1;
    } else {
      high = middle;
      f_high = middle.slope_m;
      if (stayed == -1) f_low *= 0.5;
      stayed = -1;
    }
    if (middle.slope_m == 0.0 || std::abs(next - last) < kAngleError_rad) break;
  }
  return middle;
}

// To one or two places of least distance on a side, those between them. `spread` is the greatest
// distance less the least, over the one up to which places count.
int AddAllRound(const Ring& ring, const TurnedSolid& solid, double spread, int count,
                RingPoints& points) {
  const int places = count + 2;
  const double share = std::min(1.0, (1.0 + (places - 1) * spread) / places);
  const double middle_rad =
      count == 1 ? points[0].angle_rad : 0.5 * (points[0].angle_rad + points[1].angle_rad);
  const double turn_rad = count == 1 ? 2.0 * kPi / 3.0 : kPi;
  const double from_rad = count == 1 ? middle_rad + turn_rad : middle_rad;
  for (const double angle_rad : {from_rad, from_rad + turn_rad}) {
    points[count++] = ProbeAt(ring, solid, Direction(angle_rad)).point;
  }
  for (int i = 0; i < count; ++i) points[i].share = share;
  return count;
}

}  // namespace

TurnedSolid::TurnedSolid(const std::vector<Eigen::Vector2d>& outline_m) {
  if (outline_m.size() < 3) throw std::invalid_argument("a turned solid needs three corners");
  for (std::size_t i = 0; i < outline_m.size(); ++i) {
    const Eigen::Vector2d &from = outline_m[i], &to = outline_m[(i + 1) % outline_m.size()];
    if (from.y() == 0.0 && to.y() == 0.0) continue;  // along the axis
    Side side;
    side.from = from;
    side.length_m = (to - from).norm();
    side.along = (to - from) / side.length_m;
    side.out = {-side.along.y(), side.along.x()};
    side.offset_m = side.out.dot(from);
    sides_.push_back(side);
  }
  for (const Side& side : sides_) {
    for (const Eigen::Vector2d& corner : outline_m) {
      if (side.out.dot(corner) > side.offset_m + 1e-9) {
        throw std::invalid_argument("the cut of a turned solid must be convex");
      }
    }
  }
}

TurnedSolid::Nearest TurnedSolid::NearestTo(const Eigen::Vector2d& point_m) const {
  Nearest nearest{-1e9, {0.0, 0.0}, true};
  for (const Side& side : sides_) {
    const double out = side.out.dot(point_m) - side.offset_m;
    if (out > nearest.distance_m) nearest = {out, side.out, true};
  }
  if (nearest.distance_m <= 0.0) return nearest;
  nearest.distance_m = 1e9;
  for (const Side& side : sides_) {
    const double out = side.out.dot(point_m) - side.offset_m;
    if (out <= 0.0 || out >= nearest.distance_m) continue;  // faces away, or is further in any case
    const double along = side.along.dot(point_m - side.from);
    if (along >= 0.0 && along <= side.length_m) return {out, side.out, true};
    const Eigen::Vector2d from_corner =
        point_m -
        (along < 0.0 ? side.from : Eigen::Vector2d(side.from + side.length_m * side.along));
    const double distance = from_corner.norm();
    if (distance < nearest.distance_m) nearest = {distance, from_corner / distance, false};
  }
  return nearest;
}

Ring operator*(const Pose3& X, const Ring& ring) {
  return {X * ring.centre, X.R * ring.x, X.R * ring.y, ring.radius_m};
}

// All of a ring lies in this box of the half plane (z, r).
Eigen::AlignedBox2d CutOf(const Ring& ring) {
  const double z_m = ring.radius_m * std::hypot(ring.x.z(), ring.y.z());
  const double aside_m = ring.centre.head<2>().norm();
  // Seen along the axis it is an ellipse, whose shorter half is the radius times this.
  const double upright = std::abs(ring.x.x() * ring.y.y() - ring.x.y() * ring.y.x());
  const double least_m =
      std::max({ring.radius_m * upright - aside_m, aside_m - ring.radius_m, 0.0});
  return {Eigen::Vector2d(ring.centre.z() - z_m, least_m),
          Eigen::Vector2d(ring.centre.z() + z_m, aside_m + ring.radius_m)};
}

bool TurnedSolid::IsBeyond(const Eigen::AlignedBox2d& cut_m, double distance_m) const {
  for (const Side& side : sides_) {
    const Eigen::Vector2d nearest(side.out.x() > 0.0 ? cut_m.min().x() : cut_m.max().x(),
                                  side.out.y() > 0.0 ? cut_m.min().y() : cut_m.max().y());
    if (side.out.dot(nearest) - side.offset_m >= distance_m) return true;
  }
  return false;
}

int FindNearPoints(const Ring& ring, const TurnedSolid& solid, double within_m, RingPoints& points,
                   bool all_round) {
  const double reach = ring.radius_m + within_m;
  const Eigen::Vector2d centre(ring.centre.z(), ring.centre.head<2>().norm());
  if (solid.NearestTo(centre).distance_m >= reach) return 0;
  // Between two samples the distance falls by less than half a step's way.
  const double worth = within_m + 0.5 * kSampleStep * ring.radius_m;
  if (solid.IsBeyond(CutOf(ring), worth + kRounding_m)) return 0;
  std::array<Probe, kSamples + 1> probes;
  double least = 1e9, most = -1e9;
  for (int i = 0; i < kSamples; ++i) {
    probes[i] = ProbeAt(ring, solid, SampleDirections()[i]);
    least = std::min(least, probes[i].point.distance_m);
    most = std::max(most, probes[i].point.distance_m);
    all_round &= !probes[i].on_flat_end;
  }
  if (least >= worth) return 0;
  probes[kSamples] = probes[0];
  probes[kSamples].point.angle_rad = 2.0 * kPi;
  const double tilt_m = ring.radius_m * ring.x.cross(ring.y).head<2>().norm();
  const double share = std::min(1.0, 1.0 / 3.0 + 2.0 / 3.0 * tilt_m / kTilted_m);
  int count = 0;
  for (int i = 0; i < kSamples && count < kMostRingPoints; ++i) {
    const Probe &a = probes[i], &b = probes[i + 1];
    if (!(a.slope_m < 0.0 && b.slope_m >= 0.0)) continue;
    if (std::min(a.point.distance_m, b.point.distance_m) >= worth) continue;
    const Probe least_here = Least(ring, solid, a, b);
    if (least_here.point.distance_m >= within_m) continue;
    points[count++] = least_here.point;
    if (!least_here.on_flat_end) continue;
    points[count - 1].share = share;
    for (double turn : {2.0 * kPi / 3.0, -2.0 * kPi / 3.0}) {
      const Probe beside = ProbeAt(ring, solid, Direction(least_here.point.angle_rad + turn));
      if (beside.point.distance_m < within_m && count < kMostRingPoints) {
        points[count++] = beside.point;
        if (beside.on_flat_end) points[count - 1].share = share;
      }
    }
  }
  if (all_round && ring.radius_m > 0.0 && most < within_m && (count == 1 || count == 2)) {
    return AddAllRound(ring, solid, (most - least) / within_m, count, points);
  }
  if (count == 0) {  // level on a flat end, or about the axis: near all round, nowhere nearest
    const Probe any = ProbeAt(ring, solid, Direction());
    if (any.point.distance_m >= within_m || std::abs(any.slope_m) > 1e-12) return 0;
    for (double turn : {0.0, 2.0 * kPi / 3.0, -2.0 * kPi / 3.0}) {
      const Probe probe = ProbeAt(ring, solid, Direction(turn));
      points[count++] = probe.point;
      if (probe.on_flat_end) points[count - 1].share = share;
      if (all_round) points[count - 1].share = 1.0 / 3.0;
      if (ring.radius_m == 0.0) break;
    }
  }
  return count;
}

}  // namespace dockyard
