// To place the instrument on a face: the approach, the mast, and away again.
#pragma once

#include <memory>

#include "controller/io/controller.h"
#include "controller/rocky7/face_approach.h"
#include "controller/rocky7/placement.h"

namespace dockyard::rocky7 {

class PlaceMission final : public Controller {
 public:
  /// @param tries  placements, at most
  PlaceMission(const Nominal& nominal, std::unique_ptr<FaceTracker> tracker,
               const FaceApproachOptions& options, int tries);

  Commands Step(const SensorFrame& sensed) override;
  const Belief& belief() const override { return belief_; }

 private:
  void On(Event event) { Follow(Task::kPlace, event, phase_); }
  void StepApproach(const SensorFrame& sensed, Commands& commands);
  bool TipsWithMastOut(const SensorFrame& sensed) const;
  void StepPlace(const SensorFrame& sensed);
  void StepBackOff(const SensorFrame& sensed, Commands& commands);
  void Tell(const char* phase, const std::string& note);

  const Nominal nominal_;
  const int tries_;
  const bool keeps_upright_;  // checks that the rover does not tip
  FaceApproach approach_;
  Placement placement_;
  ArcDrive drive_;
  Phase phase_ = Phase::kAim;
  int tried_ = 0;
  std::vector<MotorCommand> mast_;
  Belief belief_;
};

/// Ours: the face's appearance about the target, planned anew under way, corrected where it ends.
std::unique_ptr<Controller> MakeDockyardPlacement(const Nominal& nominal);
/// The paper's: the highest cell, a look after each tenth, two arcs from a metre away.
std::unique_ptr<Controller> MakeNesnas2000Placement(const Nominal& nominal);

}  // namespace dockyard::rocky7
