// The way to a face: look with the mast, find the target, plan, drive a part, look again; until the
// mast can place the instrument along the face's normal from where the rover stands. Nesnas,
// Maimone and Das (ICRA 2000), section IV-B.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/io/controller.h"
#include "controller/rocky7/arc_drive.h"
#include "controller/rocky7/face_eye.h"
#include "controller/rocky7/face_tracker.h"
#include "controller/rocky7/mast_drive.h"
#include "controller/rocky7/odometry.h"
#include "controller/rocky7/place_plan.h"

namespace dockyard::rocky7 {

struct FaceApproachOptions {
  double image_share = 0.1;  // of the way that is left, then the rover looks
  // The steps' bounds. The paper's are its share alone.
  double least_step_m = 0.03, most_step_m = 1e9;
  OdometryOptions odometry{};
  bool exposes_for_target = false;  // asks for more light where the target lies in the shade
  // Plans anew at each look of the last metre and corrects where it stands. Else the two arcs are
  // driven as planned from a metre away, and the mast does what it can from there.
  bool corrects = false;
  int most_looks = 60, most_misses = 1;  // in all; in a row without the target
};

class FaceApproach {
 public:
  FaceApproach(const Nominal& nominal, std::unique_ptr<FaceTracker> tracker,
               const FaceApproachOptions& options);

  Commands Step(const SensorFrame& sensed);
  /// Whether the rover stands where the instrument can be placed.
  bool ready() const { return ready_; }
  /// The face as the last look has it; the rover has not moved since.
  const FaceAt& face() const { return face_; }
  /// Another look from where the rover stands.
  void LookAgain();
  const Belief& belief() const { return belief_; }

 private:
  enum class Phase { kAim, kAsk, kDrive };
  void Aim(const SensorFrame& sensed);
  void StepDrive(const SensorFrame& sensed, Commands& commands);
  void StepAsk(const SensorFrame& sensed, Commands& commands);
  void TakeLook(const StereoImages& images, const SensorFrame& sensed);
  bool TooDark(const GrayImage& left, const SensorFrame& sensed);
  void Take(const FaceView& view, const FaceSeen& seen);
  void Decide(const SensorFrame& sensed);
  void DecideFar(const PlaceGoal& goal, const SensorFrame& sensed);
  void DecideNear(const PlaceGoal& goal, const SensorFrame& sensed);
  void Drive(std::vector<Arc> arcs, const SensorFrame& sensed);
  void BeginArc(const SensorFrame& sensed);
  void GiveUp(const std::string& why);
  void Report(const FaceView& view, const FaceSeen& seen);
  void Tell(const std::string& phase, const std::string& note);
  FaceAt FaceNow(const ImuSample& attitude) const;

  const Nominal nominal_;
  const FaceApproachOptions options_;
  FaceEye eye_;
  ArcDrive drive_;
  MastDrive mast_;
  Odometry odometry_;
  std::unique_ptr<FaceTracker> tracker_;
  Verdict verdict_ = Verdict::kUnderWay;
  Phase phase_ = Phase::kAim;
  bool begun_ = false, aimed_ = false, near_ = false, ready_ = false, driven_all_ = false;
  std::optional<Tick> asked_;
  Tick rests_since_ = 0;  // the mast, for the next pictures
  int asks_ = 0, looks_ = 0, misses_ = 0, near_looks_ = 0;
  double stops_ = 0.0;  // off the cameras' own exposure
  std::vector<Arc> arcs_;
  // In E, odometry since the last look included.
  Eigen::Vector3d p_ET_{0, 0, 0};
  std::optional<Eigen::Vector3d> normal_E_;
  double normal_sigma_rad_ = 0.0;
  std::vector<Eigen::Vector2d> stands_out_E_;
  double turned_rad_ = 0.0, way_m_ = 0.0, signed_way_m_ = 0.0;  // since then
  FaceAt face_;
  double tool_off_rad_ = 0.0;
  std::string sees_;
  Belief belief_;
};

}  // namespace dockyard::rocky7
