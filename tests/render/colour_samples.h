// A scene for colour cameras: an orange ball and, behind it, an upright blue square.
#pragma once

#include "render/colour_sensor.h"
#include "render/scene_samples.h"

namespace dockyard {

RenderMesh BallToRender(double radius_m, int sides = 48);  // at the origin

/// Materials of the scene, by index.
enum Paint { kGreyFloor, kOrange, kBlue, kBlack, kWhite };

/// 320 x 240, f 377 px, behind a hole of 12.5 deg to all sides.
ColourView MarksView();

inline constexpr double kBallRadius_m = 0.015, kSquareSide_m = 0.06, kSquareBehind_m = 0.098;

/// Owns the heights that its scene points to.
struct MarksScene {
  std::vector<double> heights_m = std::vector<double>(9, 0.0);
  SceneSpectra spectra;
  Scene scene;
  Pose3 X_WC;  // level, 0.1 m high, looking along x at the ball from distance_m
};
/// Of a plain grey floor, sky and sun of one colour.
std::unique_ptr<MarksScene> MarksAt(double distance_m, const Spectrum& light,
                                    bool with_floor = true);

}  // namespace dockyard
