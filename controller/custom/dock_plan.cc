#include "controller/custom/dock_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dockyard::custom {
namespace {

// A docked heading off x of D by more needs another approach. Assumed, 5-15 deg.
constexpr double kOffAxis_rad = Radians(10.0);
constexpr double kOblique_rad = Radians(70.0);  // a board shows its marks up to it; assumed, 60-75
// The drive in begins from within these of the staging pose. Assumed, 5-20 cm, 5-20 deg.
constexpr double kStaging_m = 0.12, kStaging_rad = Radians(15.0);
constexpr double kMargin_px = 2.0;  // about the board; assumed, 1-10

bool ShowsBoard(const RobotCamera& camera, const DockBoard& board, const Pose3& X_DR) {
  const Pose3 X_CB = Inverse(X_DR * camera.X_RC) * board.X_DB;
  const double cosine = X_CB.R.col(2).dot(X_CB.p.normalized());
  if (cosine < std::cos(kOblique_rad)) return false;
  const double x = 0.5 * board.board.width_m, y = 0.5 * board.board.height_m;
  const std::array<Eigen::Vector3d, 4> corners{
      {{-x, -y, 0.0}, {x, -y, 0.0}, {x, y, 0.0}, {-x, y, 0.0}}};
  return std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& corner) {
    const auto pixel = camera.camera.Project(X_CB * corner);
    return pixel && camera.camera.Sees(*pixel, kMargin_px);
  });
}

std::vector<int> CamerasThatShow(const Nominal& nominal, const Pose2& X_DR) {
  std::vector<int> cameras;
  for (int i = 0; i < static_cast<int>(nominal.cameras.size()); ++i) {
    if (Shows(nominal, i, X_DR)) cameras.push_back(i);
  }
  return cameras;
}

}  // namespace

bool Shows(const Nominal& nominal, int camera, const Pose2& X_DR) {
  const Pose3 X = FromGround(X_DR, nominal.height_m);
  return std::any_of(nominal.boards.begin(), nominal.boards.end(), [&](const DockBoard& board) {
    return ShowsBoard(nominal.cameras[static_cast<std::size_t>(camera)], board, X);
  });
}

double DockPlan::Left(const Pose2& X_DA) const {
  return -travel * (Inverse(X_DA_docked) * Eigen::Vector2d(X_DA.x, X_DA.y)).x();
}

double DockPlan::Aside(const Pose2& X_DA) const {
  return travel * (Inverse(X_DA_docked) * Eigen::Vector2d(X_DA.x, X_DA.y)).y();
}

bool DockPlan::IsAtStaging(const Pose2& X_DA) const {
  return std::hypot(X_DA.x - X_DA_staging.x, X_DA.y - X_DA_staging.y) < kStaging_m &&
         std::abs(WrapPi(X_DA.heading - measuring_rad)) < kStaging_rad;
}

Pose2 DockPlan::OffDocked(const Pose2& X_DA) const {
  return Inverse(X_DA_docked * X_AP) * (X_DA * X_AP);
}

void DockPlan::Shift(double left_m) {
  X_DA_docked = X_DA_docked * Pose2{0.0, travel * left_m, 0.0};
}

Result<DockPlan, Refusal> PlanDocking(const Nominal& nominal, const Drive& drive) {
  DockPlan plan;
  const Pose2 X_DR = ToGround(nominal.X_DR_docked());
  plan.X_DA_docked = X_DR * drive.X_RA;
  plan.X_AP = Inverse(drive.X_RA) * ToGround(nominal.X_RP);
  const double heading = plan.X_DA_docked.heading;
  plan.travel = std::abs(heading) > 0.5 * kPi ? 1.0 : -1.0;
  if (std::min(std::abs(heading), kPi - std::abs(heading)) > kOffAxis_rad)
    return Refusal{"docked pose: expected x of the robot along x of the dock, within 10 deg"};
  plan.X_DA_staging = plan.X_DA_docked;
  plan.X_DA_staging.x += nominal.docking.staging_m;

  // The docked heading, the opposite one, then those that turn each camera to the dock.
  std::vector<double> turns{0.0, kPi};
  for (const RobotCamera& camera : nominal.cameras) {
    const Eigen::Vector3d sight_R = camera.X_RC.R.col(2);
    const double into_dock_rad = plan.travel > 0.0 ? 0.0 : kPi;
    turns.push_back(into_dock_rad - std::atan2(sight_R.y(), sight_R.x()));
  }
  for (const double turn : turns) {
    Pose2 X_DA = plan.X_DA_staging;
    X_DA.heading = plan.measuring_rad = WrapPi(heading + turn);
    plan.cameras = CamerasThatShow(nominal, X_DA * Inverse(drive.X_RA));
    plan.drives_blind = turn != 0.0;
    if (!plan.cameras.empty()) return plan;
  }
  return Refusal{"cameras: none shows a whole board of the dock from the staging pose"};
}

}  // namespace dockyard::custom
