// Reach, and grasp where it is asked for: the approach, then the arm, then its weight, and a look
// at the place where that says nothing of a stone.
#pragma once

#include <memory>

#include "controller/io/controller.h"
#include "controller/rocky7/approach.h"
#include "controller/rocky7/grasp.h"

namespace dockyard::rocky7 {

struct MissionOptions {
  int tries = 1;       // grasps, at most
  bool peeks = false;  // weighs, and looks if need be; without it the scoops are believed
};

class Mission final : public Controller {
 public:
  Mission(const Nominal& nominal, std::unique_ptr<TargetTracker> tracker,
          const ApproachOptions& approach, const MissionOptions& options);

  Commands Step(const SensorFrame& sensed) override;
  const Belief& belief() const override { return belief_; }

 private:
  enum class Phase { kApproach, kGrasp, kPeek };
  void StepApproach(const SensorFrame& sensed, Commands& commands);
  void StepGrasp(const SensorFrame& sensed);
  void StepPeek(const SensorFrame& sensed, Commands& commands);
  void TryAgain();
  void Tell(const char* phase, const std::string& note);

  const Nominal nominal_;
  const MissionOptions options_;
  Approach approach_;
  Grasp grasp_;
  Phase phase_ = Phase::kApproach;
  int tried_ = 0, peeks_ = 0;
  Tick asked_ = 0;
  Verdict verdict_ = Verdict::kUnderWay;
  Belief belief_;
};

}  // namespace dockyard::rocky7
