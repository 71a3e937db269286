#include "sim/spectator/near_view.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sim/plant/renderer.h"
#include "sim/spectator/outside_view.h"
#include "sim/spectator/viewpoint.h"
#include "spectator/some_run.h"

namespace dockyard {
namespace {

constexpr double kFov_rad = 0.55;
const Aim kTarget{"target", std::nullopt};

/// The robot comes to a target of 0.1 m at the origin. Sample by sample: far, near, at it.
LoggedRun Coming() {
  LoggedRun run = SomeRun();
  run.times_s = {0.0, 0.1, 0.2};
  run.X_WG.resize(3);
  run.X_WD.resize(3);
  run.X_WO = {{Pose3::Translation(3.0, 0.0, 0.2), Pose3::Translation(1.0, 0.0, 0.2),
               Pose3::Translation(0.4, 0.0, 0.2)},
              {Pose3{}, Pose3{}, Pose3{}}};
  return run;
}

void AddBox(StageBody& body, const Eigen::Vector3d& middle, const Eigen::Vector3d& size) {
  auto mesh = std::make_shared<RenderMesh>(*Box(1.0));
  for (Eigen::Vector3f& vertex : mesh->vertices) {
    vertex = (vertex.cast<double>().cwiseProduct(size) + middle).cast<float>();
  }
  body.parts.push_back({mesh, {}, {0.8, 0.02, 0.02}});
}

/// A small blue target, whose point is near its top; the robot's parts are red.
StageShapes Small() {
  StageShapes shapes = SomeShapes();
  shapes.bodies[1].parts = {{Box(0.1), Pose3::Translation(0.0, 0.0, 0.05), {0.02, 0.02, 0.8}}};
  shapes.points = {{"target", "target", {0.0, 0.0, 0.08}}};
  return shapes;
}

/// The robot has walls to both sides of the target once it is there, up to 0.5 m; beyond them there
/// are the directions that a spectator has usually.
StageShapes BetweenWalls() {
  StageShapes shapes = Small();
  for (const double side : {-1.0, 1.0}) {
    AddBox(shapes.bodies[0], {-0.15, 0.25 * side, 0.1}, {0.7, 0.02, 0.6});
  }
  return shapes;
}

enum class Hue { kOther, kRed, kBlue };

Hue HueAt(const RgbImage& image, int x, int y) {
  const std::uint8_t* p = &image.pixels[3 * (static_cast<std::size_t>(y) * image.width + x)];
  if (p[0] > 2 * p[1] && p[0] > 2 * p[2]) return Hue::kRed;
  return p[2] > 2 * p[0] && p[2] > 2 * p[1] ? Hue::kBlue : Hue::kOther;
}

int BlueIn(const RgbImage& image) {
  int count = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) count += HueAt(image, x, y) == Hue::kBlue;
  }
  return count;
}

// In drawn images: the target is in their middle, and hidden from the usual direction.
TEST(NearView, ShowsATargetThatTheRobotHidesFromTheUsualDirection) {
  const LoggedRun run = Coming();
  const StageShapes shapes = BetweenWalls();
  const auto renderer = MakeRenderer();
  OutsideOptions options{.width = 320, .height = 180, .at = kTarget};
  OutsideView near(run, shapes, options, 0, 2, *renderer);
  near.Image(0);
  near.Image(1);
  const RgbImage image = near.Image(2);
  EXPECT_EQ(HueAt(image, 160, 86), Hue::kBlue);
  EXPECT_GT(BlueIn(image), 300);
  const NearView view = FindNearView(run, shapes, kTarget, 0, 2, kFov_rad);
  const Eigen::Vector3d usual = UsualDirection(0.0, shapes.light.to_sun_W);
  options.from_D = view.at_W + (view.from_W - view.at_W).norm() * usual;
  OutsideView hidden(run, shapes, options, 0, 2, *renderer);
  EXPECT_EQ(BlueIn(hidden.Image(2)), 0);
}

