#include "sim/rocky7/target_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace dockyard::rocky7 {
namespace {

using Eigen::Vector3d;

constexpr double kNearPlane_m = 0.02;
// A detection so near to the boulder's surface is of it. Assumed, 2-6 cm: the mast's pair is off by
// that at 2 to 4 m.
constexpr double kOnBoulder_m = 0.03;

// Share of the segment at which it meets the triangle (Moeller and Trumbore 1997); < 0: it does
// not.
double MeetsAt(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& from,
               const Vector3d& along) {
  const Vector3d ab = b - a, ac = c - a, across = along.cross(ac);
  const double volume = ab.dot(across);
  if (std::abs(volume) < 1e-15) return -1.0;
  const Vector3d off = from - a;
  const double u = off.dot(across) / volume;
  const Vector3d turned = off.cross(ab);
  const double v = along.dot(turned) / volume;
  return u < 0.0 || v < 0.0 || u + v > 1.0 ? -1.0 : ac.dot(turned) / volume;
}

PlanDisc DiscOf(const ConvexBody& stone_G, const Pose3& X_EG) {
  PlanDisc disc{(X_EG * stone_G.centre).head<2>()};
  for (const Vector3d& vertex : stone_G.vertices) {
    const Vector3d p_E = X_EG * vertex;
    disc.radius_m = std::max(disc.radius_m, (p_E.head<2>() - disc.p_E).norm());
  }
  return disc;
}

}  // namespace

bool Blocks(const RenderMesh& mesh, const Pose3& X_WM, const Vector3d& from_W,
            const Vector3d& to_W) {
  const Pose3 X_MW = Inverse(X_WM);
  const Vector3d from = X_MW * from_W, along = X_MW * to_W - from;
  const double least = kNearPlane_m / along.norm();
  const auto corner = [&](std::uint32_t i) { return Vector3d(mesh.vertices[i].cast<double>()); };
  return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& triangle) {
    const double share =
        MeetsAt(corner(triangle[0]), corner(triangle[1]), corner(triangle[2]), from, along);
    return share > least && share < 1.0;
  });
}

bool LeftImageShows(const Rocky7Plant& plant, const Vector3d& p_W) {
  const Truth& truth = plant.truth();
  const bool by_mast = plant.built().world.boulder.has_value();
  const StereoRig& rig = by_mast ? plant.built().mast_pair : plant.built().front;
  const Pose3 X_WC = (by_mast ? truth.X_WK : truth.X_WR) * rig.X_RL;
  const auto pixel = rig.left.Project(Inverse(X_WC) * p_W);
  if (!pixel || !rig.left.Sees(*pixel)) return false;
  const StageShapes shapes = plant.shapes();
  for (std::size_t i = 0; i < std::min(shapes.bodies.size(), truth.X_WL.size()); ++i) {
    for (const StagePart& part : shapes.bodies[i].parts) {
      if (Blocks(*part.mesh, truth.X_WL[i] * part.X_OP, X_WC.p, p_W)) return false;
    }
  }
  return true;
}

Vector3d TargetInWorld(const Rocky7Plant& plant) {
  const WorldSetup& world = plant.built().world;
  return SiteInWorld(world.X_WG, world.slope) *
         (world.boulder ? plant.target_G() : plant.truth().X_GT.p);
}

LossTruth TruthAt(const Rocky7Plant& plant, const SightingReport& report,
                  const std::optional<Eigen::Vector2d>& predicted_G) {
  const BuiltRun& built = plant.built();
  const Pose3 X_WG = SiteInWorld(built.world.X_WG, built.world.slope);
  const Vector3d p_WT = TargetInWorld(plant);
  // The report has the axes of E by the controller's attitude, in which its plan is.
  const Eigen::Matrix3d R_ER = report.X_RB.R.transpose();
  const Pose3 X_EG = Pose3{R_ER, Vector3d::Zero()} * Inverse(plant.truth().X_WR) * X_WG;
  LossTruth found{.in_view = LeftImageShows(plant, p_WT),
                  .p_ET = (X_EG * (Inverse(X_WG) * p_WT)).head<2>(),
                  .target_radius_m = 0.5 * built.keys.diameter_m,
                  .window_m = built.keys.nesnas.window_m,
                  .albedo_share = built.keys.stone_albedo};
  if (predicted_G) found.predicted_E = Inverse(plant.truth().X_GR) * *predicted_G;
  if (report.accepted) found.detected_E = (R_ER * report.X_RB.p).head<2>();
  // The first stone is the target of a task without a grasp.
  const bool first_is_target = !built.world.boulder && !built.world.loose_target;
  for (std::size_t i = first_is_target ? 1 : 0; i < built.world.stones.size(); ++i) {
    found.others_E.push_back(DiscOf(built.world.stones[i], X_EG));
  }
  for (std::size_t i = 0; i < built.world.loose_stones.size(); ++i) {
    PlanDisc disc = DiscOf(built.world.loose_stones[i], X_EG);
    disc.p_E = (X_EG * plant.truth().X_GS.at(i).p).head<2>();
    found.others_E.push_back(disc);
  }
  if (built.world.boulder) {
    found.target_radius_m = built.world.robot.rover.mast->instrument.radius_m;
    const Vector3d p_G = Inverse(X_WG) * (plant.truth().X_WR * report.X_RB.p);
    found.on_boulder =
        report.accepted && std::abs(DepthIn(*built.world.boulder, p_G).depth_m) < kOnBoulder_m;
  }
  return found;
}

}  // namespace dockyard::rocky7
