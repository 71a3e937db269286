#include "controller/rocky7/placement.h"

#include <algorithm>
#include <cmath>

#include "controller/rocky7/touch_place.h"

namespace dockyard::rocky7 {
namespace {

// "It stops at about 20 cm from the target's surface" (N, IV-B).
constexpr double kBeforeSurface_m = 0.2;
// Along the normal: on the way, in the last centimetres, and after the first contact. Assumed,
// 1-3, 0.5-1.5 and 0.1-0.5 cm/s; the last but one keeps v t + v^2 / 2 a below a millimetre.
constexpr double kAdvance_m_s = 0.02, kNear_m_s = 0.008, kPress_m_s = 0.003, kRetract_m_s = 0.03;
constexpr double kNear_m = 0.04;
// After the first switch: so much further, or until the second one closes. The mast gives way, so a
// millimetre adds half a newton (models/rocky7/rocky7.yaml). Assumed, 0.5-2 mm, 2-3.
constexpr double kPress_m = 0.0008;
constexpr int kEnoughSwitches = 2;
// The same on a surface that bends, at most, or until all close. The can itself moves by a third of
// that, as a switch's spring is twice as stiff as the mast, and by a fifth on two switches: where
// no second one closes the tool leans by 2.3 deg or more, where no third one closes by 1.4 deg or
// more. Assumed, 3-6 mm.
constexpr double kLeanPress_m = 0.005;
// A lean of which nothing more is known, by one switch and by two, halved with each further touch;
// how long a step along the surface may be, and how far they may lead; and the least one. Assumed,
// 3-5 and 2-3 deg, 2-6 and 6-10 mm, 0.5-2 mm.
constexpr double kLean_rad = Radians(4.0), kLeanOfTwo_rad = Radians(2.5), kMostStep_m = 0.005,
                 kMostRetouch_m = 0.008, kLeastStep_m = 0.001;
// Further touches, at most. Assumed, 2-4.
constexpr int kMostRetouches = 3;
// Before the next touch the mast draws back, and swings out. Assumed, 1-3 cm, 0.5-1 s.
constexpr double kDrawBack_m = 0.015;
constexpr Tick kRestsFor = 800;
// Beyond the surface as it was seen: then it was not there. Assumed, 4-8 cm.
constexpr double kBeyond_m = 0.06;
// The instrument measures. Assumed, 2-60 s.
constexpr Tick kMeasure = 5000;
// Of the mast's joints on the way to 20 cm. Assumed, 0.3-0.8.
constexpr double kUnfoldSpeed = 0.5;
// A current that rises over its usual one by this share of the most, for so many periods, is a
// collision; the usual one follows with this share a period. Assumed, 0.2-0.5, 3-6 and 0.02-0.1.
constexpr double kRise = 0.35, kFollowCurrent = 0.05;
constexpr int kRisePeriods = 4;

constexpr double kPeriod_s = kControlPeriod * kTickSeconds;

}  // namespace

Placement::Placement(const Nominal& nominal) : nominal_(nominal), mast_(nominal) {}

int Placement::Closed(const SensorFrame& sensed) {
  return static_cast<int>(std::count(sensed.values.begin(), sensed.values.end(), 1.0));
}

Event Placement::Stop(const std::string& why, const SensorFrame& sensed) {
  note_ = why;
  mast_.Follow(mast_.Angles(sensed));
  return Event::kFailed;
}

bool Placement::MoveTo(double before_m) {
  const auto angles = AnglesTo(nominal_.mast, face_.p_RT + before_m * face_.normal_R);
  if (!angles) return false;
  before_m_ = before_m;
  mast_.Follow(*angles);
  return true;
}

double Placement::BeforeSurface(const SensorFrame& sensed) const {
  const Eigen::Vector3d p_RF = FaceCentre(nominal_.mast, mast_.Angles(sensed));
  return face_.normal_R.dot(p_RF - face_.p_RT);
}

void Placement::Start(const FaceAt& face, const SensorFrame& sensed) {
  face_ = face;
  touched_ = false;
  closed_ = risen_ = retouches_ = 0;
  retouch_ = Retouch::kNone;
  aside_R_.setZero();
  beyond_m_ = 0.0;
  usual_a_.clear();
  note_ = "unfolds to 20 cm before the surface";
  const auto angles = AnglesTo(nominal_.mast, face.p_RT + kBeforeSurface_m * face.normal_R);
  reaches_ = angles.has_value();
  if (reaches_) {
    mast_.Begin(*angles, kUnfoldSpeed, sensed);
  } else {
    Stop("the mast does not reach the place before the surface", sensed);
  }
}

bool Placement::MeetsSomething(const SensorFrame& sensed) {
  const std::size_t first = FirstMastMotor(nominal_);
  const bool learns = usual_a_.empty();
  usual_a_.resize(kMastMotorCount);
  bool rises = false;
  for (std::size_t i = 0; i < usual_a_.size(); ++i) {
    const double now_a = sensed.motors[first + i].current_a;
    if (learns) usual_a_[i] = now_a;
    rises = rises || now_a - usual_a_[i] > kRise * nominal_.motors[first + i].max_current_a;
    usual_a_[i] += kFollowCurrent * (now_a - usual_a_[i]);
  }
  risen_ = rises ? risen_ + 1 : 0;
  return risen_ >= kRisePeriods || Closed(sensed) > 0;
}

Event Placement::Unfold(const SensorFrame& sensed) {
  if (!reaches_) return Event::kFailed;
  if (MeetsSomething(sensed)) return Stop("the mast met something on its way", sensed);
  if (!mast_.Rests(sensed)) return Event::kNone;
  if (mast_.Missed(sensed)) return Stop("something holds the mast back", sensed);
  before_m_ = kBeforeSurface_m;
  note_ = "moves along the normal";
  return Event::kArrived;
}

Event Placement::Advance(const SensorFrame& sensed) {
  closed_ = std::max(closed_, Closed(sensed));
  if (closed_ > 0) {
    touched_ = true;
    beyond_m_ = -BeforeSurface(sensed);
    // No further than it is: what it lags behind would press.
    MoveTo(std::max(before_m_, BeforeSurface(sensed)));
    touched_m_ = before_m_;
    note_ = "touches";
    return Event::kTouched;
  }
  const double speed_m_s = before_m_ > kNear_m ? kAdvance_m_s : kNear_m_s;
  if (before_m_ >= -kBeyond_m && MoveTo(before_m_ - speed_m_s * kPeriod_s)) return Event::kNone;
  note_ = "nothing was there to touch";
  return Event::kMissed;
}

Event Placement::Press(const SensorFrame& sensed) {
  closed_ = std::max(closed_, Closed(sensed));
  if (retouch_ != Retouch::kNone) {
    Again(sensed);
    return Event::kNone;
  }
  const bool flat = face_.bend_R.isZero();
  const double press_m = flat ? kPress_m : kLeanPress_m;
  const int switches = flat ? kEnoughSwitches : kContactCount;
  const bool enough = Closed(sensed) >= switches || before_m_ <= touched_m_ - press_m;
  if (!enough && MoveTo(before_m_ - kPress_m_s * kPeriod_s)) return Event::kNone;
  if (BeginAgain(sensed)) return Event::kNone;
  note_ = "holds with " + std::to_string(Closed(sensed)) + " switches closed";
  return Event::kArrived;
}

Eigen::Vector3d Placement::TowardsClosed(const SensorFrame& sensed) const {
  Eigen::Vector3d sum_K(0.0, 0.0, 0.0);
  for (std::size_t i = 0; i < sensed.values.size(); ++i) {
    const double turn_rad = 2.0 * kPi / kContactCount * static_cast<double>(i);
    if (sensed.values[i] == 1.0) {
      sum_K += Eigen::Vector3d(0.0, std::sin(turn_rad), std::cos(turn_rad));
    }
  }
  return SecondLink(nominal_.mast, mast_.Angles(sensed)).R * sum_K;
}

bool Placement::BeginAgain(const SensorFrame& sensed) {
  const int closed = Closed(sensed);
  if (face_.bend_R.isZero() || retouches_ >= kMostRetouches) return false;
  if (closed == 0 || closed == kContactCount) return false;
  Eigen::Vector3d along_R = TowardsClosed(sensed);
  along_R = (along_R - face_.normal_R * face_.normal_R.dot(along_R)).normalized();
  const double bend_per_m = along_R.dot(face_.bend_R * along_R);
  const double lean_rad = std::ldexp(closed == 1 ? kLean_rad : kLeanOfTwo_rad, -retouches_);
  if (bend_per_m <= 0.0) return false;
  const double step_m =
      std::min({kMostStep_m, lean_rad / bend_per_m, kMostRetouch_m - aside_R_.dot(along_R)});
  if (step_m < kLeastStep_m) return false;
  next_ = AlongSurface(face_, step_m * along_R);
  aside_R_ += step_m * along_R;
  ++retouches_;
  retouch_ = Retouch::kBack;
  note_ = "leans: touches again";
  return true;
}

void Placement::Again(const SensorFrame& sensed) {
  switch (retouch_) {
    case Retouch::kBack:
      if (before_m_ < touched_m_ + kDrawBack_m && MoveTo(before_m_ + kRetract_m_s * kPeriod_s)) {
        return;
      }
      face_ = next_;
      MoveTo(before_m_);
      across_since_ = sensed.tick;
      retouch_ = Retouch::kAcross;
      return;
    case Retouch::kAcross:
      if (sensed.tick - across_since_ >= kRestsFor) retouch_ = Retouch::kAhead;
      return;
    default:
      if (Closed(sensed) == 0 && before_m_ >= -kBeyond_m &&
          MoveTo(before_m_ - kNear_m_s * kPeriod_s)) {
        return;
      }
      MoveTo(std::max(before_m_, BeforeSurface(sensed)));
      touched_m_ = before_m_;
      retouch_ = Retouch::kNone;
  }
}

Event Placement::Retract(const SensorFrame& sensed) {
  if (before_m_ < kBeforeSurface_m && MoveTo(before_m_ + kRetract_m_s * kPeriod_s)) {
    return Event::kNone;
  }
  mast_.Begin(nominal_.mast.watch_rad, kUnfoldSpeed, sensed);
  return Event::kArrived;
}

Event Placement::Step(Phase phase, const SensorFrame& sensed) {
  Event event = Event::kNone;
  switch (phase) {
    case Phase::kUnfold:
      event = Unfold(sensed);
      break;
    case Phase::kAdvance:
      event = Advance(sensed);
      break;
    case Phase::kPress:
      event = Press(sensed);
      break;
    case Phase::kHold:
      closed_ = std::max(closed_, Closed(sensed));
      if (sensed.tick - since_ >= kMeasure) event = Event::kArrived;
      break;
    case Phase::kRetract:
      event = Retract(sensed);
      break;
    default:
      if (mast_.Rests(sensed)) event = touched_ ? Event::kHeld : Event::kMissed;
  }
  if (event != Event::kNone) since_ = sensed.tick;
  return event;
}

}  // namespace dockyard::rocky7
