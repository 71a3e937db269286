// The path to a face: take images with the mast, detect the target, plan, drive a part, detect it
// again; until the mast can place the instrument along the face's normal from where the rover is.
// Nesnas, Maimone and Das (ICRA 2000), section IV-B.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "controller/imaging/image_request.h"
#include "controller/rocky7/arc_drive.h"
#include "controller/rocky7/face_decision.h"
#include "controller/rocky7/face_perception.h"
#include "controller/rocky7/ground_attitude.h"
#include "controller/rocky7/mast_drive.h"
#include "controller/rocky7/pair_work.h"
#include "controller/rocky7/phases.h"

namespace dockyard::rocky7 {

class FaceApproach {
 public:
  FaceApproach(const Nominal& nominal, std::unique_ptr<FaceTracker> tracker,
               const FaceApproachOptions& options);

  /// One period of kAim, kObserve and kDrive.
  Event Aim(const SensorFrame& sensed);
  Event Observe(const SensorFrame& sensed, Commands& commands);
  Event Drive(const SensorFrame& sensed, std::vector<MotorCommand>& motors);
  const std::vector<MotorCommand>& mast_commands() const { return mast_.commands(); }
  /// The face by the last detection; the rover has not moved since.
  const FaceAt& face() const { return face_; }
  const Belief& belief() const { return belief_; }

 private:
  Eigen::Vector2d GroundRise(const ImuSample& attitude) const;
  FaceAt FaceOverGround(const ImuSample& attitude) const;
  void TakeFace(const ImuSample& attitude);
  bool TooDark(const GrayImage& left, const SensorFrame& sensed);
  void Take(const FaceDetection& detection);
  Event GoOnBlind(const SensorFrame& sensed);
  Event DecideBy(const FaceDetection& detection, const SensorFrame& sensed);
  Event Begin(std::vector<Arc> arcs, double yaw_rad);
  Event BeginArc(double yaw_rad);
  Event Reached();
  Event GiveUp(const std::string& why);
  void Tell(const std::string& phase, const std::string& note);

  const Nominal nominal_;
  const FaceApproachOptions options_;
  FaceStereo stereo_;
  std::unique_ptr<FaceTracker> tracker_;
  ArcDrive drive_;
  MastDrive mast_;
  Odometry odometry_;
  GroundPlane ground_;
  FaceBelief target_;
  FaceProgress progress_;
  FaceAt face_;
  double tool_off_rad_ = 0.0;
  ImageRequest request_;
  PairWork work_;
  double stops_ = 0.0;          // off the cameras' own exposure
  bool aims_ = false;           // the mast is on its way
  Tick rests_since_ = 0;        // the mast, for the next images
  int pairs_ = 0, misses_ = 0;  // of images in all; in a row without the target
  std::vector<Arc> arcs_;       // after the present one
  std::string detected_;        // the last detection in words
  Belief belief_;
};

}  // namespace dockyard::rocky7
