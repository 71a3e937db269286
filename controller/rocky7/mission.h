// Reach, and grasp where it is asked for: the approach, then the arm, then its weight, and an image
// pair of the place where that says nothing of a stone.
#pragma once

#include <memory>

#include "controller/io/controller.h"
#include "controller/rocky7/approach.h"
#include "controller/rocky7/grasp.h"
#include "controller/rocky7/pair_work.h"

namespace dockyard::rocky7 {

struct MissionOptions {
  int tries = 1;          // grasps, at most
  bool inspects = false;  // weighs, and inspects if need be; without it the scoops are believed
};

class Mission final : public Controller {
 public:
  Mission(const Nominal& nominal, std::unique_ptr<TargetTracker> tracker,
          const ApproachOptions& approach, const MissionOptions& options);

  Commands Step(const SensorFrame& sensed) override;
  const Belief& belief() const override { return belief_; }

 private:
  void On(Event event) { Follow(nominal_.task, event, phase_); }
  void StepApproach(const SensorFrame& sensed, Commands& commands);
  void StepGrasp(const SensorFrame& sensed);
  void Inspect(const SensorFrame& sensed, Commands& commands);
  void TryAgain();
  bool TipsWithArmOut(const SensorFrame& sensed) const;
  void Tell(const std::string& note);

  const Nominal nominal_;
  const MissionOptions options_;
  Approach approach_;
  Grasp grasp_;
  Phase phase_ = Phase::kObserve;
  int tried_ = 0;
  ImageRequest request_;  // of the inspection
  PairWork work_;         // likewise
  Belief belief_;
};

}  // namespace dockyard::rocky7