TEST(NearView, IsTheUsualDirectionWhereNothingHidesTheTarget) {
  const LoggedRun run = SomeRun();  // the robot stays 2 m off
  const StageShapes shapes = Small();
  const NearView view = FindNearView(run, shapes, kTarget, 0, 1, kFov_rad);
  const Eigen::Vector3d out = (view.from_W - view.at_W).normalized();
  // The directions that are tried are 15 deg apart.
  EXPECT_LT(std::acos(out.dot(UsualDirection(0.0, shapes.light.to_sun_W))), 8.0 * kPi / 180.0);
}

TEST(NearView, HasTheTargetWithWhatIsAboutItInTheImagesHeight) {
  const LoggedRun run = Coming();
  for (const double side_m : {0.02, 0.04, 1.0}) {
    StageShapes shapes = Small();
    shapes.bodies[1].parts = {{Box(side_m), {}, {0.02, 0.02, 0.8}}};
    const NearView view = FindNearView(run, shapes, kTarget, 0, 2, kFov_rad);
    const double distance_m = (view.from_W - view.at_W).norm();
    EXPECT_NEAR(distance_m, view.radius_m / std::sin(0.5 * kFov_rad), 1e-9) << side_m;
    EXPECT_GE(view.radius_m, 0.15);
    EXPECT_LE(view.radius_m, 0.3);
  }
}

// The robot goes through the usual place before it comes to the target from the other side.
TEST(NearView, IsNowhereWhereTheRobotGoes) {
  LoggedRun run = Coming();
  const StageShapes shapes = Small();
  const NearView before = FindNearView(run, shapes, kTarget, 0, 2, kFov_rad);
  run.X_WO[0][1].p = before.from_W;
  const NearView view = FindNearView(run, shapes, kTarget, 0, 2, kFov_rad);
  EXPECT_GT((view.from_W - before.from_W).norm(), 0.2 + 0.15);
}

// The robot takes the target up and goes back with it.
TEST(NearView, IsFarEnoughFromATargetThatIsTakenAlong) {
  LoggedRun run = Coming();
  for (int i = 1; i <= 6; ++i) {
    run.times_s.push_back(0.2 + 0.1 * i);
    run.X_WG.push_back(Pose3{});
    run.X_WD.push_back(Pose3{});
    const Eigen::Vector3d moved(0.05 * i, 0.0, 0.04 * i);
    run.X_WO[0].push_back(Pose3::Translation(0.4 + moved.x(), 0.0, 0.2));
    run.X_WO[1].push_back(Pose3::Translation(moved.x(), 0.0, moved.z()));
  }
  const StageShapes shapes = Small();
  const NearView view = FindNearView(run, shapes, kTarget, 0, 8, kFov_rad);
  for (std::size_t i = 2; i < 9; ++i) {
    EXPECT_GT(
        (run.X_WO[1][i] * shapes.points[0].p_O - view.from_W).norm() * std::sin(0.5 * kFov_rad),
        view.radius_m - 1e-6)
        << i;
  }
}

// On a slope of 30 deg towards the usual direction's side no camera is under the ground.
TEST(NearView, IsOverASlope) {
  LoggedRun run = Coming();
  const Pose3 tilted{
      Eigen::AngleAxisd(30.0 * kPi / 180.0, Eigen::Vector3d(-1.0, 1.0, 0.0).normalized())
          .toRotationMatrix(),
      {0.0, 0.0, 0.0}};
  for (auto& body : run.X_WO) {
    for (Pose3& X : body) X = tilted * X;
  }
  run.X_WG = run.X_WD = {tilted, tilted, tilted};
  const NearView view = FindNearView(run, Small(), kTarget, 0, 2, kFov_rad);
  EXPECT_GT((Inverse(tilted) * view.from_W).z(), 0.1);
}

// A tip on the robot: it is shown where it comes to the target, not where it begins.
TEST(NearView, OfARobotsPointIsAtTheTarget) {
  const LoggedRun run = Coming();
  StageShapes shapes = Small();
  shapes.points.push_back({"tip", "robot", {-0.3, 0.0, 0.0}});
  const NearView view = FindNearView(run, shapes, {"tip", std::nullopt}, 0, 2, kFov_rad);
  EXPECT_LT((view.at_W - Eigen::Vector3d(0.1, 0.0, 0.2)).norm(), 1e-9);
}

}  // namespace
}  // namespace dockyard
