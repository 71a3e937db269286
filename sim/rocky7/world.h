// The physical world of one run: rover, ground and stones. Every run makes a new world and never
// resets it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "models/parts/soil_model.h"
#include "models/rocky7/robot_model.h"
#include "sim/drives/imu.h"
#include "sim/drives/motor_truth.h"
#include "sim/rigid/convex_body.h"
#include "sim/rigid/slope.h"
#include "sim/rigid/star_body.h"
#include "sim/soil/height_grid.h"
#include "sim/vehicles/bedded_stones.h"
#include "sim/vehicles/face_contact.h"
#include "sim/vehicles/loose_stones.h"
#include "sim/vehicles/part_contacts.h"
#include "sim/vehicles/wheeled_body.h"

namespace dockyard::rocky7 {

/// Longer steps do not hold the contacts of scoops and stones. Assumed, 1-2 ms.
inline constexpr double kLongestStep_s = 2e-3;

struct WorldSetup {
  RobotModel robot;
  SoilModel soil;
  std::vector<SoilModel> patch_soils;  // of the ground's numbers 1, 2 ...
  HeightGrid ground;                   // in the site frame G
  Pose2 X_WG;                          // site in the world, before it is tilted
  Slope slope;
  Pose2 X_GR_start;                        // the rover in plan
  std::vector<ConvexBody> stones;          // in the ground, in G; the target first
  double stone_friction = 0.6;             // of the rover's parts and of other stones on them
  std::vector<ConvexBody> loose_stones{};  // on the ground, in G; scoops and wheels move them
  // The target where it lies loose, in its own frame and at rest; then it is not among the stones.
  std::optional<ConvexBody> loose_target{};
  Eigen::Matrix3d R_GT_start = Eigen::Matrix3d::Identity();
  double target_buried = 0.0;  // share of its height below the ground
  // To place the instrument on, in G. Then the mast watches, and the arm is rolled aside.
  std::optional<StarBody> boulder{};
  Eigen::Vector3d target_G{0, 0, 0};  // the middle of its face
  double step_s = 1e-3;
};

/// What is true now, for scoring, plots and drawing. Never handed to a controller.
struct Truth {
  double time_s = 0.0;
  Pose3 X_WR;                 // the body
  std::vector<Pose3> X_WL{};  // all links, in the order of the rover's tree; the body first
  Eigen::Vector3d v_WR_W = Eigen::Vector3d::Zero(), w_WR_W = Eigen::Vector3d::Zero();
  Pose2 X_GR;
  Eigen::Vector3d p_GP{0, 0, 0};  // the point on the body that is to reach the target
  Pose3 X_GT;                  // the target: middle of a fixed one, centre of mass of a loose one
  double target_rise_m = 0.0;  // since the start
  std::vector<Pose3> X_GS{};   // of the loose stones of the field: their centres of mass
  std::vector<MotorTruth> motors{};
  double sinkage_m = 0.0;        // mean of the wheels
  std::vector<double> sunk_m{};  // each stone, by wheels
  double stone_force_n = 0.0;    // on all stones in the ground
  // The mast's second link, and how it moves.
  Pose3 X_WK;
  Eigen::Vector3d v_WK_W = Eigen::Vector3d::Zero(), w_WK_W = Eigen::Vector3d::Zero();
  // The instrument: middle of its face, the way it looks, its switches, what it presses with now
  // and has at most.
  Eigen::Vector3d p_GF{0, 0, 0}, axis_G{1, 0, 0};
  std::array<bool, kFaceSwitches> closed{};
  double face_n = 0.0, most_face_n = 0.0;
  bool on_stone = false;  // body, suspension or mast has met a stone or the boulder
};

class World {
 public:
  /// The rover is braked until it has come to rest. The step must be in (0, kLongestStep_s].
  explicit World(const WorldSetup& setup);
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  /// One step with the drives obeying these commands.
  void Step(const std::vector<MotorCommand>& commands);
  Tick tick() const { return std::llround(time_s() / kTickSeconds); }
  Truth truth() const;
  /// Averages since the last call.
  TrueImu TakeTrueImu();
  const WheeledBody& rover() const { return rover_; }
  /// The target first where it lies loose, then the field's.
  const LooseStones& loose() const { return loose_; }
  const HeightGrid& ground() const { return setup_.ground; }
  const Pose3& X_WG() const { return X_WG_; }
  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  double time_s() const { return static_cast<double>(steps_) * setup_.step_s; }
  void AddLooseTarget();
  void AddLoose(const LooseStone& stone);
  bool MeetsStone() const;

  WorldSetup setup_;
  Pose3 X_WG_;
  RigidWorld world_;
  WheeledBody rover_;
  ImuAverage imu_;
  PartContacts parts_;
  int rover_parts_ = 0;  // the first ones
  BeddedStones stones_;
  LooseStones loose_;
  int loose_targets_ = 0;  // the first ones
  FaceContact face_;
  double most_face_n_ = 0.0;
  bool on_stone_ = false;
  double target_start_m_ = 0.0;
  long steps_ = 0;
};

}  // namespace dockyard::rocky7
