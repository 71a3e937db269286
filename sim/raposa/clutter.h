// What else stands in the yard, in colours like the marks'. The camera sees it; nothing can run
// into it. So it stands clear of start, pyramid and the ways between them, and a robot that errs
// far from these drives through it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "controller/geometry/pose.h"
#include "render/scene.h"
#include "render/spectrum.h"
#include "sim/base/random.h"

namespace dockyard::raposa {

enum class ClutterShape : std::uint8_t { kBox, kCone, kBall };
enum class ClutterPaint : std::uint8_t { kBrick, kDenim, kConeOrange, kGrey };
inline constexpr int kClutterPaints = 4;

/// It stands on the ground.
struct ClutterPiece {
  ClutterShape shape = ClutterShape::kBox;
  ClutterPaint paint = ClutterPaint::kGrey;
  Pose2 X_DO;
  Eigen::Vector3d size_m{0, 0, 0};  // of a box; else diameter, diameter, height

  /// Of the circle round it, in plan.
  double radius_m() const;
};

/// How far it stays from robot, pyramid and the ways between them. Assumed, 0.4-1 m.
inline constexpr double kClutterClear_m = 0.5;

/// Up to `count` pieces within 3 m (assumed, 2-6) of the pyramid, from the seed's own stream; fewer
/// where there is no room. Every piece draws from the same numbers, whatever the others are.
/// @param X_DV      the camera at the start, x along its view
/// @param behind_m  of the ground behind the pyramid
std::vector<ClutterPiece> DrawClutter(int count, const Pose2& X_DV, double behind_m,
                                      const Seed& seed);

/// In the piece's frame: its foot's middle, z up.
RenderMesh ClutterMesh(const ClutterPiece& piece);
Spectrum ReflectanceOf(ClutterPaint paint);

}  // namespace dockyard::raposa
