// The normal of a boulder's face as the mast's pictures give it.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "controller/base/number_text.h"
#include "controller/rocky7/face_stereo.h"
#include "rocky7/sim/test_scenario.h"
#include "sim/rocky7/rocky7_plant.h"
#include "sim/vehicles/boulder.h"

namespace dockyard::rocky7 {
namespace {

struct Face {
  double height_m = 0.33, up_deg = 30.0, turn_deg = 20.0;
};

// The normal of the plane by least squares through points of the surface on a disc about a point.
Eigen::Vector3d MeanNormal(const StarBody& body, const Eigen::Vector3d& centre,
                           const Eigen::Vector3d& axis, double radius_m) {
  const Eigen::Vector3d side = axis.unitOrthogonal(), up = axis.cross(side);
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (double x = -radius_m; x <= radius_m; x += 0.1 * radius_m) {
    for (double y = -radius_m; y <= radius_m; y += 0.1 * radius_m) {
      if (std::hypot(x, y) > radius_m) continue;
      const Eigen::Vector3d from = centre + x * side + y * up + body.radius_m * axis;
      const Eigen::Vector3d row(1.0, x, y);
      A += row * row.transpose();
      b += axis.dot(FirstOnRay(body, from, -axis).value() - centre) * row;
    }
  }
  const Eigen::Vector3d plane = A.ldlt().solve(b);
  return (axis - plane[1] * side - plane[2] * up).normalized();
}

struct Seen {
  double off_rad = 0.0;  // measured normal from the surface's, over a can's face
  double away_m = 0.0;   // measured point from the one that was clicked on
};

// An image pair of a face from so far, its middle to R; nominal cameras, the mast as it watches.
Seen LookAt(std::uint64_t seed, double from_m, const Face& face = {}) {
  Scenario scenario = OnGravel("{task: place, target_up_m: " + NumberText(face.height_m) +
                                   ", face_up_deg: " + NumberText(face.up_deg) +
                                   ", face_turn_deg: " + NumberText(face.turn_deg) + "}",
                               from_m, 5.0);
  scenario.seed = seed;
  BuiltRun built = BuildRun(scenario, LoadModels(scenario));
  built.mast_pair = built.world.robot.mast_pair.nominal;
  // The perception alone: cameras without video, joints without play.
  built.world.robot.mast_pair.sensor.video = {};
  for (MotorModel& motor : built.world.robot.rover.mast->motors) {
    motor.backlash_rad = motor.bend_nm_per_rad = 0.0;
  }
  Rocky7Plant plant(scenario, built, std::make_shared<KeptRenderer>());
  const Nominal& nominal = plant.built().nominal;
  const SensorFrame sensed = plant.Sense();
  std::vector<CameraImage> images = plant.TakeImages({kMastLeft, kMastRight}, 2.0);
  const StereoImages pair{std::get<GrayImage>(images[0].pixels),
                          std::get<GrayImage>(images[1].pixels)};
  const Truth& truth = plant.truth();
  const Pose3 X_ER = LevelFrame(nominal, sensed.imu);
  const Pose3 X_EG = X_ER * Inverse(truth.X_WR) * plant.X_WG();
  const Eigen::Vector3d p_ET = X_EG * plant.target_G();
  const FaceStereo stereo(nominal);
  const FaceView view = stereo.Look(pair, nominal.mast.watch_rad, sensed.imu, p_ET);
  const auto plane = stereo.PlaneAt(view, stereo.Rectified(nominal.target_px));
  EXPECT_TRUE(plane.has_value()) << seed;
  if (!plane) return {kPi, 1.0};
  const Eigen::Vector3d face_G =
      FaceNormal({.face_up_rad = Radians(face.up_deg), .face_turn_rad = Radians(face.turn_deg)});
  const Eigen::Vector3d surface_G =
      MeanNormal(*plant.built().world.boulder, plant.target_G(), face_G, 0.033);
  const double along = plane->normal.dot(X_EG.R * surface_G);
  return {std::acos(std::clamp(along, -1.0, 1.0)), (plane->p - p_ET).norm()};
}

// Each seed has its own stains, pebbles and noise.
TEST(Rocky7FaceView, TheNormalIsThatOfTheSurfaceWhateverItsTexture) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const Seen seen = LookAt(seed, 2.2);
    EXPECT_LT(Degrees(seen.off_rad), 2.0) << seed;
    EXPECT_LT(seen.away_m, 0.012) << seed;
  }
}

TEST(Rocky7FaceView, TheNormalFollowsTheFace) {
  for (const Face face : {Face{0.5, 5.0, -20.0}, Face{0.4, 15.0, 35.0}, Face{0.27, 40.0, 0.0}}) {
    const Seen seen = LookAt(7, 2.2, face);
    EXPECT_LT(Degrees(seen.off_rad), 2.0) << face.up_deg;
    EXPECT_LT(seen.away_m, 0.012) << face.up_deg;
  }
}

}  // namespace
}  // namespace dockyard::rocky7
