// The conditions on a scene that can be drawn.
#include <cmath>
#include <stdexcept>
#include <string>

#include "render/scene_painter.h"

namespace dockyard {
namespace {

void Require(bool good, const std::string& what) {
  if (!good) throw std::invalid_argument("scene: " + what);
}

void RequirePose(const Pose3& X, const std::string& whose) {
  const double off = (X.R.transpose() * X.R - Eigen::Matrix3d::Identity()).norm();
  Require(X.p.allFinite() && off < 1e-6, whose + " pose is not a rigid transform");
}

void RequireLight(const SunAndSky& light) {
  Require(std::abs(light.to_sun_W.norm() - 1.0) < 1e-6, "to_sun_W must be a unit vector");
  Require(light.sun_irradiance >= 0.0 && light.sky_irradiance >= 0.0 &&
              light.ground_bounce_albedo >= 0.0,
          "light must not be negative");
  Require(light.sun_rgb.minCoeff() >= 0.0 && light.sky_rgb.minCoeff() >= 0.0,
          "no colour of light may be negative");
  Require(light.sun_angular_diameter_rad >= 0.0 && light.sun_angular_diameter_rad < 0.2,
          "the sun's diameter must lie in 0 to 0.2 rad");
}

void RequireTether(const TetherView& tether) {
  for (const Eigen::Vector3d& p : tether.points_W) {
    Require(p.allFinite(), "a point of the tether is not finite");
  }
  Require(tether.diameter_m >= 0.0, "the tether's diameter must not be negative");
}

void RequireLamp(const Lamp& lamp) {
  Require(lamp.p_W.allFinite(), "a lamp's place is not finite");
  Require(std::abs(lamp.axis_W.norm() - 1.0) < 1e-6, "a lamp's axis must be a unit vector");
  Require(lamp.half_angle_rad >= 0.0 && lamp.half_angle_rad < 0.5 * kPi,
          "a lamp's half angle must lie in 0 to 90 deg");
  Require(lamp.irradiance_1m >= 0.0 && std::isfinite(lamp.irradiance_1m),
          "a lamp's light must not be negative");
}

void RequireBoard(const BoardView& view) {
  const FiducialBoard& board = view.board;
  Require(
      board.width_m > 0.0 && board.height_m > 0.0 && board.width_m < 10.0 && board.height_m < 10.0,
      "a board's sides must be longer than 0 and shorter than 10 m");
  for (const Fiducial& f : board.fiducials) {
    Require(f.p_BF.allFinite() && std::isfinite(f.rotation), "a fiducial is not finite");
  }
  for (const DustySpot& spot : view.dusty_spots) {
    Require(spot.p_B.allFinite() && spot.radius_m >= 0.0 && spot.cover >= 0.0 && spot.cover <= 0.95,
            "dust must cover 0 to 0.95 of a spot");
  }
  Require(view.dust_cover >= 0.0 && view.dust_cover <= 0.6,
          "dust must cover 0 to 0.6 of the board");
  RequirePose(view.X_WB, "the board's");
}

}  // namespace

std::vector<const TetherView*> ThinBodies(const Scene& scene) {
  std::vector<const TetherView*> bodies{&scene.tether};
  for (const TetherView& cable : scene.cables) bodies.push_back(&cable);
  return bodies;
}

void RequireSoundScene(const Scene& scene) {
  Require(scene.objects.size() <= static_cast<std::size_t>(kMaxObjects),
          "at most " + std::to_string(kMaxObjects) + " objects can be drawn");
  for (const SceneObject& object : scene.objects) {
    Require(object.mesh != nullptr, "an object has no mesh");
    RequirePose(object.X_WO, "an object's");
    Require(object.albedo.allFinite(), "an albedo is not finite");
    const Stains& stains = object.stains;
    Require(stains.contrast >= 0.0 && stains.contrast <= 0.5,
            "stains must have a contrast of 0 to 0.5");
    Require(stains.least_m >= 1e-4 && stains.largest_m >= stains.least_m && stains.largest_m <= 10,
            "stains must have sizes of 0.1 mm to 10 m, the largest no less than the least");
  }
  for (const TetherView* tether : ThinBodies(scene)) RequireTether(*tether);
  for (const Lamp& lamp : scene.lamps) RequireLamp(lamp);
  if (scene.interest) {
    Require(scene.interest->p_W.allFinite() && scene.interest->radius_m > 0.0,
            "a point of interest needs a place and a radius");
  }
  RequireLight(scene.light);
  for (const BoardView& board : scene.boards) RequireBoard(board);
  Require(scene.ground.grain >= 0.0 && scene.ground.grain <= 1.0,
          "the ground's grain must lie in 0 to 1");
  Require(scene.ground.largest_pebble_m >= 0.0, "a pebble's size must not be negative");
  RequireSoundGround(scene.ground);
  if (HasGround(scene.ground)) RequirePose(scene.ground.X_WG, "the ground's");
}

}  // namespace dockyard
