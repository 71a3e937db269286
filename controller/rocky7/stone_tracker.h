// Our tracker: the middle of the stone that was clicked on, told from its neighbours by how they
// lie about it.
#pragma once

#include <string>

#include "controller/rocky7/stone_memory.h"
#include "controller/rocky7/target_tracker.h"

namespace dockyard::rocky7 {

class StoneTracker final : public TargetTracker {
 public:
  /// From afar a stone may be too low to be told from the ground; then the place that was clicked
  /// on is the target until it is seen.
  TargetSighting Begin(const GroundMaps& maps, const Clicked& clicked) override;
  TargetSighting Follow(const GroundMaps& maps, const Predicted& target) override;
  /// Scoops leave heaps and trenches; they may also have moved the stone.
  TargetSighting Check(const GroundMaps& maps, const Pose2& X_ET) override;

 private:
  TargetSighting Found(const GroundMaps& maps, const FieldStone& target);
  TargetSighting Lost(const std::string& why);

  FieldSettings field_;
  StoneMemory memory_;  // in the axes of the last look, from the target's place then
};

}  // namespace dockyard::rocky7
