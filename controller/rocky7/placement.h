// The placement of Nesnas, Maimone and Das (ICRA 2000), IV-B: the mast stops 20 cm from the
// surface, moves the instrument along the surface's normal until it touches, holds it for the
// measurement, draws back along the normal and stows. Contact is felt by switches on the
// instrument's face.
#pragma once

#include <string>
#include <vector>

#include "controller/io/commands.h"
#include "controller/io/sensors.h"
#include "controller/rocky7/mast_drive.h"
#include "controller/rocky7/place_plan.h"

namespace dockyard::rocky7 {

class Placement {
 public:
  explicit Placement(const Nominal& nominal);

  /// From the mast as it watches, the rover standing.
  void Start(const FaceAt& face, const SensorFrame& sensed);
  /// The commands of the mast's motors, in their order.
  std::vector<MotorCommand> Step(const SensorFrame& sensed);

  enum class Result {
    kNone,     // not ended
    kPlaced,   // touched, held, drawn back and stowed
    kMissed,   // nothing touched; drawn back and stowed
    kBlocked,  // the mast met something on its way, or cannot go it; it stands where it stopped
  };
  Result result() const { return result_; }
  bool busy() const { return phase_ != Phase::kIdle && result_ == Result::kNone; }
  const char* phase() const;
  const std::string& note() const { return note_; }
  int closed() const { return closed_; }  // switches, at most, in this placement
  /// How far the face's middle went beyond the surface as it was seen, by the encoders, when the
  /// first switch closed.
  double beyond_m() const { return beyond_m_; }

 private:
  enum class Phase { kIdle, kUnfold, kAdvance, kPress, kHold, kRetract, kStow, kStopped };
  void Begin(Phase phase, Tick now);
  void Unfold(const SensorFrame& sensed);
  void Advance(const SensorFrame& sensed);
  void Press(const SensorFrame& sensed);
  void Retract(const SensorFrame& sensed);
  /// Sets the face's middle at this distance before the surface; false where it cannot go.
  bool MoveTo(double before_m);
  double BeforeSurface(const SensorFrame& sensed) const;
  bool MeetsSomething(const SensorFrame& sensed);
  void Stop(const std::string& why, const SensorFrame& sensed);
  static int Closed(const SensorFrame& sensed);

  const Nominal nominal_;
  MastDrive mast_;
  FaceAt face_;
  Phase phase_ = Phase::kIdle;
  Result result_ = Result::kNone;
  Tick since_ = 0;
  double before_m_ = 0.0;  // as it is set
  double touched_m_ = 0.0, beyond_m_ = 0.0;
  bool touched_ = false;
  int closed_ = 0, risen_ = 0;
  std::vector<double> usual_a_;
  std::string note_;
};

}  // namespace dockyard::rocky7
