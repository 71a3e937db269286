// Rocky 7's nominal parameters: what calibration, drawings and the user's click tell its
// controllers. The world is built from its own numbers, which differ.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/geometry/rover_plan.h"
#include "controller/io/nominal_motor.h"
#include "controller/rocky7/nominal/motors.h"

namespace dockyard::rocky7 {

/// How an image pair becomes range data.
enum class FrontEnd : std::uint8_t {
  // Differences summed over blocks of 7 px, left to right and back, over the whole range; none of
  // the ground is taken out. OpenCV's block matcher for JPL's of the 1990s.
  kBlocks7,
  kSandAndStones,  // ours (controller/stereo/sand_and_stones.h); a face as face_stereo.h has it
};

/// What Nesnas, Maimone and Das (ICRA 2000) leave open of their tracking loop; "N" is that paper.
struct NesnasTracking {
  double window_m = 0.06;      // half of the search window's side; assumed, 0.03-0.12: "small"
  double image_share = 0.1;    // of the trajectory, then the rover stops and looks (N, IV)
  double least_step_m = 0.03;  // shorter ones are driven at once; assumed, 0.01-0.05
  FrontEnd front_end = FrontEnd::kBlocks7;

  bool operator==(const NesnasTracking&) const = default;
};

/// What the rover is asked for.
enum class Task { kReach, kGrasp, kPlace };

/// The arm as its drawing has it. Angles as ArmMotor has them; at 0 the arm points ahead and level.
struct NominalArm {
  Eigen::Vector3d p_RA{0, 0, 0};  // shoulder
  double length_m = 0.0;          // from the shoulder to the scoops' axis
  double scoop_depth_m = 0.0;     // from the axis to the lips
  double open_rad = 0.0;          // back scoop's angle less the front one's, at most

  bool operator==(const NominalArm&) const = default;
};

/// The mast as its drawing has it. Angles in the order of MastMotor, and as that has them.
/// K: its second link. The origin is the elbow's hinge; x along the link to the instrument's face,
/// which is the tool's axis; y left, z up at angle 0.
struct NominalMast {
  Eigen::Vector3d p_RM{0, 0, 0};  // shoulder
  double link1_m = 0.0;           // from the shoulder to the elbow
  double link2_m = 0.0;           // from the elbow to the instrument's face
  std::array<double, 3> low_rad{}, high_rad{}, stowed_rad{};
  std::array<double, 3> watch_rad{};  // as it stands when it watches ahead, and at a placement's
                                      // start
  double switch_radius_m = 0.0;       // of the circle of contact switches on the face
  StereoRig pair_K;                   // its cameras, in K in place of R
};

/// What the rover weighs, and where.
struct NominalMasses {
  double rover_kg = 0.0;          // without what moves of arm and mast
  Eigen::Vector3d p_RC{0, 0, 0};  // its centre of mass
  double arm_kg = 0.0;            // with its scoops
  double arm_middle_m = 0.0;      // from the shoulder along the arm to its centre of mass
  double link1_kg = 0.0;          // of the mast, in its middle
  double link2_kg = 0.0;          // with the instrument and the cameras
  double link2_middle_m = 0.0;    // from the elbow along the link

  bool operator==(const NominalMasses&) const = default;
};

/// R: the rover's body. Its origin lies between the tandem wheels, at the height of their axles; x
/// forward, y left, z up.
struct Nominal {
  RoverPlan plan;
  std::vector<NominalMotor> motors;
  double rolling_radius_m = 0.0;  // of every wheel; R stands so high above level ground
  StereoRig front, back;
  NominalArm arm;
  NominalMast mast;
  NominalMasses masses{};
  Task task = Task::kReach;
  double reach_m = 0.01;  // how near the point P must come to the target (N, V)
  // The user's click in the first picture of the left front camera; of the mast's, where the task
  // is to place the instrument.
  Eigen::Vector2d target_px{0, 0};
  NesnasTracking nesnas{};
  double compute_s = 0.0;  // that its processor takes for an image pair
};

/// The point on level ground, in R's plan, below the scoops' axis where they close.
inline Eigen::Vector2d GraspPoint(const NominalArm& arm, double rolling_radius_m) {
  // Of the axis over the ground. Assumed, 30-50 mm: it rises by some centimetres as they close.
  constexpr double kAxis_m = 0.04;
  const double down_m = arm.p_RA.z() + rolling_radius_m - kAxis_m;
  const double ahead_m = std::sqrt(arm.length_m * arm.length_m - down_m * down_m);
  return {arm.p_RA.x() + ahead_m, arm.p_RA.y()};
}

/// The number of the arm's, and of the mast's, first motor.
inline std::size_t FirstArmMotor(const Nominal& nominal) {
  return nominal.motors.size() - kMastMotorCount - kArmMotorCount;
}
inline std::size_t FirstMastMotor(const Nominal& nominal) {
  return nominal.motors.size() - kMastMotorCount;
}

/// By its encoder.
inline double AngleOf(const Nominal& nominal, const SensorFrame& sensed, std::size_t motor) {
  return static_cast<double>(sensed.motors[motor].encoder_counts) *
         nominal.motors[motor].rad_per_count;
}
/// To an angle, at a share of the most acceleration.
inline MotorCommand MoveTo(const NominalMotor& motor, double target_rad, double speed_rad_s,
                           double accel_share = 1.0) {
  return {.mode = MotorMode::kPosition,
          .target = target_rad,
          .speed_limit_rad_s = speed_rad_s,
          .accel_rad_s2 = accel_share * motor.max_accel_rad_s2,
          .current_limit_a = motor.max_current_a};
}

}  // namespace dockyard::rocky7
