#include "sim/vehicles/tyres.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "controller/base/check.h"
#include "sim/vehicles/ground_plane.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

const double kGaussShare = 1.0 / std::sqrt(3.0);
// Sine of the axle's tilt at which the two points begin to move to the tread's edges, and at which
// they are there: a tilted wheel rests on an edge. Numerical.
constexpr double kEven = 0.02, kOnEdge = 0.1;
// From this sine on a wheel counts as tipped over: it may touch by more points of its edge.
constexpr double kTipped = 0.5;
// A contact's share of Coulomb's limit from which it counts as sliding. Numerical.
constexpr double kSliding = 1.0 - 1e-6;
constexpr int kMostTyrePoints = 5;

/// The directions of a wheel on a surface.
struct WheelAxes {
  Vector3d axle_G, ahead_G, down_G;  // down: in the wheel's plane, to the surface
  double tilt = 0.0;                 // sine of the axle's

  WheelAxes(const Vector3d& axle, const Vector3d& normal_G)
      : axle_G(axle), tilt(axle.dot(normal_G)) {
    const double level = std::sqrt(std::max(0.0, 1.0 - tilt * tilt));
    // An axle along the normal: any direction is as low.
    ahead_G =
        level > 1e-6 ? Vector3d(axle.cross(normal_G) / level) : Vector3d(axle.unitOrthogonal());
    down_G = axle.cross(ahead_G);
    if (down_G.dot(normal_G) > 0.0) down_G = -down_G;
  }
};

// How far the two points are from the middle of the width, as a share of half of it.
double ShareOut(double tilt) {
  const double share = std::clamp((std::abs(tilt) - kEven) / (kOnEdge - kEven), 0.0, 1.0);
  return kGaussShare + share * (1.0 - kGaussShare);
}

/// A point of the tread that may touch.
struct TreadPoint {
  Vector3d from_K, p_G, normal_G;
  double gap_m;
  int number;
};

// The points, from the centre in G; returns how many.
int PointsOf(const TyreModel& tyre, const Vector3d& axle_G, const Vector3d& normal_G,
             TreadPoint* points) {
  if (tyre.ball) {
    points[0].from_K = -tyre.radius_m * normal_G;
    return 1;
  }
  const WheelAxes axes(axle_G, normal_G);
  const Vector3d down = tyre.radius_m * axes.down_G, ahead = tyre.radius_m * axes.ahead_G;
  if (tyre.width_m == 0.0) {
    points[0].from_K = down;
    return 1;
  }
  const double half_m = 0.5 * tyre.width_m;
  const Vector3d out = half_m * ShareOut(axes.tilt) * axle_G;
  points[0].from_K = down - out;
  points[1].from_K = down + out;
  if (std::abs(axes.tilt) < kTipped) return 2;
  const Vector3d low = (axes.tilt > 0.0 ? -half_m : half_m) * axle_G;
  points[2].from_K = low + ahead;
  points[3].from_K = low - ahead;
  points[4].from_K = low - down;
  return kMostTyrePoints;
}

ContactMaterial MaterialOf(const TyreModel& tyre, const FloorModel& floor) {
  ContactMaterial material =
      MaterialOn(floor, tyre.stiffness_n_per_m, tyre.damping_ns_per_m, tyre.grip);
  const double rolling_m = tyre.rolling_resistance_m + floor.rolling_resistance_m;
  if (tyre.ball) {
    material.friction += rolling_m / tyre.radius_m;
  } else {
    material.rolling_resistance_m = rolling_m;
  }
  return material;
}

}  // namespace

double TyreTruth::slip() const {
  const double forward_m_s = rolling_m_s + along_m_s;  // of the axle
  const double faster_m_s =
      std::abs(rolling_m_s) >= std::abs(forward_m_s) ? rolling_m_s : forward_m_s;
  return faster_m_s == 0.0 ? 0.0 : -along_m_s / faster_m_s;
}

Tyres::Tyres(RigidWorld& world, const FirmGround& ground, int body, std::vector<Tyre> tyres)
    : world_(world), ground_(ground), body_(body) {
  DOCKYARD_CHECK(!ground.floors.empty());
  for (Tyre& tyre : tyres) {
    DOCKYARD_CHECK(tyre.model.radius_m > 0.0);
    Wheel& wheel = wheels_.emplace_back();
    for (const FloorModel& floor : ground.floors) {
      wheel.on.push_back(MaterialOf(tyre.model, floor));
    }
    wheel.tyre = std::move(tyre);
  }
}

