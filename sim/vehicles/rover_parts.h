// A rover's convex parts, for contacts with what it meets.
#pragma once

#include <vector>

#include "models/parts/rover_model.h"
#include "sim/vehicles/part_contacts.h"
#include "sim/vehicles/wheeled_body.h"

namespace dockyard {

/// Bits of groups: which of a rover's parts meet each other, and the stones.
namespace part_group {
inline constexpr int kWheels = 1, kChassis = 2, kArm = 4, kMast = 8;
inline constexpr int kBeddedStones = 16, kLooseStones = 32;
inline constexpr int kStones = kBeddedStones | kLooseStones;
inline constexpr int kRover = kWheels | kChassis | kArm | kMast;
}  // namespace part_group

/// Of the plate that covers the body's outline, on its box; assumed, 5-20 mm.
inline constexpr double kPanel_m = 0.01;

/// Wheels; the body's box and its panel, rockers and bogies as bars; the arm's bar and its scoops'
/// plates; the mast's bars and its can short of the face. They meet stones, and the mast meets the
/// body and the arm. friction: of all of them.
void AddRoverParts(const RoverModel& rover, const WheeledBody& body, double friction,
                   PartContacts& parts);

/// A box about a point, with the axes of its frame.
ConvexBody BoxAt(const Eigen::Vector3d& centre, const Eigen::Vector3d& size_m);
/// A square bar from one point to another.
ConvexBody BarBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double thick_m);

}  // namespace dockyard
