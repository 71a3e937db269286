#include "sim/vehicles/part_contacts.h"

#include <cmath>

#include "controller/base/check.h"
#include "sim/rigid/plate_contacts.h"
#include "sim/vehicles/surface_points.h"
#include "sim/vehicles/wheel_contact.h"

namespace dockyard {
namespace {

// Numerical: a part at 0.1 m/s is searched for ten times a second.
constexpr double kNear_m = 0.01;
// More features than a pair of parts has.
constexpr int kMostFeatures = 1 << 20;
constexpr int kWheelCorners = 12;
// Of points on a part against a boulder, whose bumps are 50 mm wide and more; assumed, 20-50 mm.
constexpr double kPoints_m = 0.03;

}  // namespace

ConvexBody WheelHull(const WheelModel& wheel) {
  // The polygon holds the circle.
  const double radius_m = RollingRadius(wheel) / std::cos(kPi / kWheelCorners);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < kWheelCorners; ++i) {
    const double angle = 2.0 * kPi * i / kWheelCorners;
    for (const double side : {-0.5, 0.5}) {
      points.emplace_back(radius_m * std::cos(angle), side * wheel.width_m,
                          radius_m * std::sin(angle));
    }
  }
  return HullOf(points);
}

SolidPart BoulderPart(const StarBody& boulder_G, const PartGroups& groups) {
  SolidPart part{.star = std::make_shared<const StarBody>(boulder_G), .groups = groups};
  part.body_L.vertices = boulder_G.vertices;
  part.body_L.centre = boulder_G.centre;
  part.body_L.radius_m = boulder_G.radius_m;
  return part;
}

PartContacts::PartContacts(RigidWorld& world) : world_(world), near_(kNear_m) {}

int PartContacts::Add(const SolidPart& part) {
  X_GL_.push_back(part.at.body < 0 ? Pose3{} : world_.body(part.at.body).motion(part.at.link).X_GL);
  parts_.push_back(part);
  points_L_.emplace_back();
  return near_.Add(part.body_L, X_GL_.back(), part.groups);
}

void PartContacts::Place(int part, const Pose3& X_GL) {
  X_GL_[static_cast<std::size_t>(part)] = X_GL;
  near_.Place(part, X_GL);
}

void PartContacts::AddContacts() {
  for (int i = 0; i < count(); ++i) {
    const BodyLink& at = part(i).at;
    if (at.body >= 0) Place(i, world_.body(at.body).motion(at.link).X_GL);
  }
  met_.clear();
  for (const NearPair& pair : near_.Find()) {
    if (Moves(part(pair.a)) || Moves(part(pair.b))) AddPair(pair);
  }
}

void PartContacts::FindOnStar(const NearPair& pair, const Pose3& X_BA) {
  const SolidPart& a = part(pair.a);
  const StarBody& star = *part(pair.b).star;
  std::vector<Eigen::Vector3d>& points_L = points_L_[static_cast<std::size_t>(pair.a)];
  if (points_L.empty()) {
    points_L = a.wheel ? WheelPoints(*a.wheel, kPoints_m) : SurfacePoints(a.body_L, kPoints_m);
  }
  for (std::size_t i = 0; i < points_L.size(); ++i) {
    const Eigen::Vector3d p_B = X_BA * points_L[i];
    if ((p_B - star.centre).squaredNorm() > star.radius_m * star.radius_m) continue;
    const StarDepth at = DepthIn(star, p_B);
    if (at.depth_m <= 0.0) continue;
    found_.push_back({static_cast<int>(i), p_B, at.normal, at.depth_m, 1.0});
  }
}

// In the frame of the part that was added later, which is the stone where a tool meets one.
void PartContacts::AddPair(const NearPair& pair) {
  const SolidPart &a = part(pair.a), &b = part(pair.b);
  const Pose3& X_GB = X_GL_[static_cast<std::size_t>(pair.b)];
  const Pose3 X_BA = Inverse(X_GB) * X_GL_[static_cast<std::size_t>(pair.a)];
  found_.clear();
  if (b.star) {
    FindOnStar(pair, X_BA);
  } else if (a.wheel) {
    AddWheelContacts(b.body_L, *a.wheel, X_BA, found_);
  } else if (a.is_bar && b.is_bar) {
    AddHullContacts(b.body_L, X_BA * a.body_L, 0, found_);
  } else {
    AddPlateContacts(b.body_L, X_BA * a.body_L, found_);
  }
  for (const BodyContact& at : found_) {
    DOCKYARD_CHECK(at.feature >= 0 && at.feature < kMostFeatures);
    for (const BodyLink& link : {a.at, b.at}) {
      if (link.body >= 0 && world_.asleep(link.body)) world_.SetAsleep(link.body, false);
    }
    // A link may have several parts, and the ground has many.
    const std::int64_t surfaces = std::int64_t{pair.a} * count() + pair.b;
    const int number = world_.AddContact({.a = a.at,
                                          .b = b.at,
                                          .pair = surfaces * kMostFeatures + at.feature,
                                          .p_G = X_GB * at.p,
                                          .normal_G = X_GB.R * at.normal,
                                          .gap_m = -at.depth_m,
                                          .share = at.share,
                                          .material = a.material});
    met_.push_back({number, pair.a, pair.b});
  }
}

}  // namespace dockyard
