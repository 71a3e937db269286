// One pass through region II: state 2, with state 7 as the first part of its first turn (F, D).
#pragma once

#include "controller/raposa/align_plan.h"
#include "controller/raposa/ferreira_sight.h"
#include "controller/raposa/odometry.h"
#include "controller/raposa/visual_turn.h"

namespace dockyard::raposa {

class AlignPass {
 public:
  /// From a picture with a pair.
  AlignPass(const Nominal& nominal, const Sight& sight);

  enum class Status {
    kByEye,  // state 7
    kByOdometry,
    kLost,  // the ellipse, for too many frames in state 7
    kOver   // the robot has stood still for the look
  };
  Status status() const { return status_; }
  const AlignPlan& plan() const { return plan_; }

  /// Speeds for the next control period. Once lost or over: none.
  /// @param last  of the period before, which goes on until the next picture
  Twist Step(Tick now, const Sight& sight, const Twist& last, BeltOdometry* odometry);

 private:
  enum class Part { kFirstTurn, kTravel, kLastTurn, kLook };
  Twist ByEye(const Sight& sight, const Twist& last, BeltOdometry* odometry);
  Twist ByOdometry(Tick now, const Pose2& X_ON);

  FerreiraMotion options_;
  int lost_frames_;
  AlignPlan plan_;
  VisualTurn visual_turn_;
  Status status_ = Status::kByEye;
  Part part_ = Part::kFirstTurn;
  Tick stopped_ = 0;
};

}  // namespace dockyard::raposa
