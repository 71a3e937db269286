// The placement of Nesnas, Maimone and Das (ICRA 2000), IV-B: the mast stops 20 cm from the
// surface, moves the instrument along the surface's normal until it touches, holds it for the
// measurement, draws back along the normal and stows. Contact is felt by switches on the
// instrument's face. On a surface that bends, one switch or two that close alone say to which side
// the tool leans: the mast draws back by a centimetre, moves to that side and touches again.
#pragma once

#include <string>
#include <vector>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "controller/rocky7/mast_drive.h"
#include "controller/rocky7/phases.h"
#include "controller/rocky7/place_plan.h"

namespace dockyard::rocky7 {

class Placement {
 public:
  explicit Placement(const Nominal& nominal);

  /// From the mast as it watches, the rover standing.
  void Start(const FaceAt& face, const SensorFrame& sensed);
  /// One period of kUnfold to kStow. What ends the phase, if anything; of kStow kHeld, or kMissed
  /// where nothing touched. kFailed: the mast met something on its path, or cannot move along it;
  /// it stays where it stopped.
  Event Step(Phase phase, const SensorFrame& sensed);
  /// Of the mast's motors, in their order.
  const std::vector<MotorCommand>& commands() const { return mast_.commands(); }
  const std::string& note() const { return note_; }
  int closed() const { return closed_; }  // switches, at most, in this placement
  /// How far the face's middle went beyond the surface as it was seen, by the encoders, when the
  /// first switch closed.
  double beyond_m() const { return beyond_m_; }

 private:
  Event Unfold(const SensorFrame& sensed);
  Event Advance(const SensorFrame& sensed);
  Event Press(const SensorFrame& sensed);
  Event Retract(const SensorFrame& sensed);
  /// In R, from the face's middle to the closed switches' one.
  Eigen::Vector3d TowardsClosed(const SensorFrame& sensed) const;
  /// Draws back for another touch, towards the switches that closed; false where all did, where the
  /// surface is flat, or no further touch is due.
  bool BeginAgain(const SensorFrame& sensed);
  void Again(const SensorFrame& sensed);
  /// Sets the face's middle at this distance before the surface; false where it cannot go.
  bool MoveTo(double before_m);
  double BeforeSurface(const SensorFrame& sensed) const;
  bool MeetsSomething(const SensorFrame& sensed);
  Event Stop(const std::string& why, const SensorFrame& sensed);
  static int Closed(const SensorFrame& sensed);

  const Nominal nominal_;
  MastDrive mast_;
  FaceAt face_;
  Tick since_ = 0;         // the phase began
  double before_m_ = 0.0;  // as it is set
  double touched_m_ = 0.0, beyond_m_ = 0.0;
  enum class Retouch { kNone, kBack, kAcross, kAhead } retouch_ = Retouch::kNone;
  FaceAt next_;  // of the touch that follows
  Tick across_since_ = 0;
  Eigen::Vector3d aside_R_{0, 0, 0};  // along the surface from the first touch
  int retouches_ = 0;
  bool reaches_ = false, touched_ = false;
  int closed_ = 0, risen_ = 0;
  std::vector<double> usual_a_;
  std::string note_;
};

}  // namespace dockyard::rocky7
