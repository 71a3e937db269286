#include "sim/vehicles/floor_contacts.h"

#include <algorithm>
#include <utility>

#include "controller/base/check.h"
#include "sim/vehicles/ground_plane.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

double LargestOf(const HeightGrid& grid) {
  return *std::max_element(grid.heights_m.begin(), grid.heights_m.end());
}

}  // namespace

void FloorContacts::Add(FloorPart part) {
  DOCKYARD_CHECK(!ground_.floors.empty());
  Part& added = parts_.emplace_back();
  for (const FloorModel& floor : ground_.floors) {
    added.on.push_back(MaterialOn(floor, part.stiffness_n_per_m, part.damping_ns_per_m, part.grip));
  }
  added.pair = kFloorPairs + corners_;
  corners_ += static_cast<std::int64_t>(part.body_L.vertices.size());
  added.part = std::move(part);
  highest_m_ = LargestOf(ground_.heights);
}

void FloorContacts::AddContacts(double step_s) {
  const GroundPlane ground(ground_.heights);
  for (Part& each : parts_) {
    each.contacts = 0;
    const FloorPart& part = each.part;
    const LinkMotion& motion = world_.body(part.at.body).motion(part.at.link);
    const ConvexBody& body_L = part.body_L;
    const Vector3d centre_G = motion.X_GL * body_L.centre;
    const double speed_m_s =
        motion.VelocityAt(centre_G).norm() + body_L.radius_m * motion.w_GL_G.norm();
    const double reach_m = ContactReach(speed_m_s, step_s);
    if (centre_G.z() - body_L.radius_m > highest_m_ + reach_m) continue;
    for (std::size_t i = 0; i < body_L.vertices.size(); ++i) {
      WorldContact contact;
      contact.p_G = motion.X_GL * body_L.vertices[i];
      if (contact.p_G.z() > highest_m_ + reach_m) continue;
      const GroundSpot spot = ground.At(contact.p_G.x(), contact.p_G.y());
      contact.normal_G = spot.Normal();
      contact.gap_m = (contact.p_G.z() - spot.height_m) * contact.normal_G.z();
      if (contact.gap_m > reach_m) continue;
      contact.a = part.at;
      contact.pair = each.pair + static_cast<std::int64_t>(i);
      contact.material = each.on[std::min(ground_.heights.SoilAt(contact.p_G), each.on.size() - 1)];
      const int at = world_.AddContact(contact);
      if (each.contacts++ == 0) each.first = at;
    }
  }
}

Vector3d FloorContacts::Force(int part, double step_s) const {
  const Part& each = parts_[static_cast<std::size_t>(part)];
  Vector3d impulse_G = Vector3d::Zero();
  for (int k = 0; k < each.contacts; ++k) {
    impulse_G += world_.contacts()[static_cast<std::size_t>(each.first + k)].impulse_G;
  }
  return impulse_G / step_s;
}

}  // namespace dockyard