void Tyres::AddContacts(double step_s) {
  for (std::size_t i = 0; i < wheels_.size(); ++i) AddContactsOf(wheels_[i], i, step_s);
}

void Tyres::AddContactsOf(Wheel& wheel, std::size_t number, double step_s) {
  const Tyre& tyre = wheel.tyre;
  const TyreModel& model = tyre.model;
  const LinkMotion& motion = world_.body(body_).motion(tyre.link);
  const GroundPlane ground(ground_.heights);
  const Vector3d p_GK = motion.X_GL * tyre.p_LK, axle_G = motion.X_GL.R * tyre.axle_L;
  TreadPoint points[kMostTyrePoints];
  const int count = PointsOf(model, axle_G, ground.At(p_GK.x(), p_GK.y()).Normal(), points);
  int near = 0;
  for (int i = 0; i < count; ++i) {
    TreadPoint& point = points[near];
    point.p_G = p_GK + points[i].from_K;
    point.number = i;
    const GroundSpot spot = ground.At(point.p_G.x(), point.p_G.y());
    point.normal_G = spot.Normal();
    point.gap_m = (point.p_G.z() - spot.height_m) * point.normal_G.z();
    const double closing_m_s = -motion.VelocityAt(point.p_G).dot(point.normal_G);
    if (point.gap_m <= ContactReach(std::max(0.0, closing_m_s), step_s)) ++near;
  }
  // A rolling wheel's bend fades by how far it rolls over the relaxation: Euler's step of
  // tyre.h's law, whose steady slip it has exactly.
  const double rolled_m =
      model.ball ? 0.0 : step_s * model.radius_m * std::abs(axle_G.dot(motion.w_GL_G));
  WorldContact contact;
  contact.a = {body_, tyre.link};
  contact.share = count == 1 ? 1.0 : 0.5;
  contact.bend_kept = std::max(0.0, 1.0 - rolled_m / model.relaxation_m);
  wheel.contacts = near;
  for (int i = 0; i < near; ++i) {
    contact.p_G = points[i].p_G;
    contact.normal_G = points[i].normal_G;
    contact.gap_m = points[i].gap_m;
    contact.pair =
        kTyrePairs + static_cast<std::int64_t>(number) * kMostTyrePoints + points[i].number;
    contact.material = wheel.on[std::min(ground_.heights.SoilAt(contact.p_G), wheel.on.size() - 1)];
    // One row of the wheel resists its rolling, by the load of all its contacts.
    if (i + 1 < near) contact.material.rolling_resistance_m = 0.0;
    contact.rolling_contacts = i + 1;
    const int at = world_.AddContact(contact);
    if (i == 0) wheel.first = at;
  }
}

TyreTruth Tyres::truth(int i, double step_s) const {
  const Wheel& wheel = wheels_[static_cast<std::size_t>(i)];
  const LinkMotion& motion = world_.body(body_).motion(wheel.tyre.link);
  const Vector3d axle_G = motion.X_GL.R * wheel.tyre.axle_L;
  TyreTruth truth;
  truth.rolling_m_s = wheel.tyre.model.radius_m * axle_G.dot(motion.w_GL_G);
  for (int k = 0; k < wheel.contacts; ++k) {
    const WorldContact& contact = world_.contacts()[static_cast<std::size_t>(wheel.first + k)];
    const WheelAxes axes(axle_G, contact.normal_G);
    const Vector3d left_G = contact.normal_G.cross(axes.ahead_G);
    const double load_n = contact.impulse_G.dot(contact.normal_G) / step_s;
    const Vector3d along_G = contact.impulse_G / step_s - load_n * contact.normal_G;
    const Vector3d v_G = motion.VelocityAt(contact.p_G);
    truth.load_n += load_n;
    truth.along_n += along_G.dot(axes.ahead_G);
    truth.across_n += along_G.dot(left_G);
    truth.along_m_s += v_G.dot(axes.ahead_G) / wheel.contacts;
    truth.across_m_s += v_G.dot(left_G) / wheel.contacts;
    truth.slides |= load_n > 0.0 && along_G.norm() >= kSliding * contact.material.friction * load_n;
  }
  return truth;
}

}  // namespace dockyard
