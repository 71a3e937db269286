#include "controller/rocky7/face_belief.h"

#include <algorithm>
#include <cmath>

#include "controller/rocky7/face_obstacles.h"

namespace dockyard::rocky7 {
namespace {

// A normal that is less sure does not say where to go. Assumed, 5-15 deg.
constexpr double kNormalSure_rad = Radians(10.0);
// Before it is known: a face that leans back by this, along the line of sight. Assumed, 0-45.
constexpr double kLeansBack_rad = Radians(20.0);
// A normal moves by its noise from pair to pair. The newer one counts by this share near by.
// Assumed, 0.3-1.
constexpr double kNewNormal = 0.6;
// Of a boulder's foot over the ground, where it would be seen. Assumed, 5-15 cm.
constexpr double kFoot_m = 0.1;

void TakeNormal(const FaceSighting& sighting, FaceBelief& belief) {
  const double was_rad = belief.normal_sigma_rad, is_rad = sighting.normal_sigma_rad;
  const bool fuses = belief.IsNormalSure();
  const double share = fuses ? std::max(kNewNormal, was_rad / (was_rad + is_rad)) : 1.0;
  const Eigen::Vector3d before = fuses ? *belief.normal_E : *sighting.normal_E;
  belief.normal_E = ((1.0 - share) * before + share * *sighting.normal_E).normalized();
  belief.bend_E = (1.0 - share) * belief.bend_E + share * sighting.bend_E;
  belief.normal_sigma_rad = is_rad;
}

}  // namespace

bool FaceBelief::IsNormalSure() const { return normal_E && normal_sigma_rad < kNormalSure_rad; }

void MoveOn(const Pose2& since, double driven_m, const Eigen::Vector2d& ground_rise,
            FaceBelief& belief) {
  const Pose2 back = Inverse(since);
  belief.p_ET.z() -= ground_rise.x() * since.x + ground_rise.y() * since.y;
  belief.p_ET.head<2>() = back * Eigen::Vector2d(belief.p_ET.head<2>());
  const Eigen::Matrix3d turn = RotZ(-since.heading);
  if (belief.normal_E) belief.normal_E = turn * *belief.normal_E;
  belief.bend_E = turn * belief.bend_E * turn.transpose();
  for (Eigen::Vector2d& p_E : belief.obstacles_E) p_E = back * p_E;
  belief.turned_rad += since.heading;
  belief.driven_m += std::abs(driven_m);
  belief.signed_m += driven_m;
}

double FurtherLeft(const FaceBelief& belief, const Eigen::Vector3d& p_E) {
  const Eigen::Vector2d ray_E = belief.p_ET.head<2>().normalized();
  return ray_E.y() * p_E.x() - ray_E.x() * p_E.y();
}

void Take(const Nominal& nominal, const FaceStereo& stereo, const FaceView& view,
          const FaceSighting& sighting, FaceBelief& belief) {
  if (sighting.normal_E) TakeNormal(sighting, belief);
  // The foot under the face is kept with the target where the view does not hold it any more.
  std::vector<Eigen::Vector2d> obstacles = ObstaclesAbout(view, sighting.p_E);
  for (const Eigen::Vector2d& p_E : belief.obstacles_E) {
    const Eigen::Vector2d moved = p_E + (sighting.p_E - belief.p_ET).head<2>();
    if (!stereo.Pixel(view, {moved.x(), moved.y(), kFoot_m}, false)) obstacles.push_back(moved);
  }
  belief.obstacles_E = NotOurselves(nominal, obstacles);
  belief.p_ET = sighting.p_E;
  belief.turned_rad = belief.driven_m = belief.signed_m = 0.0;
  belief.rolled_m = belief.drift_m = 0.0;
  belief.begun = true;
}

FaceAt LeaningBack(const FaceAt& face) {
  FaceAt leaning = face;
  const Eigen::Vector2d back = -face.p_RT.head<2>().normalized();
  leaning.bend_R.setZero();
  leaning.normal_R << std::cos(kLeansBack_rad) * back, std::sin(kLeansBack_rad);
  return leaning;
}

FaceAt FaceNow(const Nominal& nominal, const ImuSample& attitude, const FaceBelief& belief) {
  const Pose3 X_RE = Inverse(LevelFrame(nominal, attitude));
  FaceAt face{.p_RT = X_RE * belief.p_ET};
  if (!belief.normal_E) return LeaningBack(face);
  face.normal_R = X_RE.R * *belief.normal_E;
  face.bend_R = X_RE.R * belief.bend_E * X_RE.R.transpose();
  return face;
}

std::vector<NamedValue> ValuesOf(const FaceBelief& belief, int pairs, double tool_off_rad) {
  const Eigen::Vector3d normal = belief.normal_E.value_or(Eigen::Vector3d::Zero());
  const double up_rad = std::atan2(normal.z(), normal.head<2>().norm());
  return {{"target_x_m", belief.p_ET.x()},
          {"target_y_m", belief.p_ET.y()},
          {"target_z_m", belief.p_ET.z()},
          {"looks", static_cast<double>(pairs)},
          {"normal_up_deg", Degrees(up_rad)},
          {"normal_azimuth_deg", Degrees(std::atan2(normal.y(), normal.x()))},
          {"normal_sigma_deg", Degrees(belief.normal_sigma_rad)},
          {"tool_off_deg", Degrees(tool_off_rad)}};
}

}  // namespace dockyard::rocky7
