// Docks a robot at a dock that files describe: finds it, drives to its staging pose, drives in,
// waits for the contact, and tries again where it stays open.
#pragma once

#include <string>

#include "controller/custom/camera_requests.h"
#include "controller/custom/contact.h"
#include "controller/custom/dock_filter.h"
#include "controller/custom/dock_plan.h"
#include "controller/custom/odometry.h"
#include "controller/custom/phases.h"
#include "controller/custom/sighting.h"
#include "controller/custom/twist_limits.h"
#include "controller/imaging/past_motion.h"
#include "controller/io/controller.h"

namespace dockyard::custom {

/// Robot, dock and senses, as the factory found them fit.
struct PilotParts {
  Nominal nominal;
  Drive drive;
  DockPlan plan;
  Contact contact;
  Perceive perceive;
};

class Pilot final : public Controller {
 public:
  explicit Pilot(PilotParts parts);

  Commands Step(const SensorFrame& sensed) override;
  const Belief& belief() const override { return belief_; }
  Phase phase() const { return here_.phase; }

 private:
  /// The present phase.
  struct Here {
    Phase phase = Phase::kPerceive;
    Tick entered = 0;
    double driven_m = 0.0, turned_rad = 0.0;
    int fixes = 0;  // sightings that the filter took
    int leg = 0;    // of a wiggle
    double For(Tick now) const { return kTickSeconds * static_cast<double>(now - entered); }
  };
  /// Tries so far, and what the present one needs.
  struct Tries {
    int retries = 0, stagings = 0, searches = 0;
    double searched_rad = 0.0;
    bool wiggled = false;
    int opens = 0;              // contacts that stayed open
    int realigned = 0;          // approaches that ended before the touch, off to the side
    double sense = 1.0;         // of the drive to the staging pose: 1 forward, -1 backward
    double back_m = 0.0;        // to back off
    double least_left_m = 0.0;  // on the approach
    Tick nearer_at = 0;         // when it last fell
    Pose2 X_OA_detected;        // where the dock was last measured at rest
    bool returns = false;       // to there, not to the staging pose
    int returned = 0;
    Tick marks_at = 0;  // of the last sighting that the filter took
  };

  void ReadSensors(const SensorFrame& sensed);
  void TakeImage(const CameraImage& image);
  void See(const BoardSighting& sighting, const PastMoment& then);
  Twist Act();
  Twist PerceiveDock();
  Twist Search();
  Twist TurnTo();
  Twist Stage();
  Twist Face();
  Twist TurnRound();
  Twist Control();
  Twist Press();
  Twist Wait();
  Twist Wiggle();
  Twist BackOff();
  Eigen::Vector2d RoutePoint() const;
  Twist Return();
  Twist TurnToward(double heading_D_rad, double within_rad, Phase next, const std::string& note);
  Twist Enter(Phase phase, const std::string& note);
  Twist TryAgain(const std::string& why);
  Twist LeaveDock(const std::string& why);
  bool MarksAreLost() const;
  bool IsBlocked(double left_m);
  bool IsWithinDockedBounds() const;
  Pose2 X_DA() const;
  Eigen::Vector3d DockedSigma() const;
  void Believe();

  PilotParts parts_;
  Odometry odometry_;
  PastMotion past_;
  DockFilter filter_;
  CameraRequests requests_;
  TwistLimits limits_;
  Tick now_ = 0;
  Here here_;
  Tries tries_;
  Belief belief_;
};

}  // namespace dockyard::custom
