// Rocks: how many of which size lie on the ground, what shape they have, and where they are.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "models/parts/rock_field.h"
#include "sim/rigid/convex_body.h"

namespace dockyard {

/// Rocks per square metre between two diameters, each of the area of its circle.
double RocksPerArea(double cover, double least_m, double largest_m);

/// A rock without its place.
struct RockSize {
  double diameter_m = 0.0;  // mean of its length and its width
  double height_m = 0.0;    // above the ground
};

/// A rock that stands in the ground z = 0, its length and width centred on the origin: the hull of
/// points on an ellipsoid whose top and bottom are cut flat. Same key, same shape.
/// tilt_rad: of its flat top before it is scaled to its height.
ConvexBody RockShape(const RockSize& size, double buried, double tilt_rad, std::uint64_t key);

struct Rock {
  Eigen::Vector2d p_D{0, 0};
  RockSize size;
  bool given = false;
  ConvexBody body;  // in D, on the ground z = 0
};

/// A part of the ground, in D.
struct GroundArea {
  double x_from_m = 0.0, x_to_m = 0.0, y_from_m = 0.0, y_to_m = 0.0;
};

/// The given rocks, then those of the field: as many as a Poisson process has on the area, at
/// places that are uniform but for overlaps, which are drawn anew, the largest rocks first. Those
/// that reach into a clear circle are taken away, which leaves the others as dense as before.
/// Throws std::length_error for more than `kMostRocks`, and when they do not fit.
std::vector<Rock> PlaceRocks(const RockField& field, const GroundArea& area,
                             const std::vector<Eigen::Vector2d>& clear_D, std::uint64_t key);
inline constexpr int kMostRocks = 5000;

}  // namespace dockyard
