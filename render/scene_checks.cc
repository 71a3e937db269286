// The conditions on a scene that can be drawn.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "controller/base/check.h"
#include "render/scene_painter.h"
#include "render/stray_light.h"

namespace dockyard {
namespace {

void Require(bool good, const std::string& what) {
  if (!good) throw std::invalid_argument("scene: " + what);
}

void RequirePose(const Pose3& X, const std::string& whose) {
  const double off = (X.R.transpose() * X.R - Eigen::Matrix3d::Identity()).norm();
  Require(X.p.allFinite() && off < 1e-6, whose + " pose is not a rigid transform");
}

void CheckLight(const SunAndSky& light) {
  DOCKYARD_CHECK(std::abs(light.to_sun_W.norm() - 1.0) < 1e-6);
  DOCKYARD_CHECK(light.sun_irradiance >= 0.0 && light.sky_irradiance >= 0.0);
  DOCKYARD_CHECK(light.ground_bounce_albedo >= 0.0);
  DOCKYARD_CHECK(light.sun_rgb.minCoeff() >= 0.0 && light.sky_rgb.minCoeff() >= 0.0);
  DOCKYARD_CHECK(light.sun_angular_diameter_rad >= 0.0 && light.sun_angular_diameter_rad < 0.2);
  CheckStray(light.stray);
}

void CheckObject(const SceneObject& object) {
  DOCKYARD_CHECK(object.mesh != nullptr);
  DOCKYARD_CHECK(object.albedo.allFinite());
  const Stains& stains = object.stains;
  DOCKYARD_CHECK(stains.contrast >= 0.0 && stains.contrast <= 0.5);
  DOCKYARD_CHECK(stains.least_m >= 1e-4 && stains.largest_m >= stains.least_m &&
                 stains.largest_m <= 10.0);
  RequirePose(object.X_WO, "an object's");
}

void CheckThinBody(const TetherView& body) {
  DOCKYARD_CHECK(body.diameter_m >= 0.0);
  for (const Eigen::Vector3d& p : body.points_W) {
    Require(p.allFinite(), "a point of the tether is not finite");
  }
}

void CheckLamp(const Lamp& lamp) {
  Require(lamp.p_W.allFinite(), "a lamp's place is not finite");
  DOCKYARD_CHECK(std::abs(lamp.axis_W.norm() - 1.0) < 1e-6);
  DOCKYARD_CHECK(lamp.half_angle_rad >= 0.0 && lamp.half_angle_rad < 0.5 * kPi);
  DOCKYARD_CHECK(lamp.irradiance_1m >= 0.0 && std::isfinite(lamp.irradiance_1m));
}

void CheckBoard(const BoardView& view) {
  const FiducialBoard& board = view.board;
  DOCKYARD_CHECK(board.width_m > 0.0 && board.width_m < 10.0);
  DOCKYARD_CHECK(board.height_m > 0.0 && board.height_m < 10.0);
  for (const Fiducial& f : board.fiducials) {
    DOCKYARD_CHECK(f.p_BF.allFinite() && std::isfinite(f.rotation));
  }
  for (const DustySpot& spot : view.dusty_spots) {
    DOCKYARD_CHECK(spot.p_B.allFinite() && spot.radius_m >= 0.0);
    DOCKYARD_CHECK(spot.cover >= 0.0 && spot.cover <= 0.95);
  }
  for (const SquareTag& tag : board.tags) {
    DOCKYARD_CHECK(tag.p_BT.allFinite() && std::isfinite(tag.rotation));
    DOCKYARD_CHECK(tag.size_m > 0.0 && tag.cells.at_border > 0);
    DOCKYARD_CHECK(tag.cells.black.size() ==
                   static_cast<std::size_t>(tag.cells.across * tag.cells.across));
  }
  DOCKYARD_CHECK(board.tags.empty() || board.fiducials.empty());
  DOCKYARD_CHECK(view.dust_cover >= 0.0 && view.dust_cover <= 0.6);
  DOCKYARD_CHECK(view.wear >= 0.0 && view.wear <= 0.95);
  constexpr double kMostBow = 0.1;  // of the plate's smaller side
  DOCKYARD_CHECK(std::isfinite(view.bow_rad) &&
                 std::abs(view.flatness_m) <=
                     kMostBow * std::min(board.width_m, board.height_m) + 1e-9);
  DOCKYARD_CHECK(view.flatness_m == 0.0 || view.hole_radius_m <= 0.0);
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
  for (const SceneObject& object : scene.objects) CheckObject(object);
  for (const TetherView* body : ThinBodies(scene)) CheckThinBody(*body);
  for (const Lamp& lamp : scene.lamps) CheckLamp(lamp);
  if (scene.interest) {
    DOCKYARD_CHECK(scene.interest->p_W.allFinite() && scene.interest->radius_m > 0.0);
  }
  CheckLight(scene.light);
  for (const BoardView& board : scene.boards) CheckBoard(board);
  DOCKYARD_CHECK(scene.ground.grain >= 0.0 && scene.ground.grain <= 1.0);
  DOCKYARD_CHECK(scene.ground.largest_pebble_m >= 0.0);
  RequireSoundGround(scene.ground);
  if (HasGround(scene.ground)) RequirePose(scene.ground.X_WG, "the ground's");
}

}  // namespace dockyard
