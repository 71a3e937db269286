#include "sim/vehicles/own_contacts.h"

#include <cmath>

#include "sim/vehicles/rover_parts.h"

namespace dockyard {
namespace {

constexpr int kSides = 16;
constexpr int kMostPoints = 50;

// A ring of corners about z whose polygon holds the circle.
void AddRing(const Pose3& X_LG, double radius_m, double z_m, std::vector<Eigen::Vector3d>& points) {
  const double corner_m = radius_m / std::cos(kPi / kSides);
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * kPi * i / kSides;
    points.push_back(X_LG *
                     Eigen::Vector3d(corner_m * std::cos(angle), corner_m * std::sin(angle), z_m));
  }
}

// The points that lie furthest out in directions spread evenly over the sphere (Fibonacci).
std::vector<Eigen::Vector3d> Outermost(const std::vector<Eigen::Vector3d>& points) {
  if (points.size() <= kMostPoints) return points;
  std::vector<bool> taken(points.size(), false);
  std::vector<Eigen::Vector3d> outermost;
  for (int i = 0; i < kMostPoints; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kMostPoints, turn = kPi * (3.0 - std::sqrt(5.0)) * i;
    const double across = std::sqrt(1.0 - z * z);
    const Eigen::Vector3d out(across * std::cos(turn), across * std::sin(turn), z);
    std::size_t best = 0;
    for (std::size_t k = 1; k < points.size(); ++k) {
      if (points[k].dot(out) > points[best].dot(out)) best = k;
    }
    if (!taken[best]) outermost.push_back(points[best]);
    taken[best] = true;
  }
  return outermost;
}

// By the link's number.
int Bit(int link) { return 1 << link; }

// The links that each one does not meet, as bits.
std::vector<int> JoinedTo(const JointedLinks& further, const std::vector<LinkParts>& parts) {
  const std::size_t count = parts.size();
  std::vector<int> joined(count, 0);
  const auto join = [&](int a, int b) {
    joined[static_cast<std::size_t>(a)] |= Bit(b);
    joined[static_cast<std::size_t>(b)] |= Bit(a);
  };
  const int own = static_cast<int>(count - further.links.size());
  for (int i = 0; i < own; ++i) {
    for (int k = 0; k <= i; ++k) join(i, k);  // a system finds contacts of its own links itself
  }
  for (int i = own; i < static_cast<int>(count); ++i) {
    join(i, i);
    for (int at = i; at >= own;) {
      at = further.links[static_cast<std::size_t>(at - own)].carrier;
      join(i, at);
      if (!parts[static_cast<std::size_t>(at)].collisions.empty()) break;
    }
  }
  for (const LinkPin& pin : further.pins) join(pin.a, pin.b);
  return joined;
}

}  // namespace

ConvexBody SolidOf(const Collision& collision) {
  const Pose3& X = collision.X_LG;
  std::vector<Eigen::Vector3d> points;
  if (const auto* box = std::get_if<BoxShape>(&collision.shape)) {
    return X * BoxAt(Eigen::Vector3d::Zero(), box->size_m);
  }
  if (const auto* cylinder = std::get_if<CylinderShape>(&collision.shape)) {
    for (const double end : {-0.5, 0.5}) {
      AddRing(X, cylinder->radius_m, end * cylinder->length_m, points);
    }
  } else if (const auto* sphere = std::get_if<SphereShape>(&collision.shape)) {
    // The corners of a polygon of 12 sides about the ball, turned about z.
    const double corner_m = sphere->radius_m / std::cos(kPi / 12.0);
    for (const double up : {-75.0, -45.0, -15.0, 15.0, 45.0, 75.0}) {
      AddRing(X, corner_m * std::cos(Radians(up)), corner_m * std::sin(Radians(up)), points);
    }
  } else if (const auto* hull = std::get_if<HullShape>(&collision.shape)) {
    for (const Eigen::Vector3d& p : Outermost(hull->points)) points.push_back(X * p);
  } else if (const auto* turned = std::get_if<TurnedShape>(&collision.shape)) {
    for (const Eigen::Vector2d& ring : turned->profile_m) AddRing(X, ring.y(), ring.x(), points);
  }
  return HullOf(points);
}

OwnContacts::OwnContacts(RigidWorld& world, int body, const JointedLinks& further,
                         const TreePlaces& places, const std::vector<LinkParts>& parts)
    : world_(world), contacts_(world) {
  const std::vector<int> joined = JoinedTo(further, parts);
  const auto add = [&](std::size_t link, SolidPart part) {
    part.at = {body, places[link]};
    part.is_bar = true;
    part.material = further.contact;
    part.groups = {Bit(static_cast<int>(link)), ~joined[link]};
    contacts_.Add(part);
    link_of_.push_back(static_cast<int>(link));
  };
  // Wheels first: they meet parts that are added later.
  for (const bool wheels : {true, false}) {
    for (std::size_t link = 0; link < parts.size(); ++link) {
      if (parts[link].wheel && wheels) {
        add(link, {.body_L = WheelHull(*parts[link].wheel), .wheel = parts[link].wheel});
      }
      if (parts[link].wheel || wheels) continue;
      for (const Collision& part : parts[link].collisions) add(link, {.body_L = SolidOf(part)});
    }
  }
}

std::optional<std::pair<int, int>> OwnContacts::FindOverlap(double depth_m) {
  contacts_.AddContacts();
  world_.TakeLoads(1e-9);
  world_.Resist(1e-9);
  for (const PartContacts::Met& met : contacts_.met()) {
    const WorldContact& contact = world_.contacts()[static_cast<std::size_t>(met.contact)];
    if (contact.gap_m > -depth_m) continue;
    return std::pair(link_of_[static_cast<std::size_t>(met.a)],
                     link_of_[static_cast<std::size_t>(met.b)]);
  }
  return std::nullopt;
}

}  // namespace dockyard
