#include "sim/axel/outcome.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "controller/base/number_text.h"
#include "controller/geometry/axle_attitude.h"
#include "models/axel/mating_fit.h"

namespace dockyard::axel {
namespace {

double Lateral(const Truth& truth) { return std::hypot(truth.p_MT.y(), truth.p_MT.z()); }
double Depth(const Truth& truth) { return -truth.p_MT.x(); }

std::string Sentence(const char* format, double a, double b = 0.0, double c = 0.0) {
  char text[256];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

std::string TipPlace(const Truth& truth) {
  const double before_mm = -1e3 * Depth(truth);
  return before_mm >= 0.0 ? Sentence("tip %.0f mm before the mouth", before_mm)
                          : Sentence("tip %.0f mm behind the mouth", -before_mm);
}

}  // namespace

const std::vector<OutcomeName>& OutcomeNames() {
  static const std::vector<OutcomeName> names{
      {"docked", true, "tip on the socket's floor, at rest, taut, and held by the shake"},
      {"partly_seated", false,
       "tip at least " + NumberText(OutcomeLimits{}.entered_depth_m) +
           " m deep, at rest, taut, and held by the shake, but not on the socket's floor"},
      {"not_gone", false,
       "held by the shake, but the rover was not as far out as its mission told"},
      {"station_pushed", false,
       "docked, but the station's mouth was pushed by more than " +
           NumberText(OutcomeLimits{}.station_shift_m) + " m"},
      {"station_overload", false, "docked, but the arm loaded the cone above its rating"},
      {"no_detection", false, "fewer than four fiducials found in either image"},
      {"wrong_correspondence", false, "detections matched to the wrong fiducials"},
      {"pose_rejected", false, "fiducials found, but no pose accepted"},
      {"missed_cone", false, "the tip passed the mouth plane outside the mouth"},
      {"face_catch", false, "the tip pressed on the flat face around the mouth"},
      {"jammed", false, "the tip stuck in the cone under pull"},
      {"recovery_limit", false, "the controller gave up after its recoveries"},
      {"gave_up", false, "the controller gave up without a recovery"},
      {"tether_overload", false, "the tether's tension stayed above its working load"},
      {"tipped_over", false,
       "the axle stood on end, or the arm went over the top and was not brought back"},
      {"false_docked", false, "the controller claimed a docking that the truth does not show"},
      {"timeout", false, "the simulated time ran out"},
  };
  return names;
}

OutcomeLimits LimitsOf(const RoverModel& rover, const StationModel& station) {
  // A seated rover turns through its play, from one side to the other, and bends arm and cone a
  // little: the latter measured at up to 1.3 deg; assumed, range 1-2 deg. Commanded are 11 deg.
  constexpr double kBending_rad = Radians(1.5), kMost_rad = Radians(6.0);
  OutcomeLimits limits;
  limits.shake_turn_rad = std::min(kMost_rad, 2.0 * SeatedPlay(rover, station.cone) + kBending_rad);
  return limits;
}

const char* Name(Outcome outcome) {
  return OutcomeNames()[static_cast<std::size_t>(outcome)].name.c_str();
}

SightingQuality JudgeSighting(const SightingReport& report, const Pose3& X_RB_true,
                              const StereoRig& built, const FiducialBoard& board,
                              const OutcomeLimits& limits,
                              const std::array<LensRipple, 2>& ripples) {
  std::array<int, 2> right{}, wrong{};
  for (const SightingReport::Mark& mark : report.marks) {
    if (mark.id < 0 || mark.id >= static_cast<int>(board.fiducials.size())) continue;
    const auto& camera = mark.camera == kRightCamera ? built.right : built.left;
    const Pose3 X_CB = Inverse(mark.camera == kRightCamera ? built.X_RQ : built.X_RL) * X_RB_true;
    const Eigen::Vector2d& p_BF = board.fiducials[mark.id].p_BF;
    const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(p_BF.x(), p_BF.y(), 0.0);
    const auto pixel = ProjectWith(ripples[mark.camera == kRightCamera ? 1 : 0], camera, p_C);
    // A near disc is many pixels wide: a detection within a tenth of its diameter is still right.
    const double gate = std::max(limits.mark_gate_px,
                                 0.1 * camera.focal_px().x() * board.disc_diameter_m / p_C.norm());
    const bool near = pixel && (*pixel - Eigen::Vector2d(mark.u_px, mark.v_px)).norm() < gate;
    ++(near ? right : wrong)[mark.camera == kRightCamera];
  }
  if (wrong[0] + wrong[1] > 0 && (wrong[0] >= right[0] || wrong[1] >= right[1])) {
    return SightingQuality::kWrongCorrespondence;
  }
  if (report.accepted) return SightingQuality::kGood;
  const int detected = std::max(
      {right[0], right[1], report.DetectedBy(kLeftCamera), report.DetectedBy(kRightCamera)});
  return detected < limits.few_marks ? SightingQuality::kUndetected : SightingQuality::kRejected;
}

void OutcomeJudge::Condition::Update(bool holds, double time_s) {
  if (!holds) {
    since_s.reset();
  } else if (!since_s) {
    since_s = time_s;
  }
}

OutcomeJudge::OutcomeJudge(const StationModel& station, const OutcomeLimits& limits)
    : station_(station), limits_(limits) {}

void OutcomeJudge::Observe(const Truth& truth) {
  last_ = truth;
  if (!p_WR_first_) p_WR_first_ = truth.X_WR.p;
  farthest_m_ = std::max(farthest_m_, (truth.X_WR.p - *p_WR_first_).norm());
  const double now = truth.time_s;
  if (!stand_ || (truth.X_WR.p - stand_->p_WR).norm() > limits_.stay_m) {
    stand_ = Stand{truth.X_WR.p, now};
  }
  stand_->rock_force_sum_n += truth.rock_force_n;
  ++stand_->samples;
  const double depth = Depth(truth), lateral = Lateral(truth);
  const double speed = truth.v_MT.norm();

  // By its way: the speed of one instant may be that of a tremble of micrometres between stiff
  // surfaces.
  const bool stays = (truth.p_MT - p_MT_rest_).norm() < limits_.rest_travel_m;
  if (!stays) p_MT_rest_ = truth.p_MT;
  rest_.Update(stays, now);
  const double axle_tilt = std::asin(std::clamp(std::abs(truth.X_WR.R(2, 1)), 0.0, 1.0));
  tilt_peak_rad_ = std::max(tilt_peak_rad_, axle_tilt);
  tipped_.Update(axle_tilt > limits_.tipped_rad, now);
  // A rover turns over and back: this names the run only if it lasts. One that starts with its arm
  // behind did not go over.
  const bool behind = truth.X_WA.R(2, 2) < 0.0;
  const bool went_over = behind && arm_behind_.has_value() && !*arm_behind_;
  flips_ += went_over ? 1 : 0;
  behind_.Update(behind && (went_over || behind_.since_s), now);
  arm_behind_ = behind;
  overload_.Update(truth.tether_tension_n > limits_.overload_n, now);
  fatal_ = fatal_ || tipped_.since_s || overload_.Held(now, limits_.overload_time_s);

  const bool at_face = depth > -0.01 && depth < limits_.catch_depth_m;
  face_.Update(at_face && truth.face_force_n > limits_.catch_force_n, now);
  const bool inside = depth >= limits_.catch_depth_m && lateral < station_.cone.mouth_radius_m;
  jam_.Update(inside && depth < limits_.entered_depth_m && speed < limits_.jam_speed_m_s &&
                  truth.tether_tension_n > limits_.jam_tension_n,
              now);
  missed_.Update(depth > limits_.catch_depth_m && lateral > station_.cone.face_outer_radius_m, now);
}

void OutcomeJudge::ObserveSighting(double time_s, SightingQuality quality) {
  blind_.Update(quality == SightingQuality::kUndetected, time_s);
  confused_.Update(quality == SightingQuality::kWrongCorrespondence, time_s);
  rejected_.Update(quality == SightingQuality::kRejected, time_s);
}

bool OutcomeJudge::fatal() const { return fatal_; }

bool OutcomeJudge::entered_at_rest() const {
  return Depth(last_) >= limits_.entered_depth_m && Lateral(last_) < station_.cone.mouth_radius_m &&
         rest_.Held(last_.time_s, limits_.rest_time_s) && last_.tether_tension_n > limits_.taut_n;
}

std::string OutcomeJudge::StandNote() const {
  if (!stand_ || last_.time_s - stand_->since_s < limits_.stay_time_s) return {};
  const double rock_n = stand_->rock_force_sum_n / static_cast<double>(stand_->samples);
  const double stood_s = last_.time_s - stand_->since_s;
  if (rock_n < limits_.catch_force_n) return Sentence("; stood there for %.0f s", stood_s);
  return Sentence("; stood there for %.0f s with %.0f N on a rock", stood_s, rock_n);
}

std::vector<JudgedLimit> OutcomeJudge::Limits(const ShakeResult& shake) const {
  constexpr LimitSense kAtLeast = LimitSense::kAtLeast, kAtMost = LimitSense::kAtMost;
  const double unjudged = std::nan(""), depth_m = Depth(last_);
  const auto if_judged = [&](bool judged, double value) { return judged ? value : unjudged; };
  const auto lasted_s = [&](const Condition& condition) {
    return condition.since_s ? last_.time_s - *condition.since_s : 0.0;
  };
  const double seat_m = shake.done ? std::min(depth_m, shake.least_depth_m) : depth_m;
  const OutcomeLimits& l = limits_;
  return {
      {"entered_depth_m", "m", "arm tip behind the plane of the cone's mouth, before the shake",
       kAtLeast, depth_m, l.entered_depth_m},
      {"seat_depth_m", "m", "least depth of the tip before and under the shake", kAtLeast, seat_m,
       SeatDepth(station_.cone) - l.seated_within_m},
      {"lateral_m", "m", "arm tip off the cone's axis", kAtMost, Lateral(last_),
       station_.cone.mouth_radius_m},
      {"rest_s", "s", "time that the tip has been at rest", kAtLeast, lasted_s(rest_),
       l.rest_time_s},
      {"tension_n", "N", "of the tether", kAtLeast, last_.tether_tension_n, l.taut_n},
      {"shake_turn_deg", "deg", "turn of the rover under the shake", kAtMost,
       if_judged(shake.done, Degrees(shake.turn_rad)), Degrees(l.shake_turn_rad)},
      {"shake_travel_m", "m", "travel of the tip under the shake", kAtMost,
       if_judged(shake.done, shake.travel_m), l.shake_travel_m},
      {"excursion_m", "m", "largest distance of the axle from where it started", kAtLeast,
       if_judged(l.excursion_m > 0.0, farthest_m_), l.excursion_share * l.excursion_m},
      {"station_shift_m", "m", "mouth from where it was at the start, before the shake", kAtMost,
       last_.station_shift_m, l.station_shift_m},
      {"cone_force_n", "N", "largest force of the arm on the cone", kAtMost,
       if_judged(std::isfinite(station_.cone.rated_force_n), last_.cone_force_peak_n),
       station_.cone.rated_force_n},
      {"axle_tilt_deg", "deg", "largest tilt of the axle", kAtMost, Degrees(tilt_peak_rad_),
       Degrees(l.tipped_rad)},
      {"overload_s", "s", "time with the tether above its working load, up to the end", kAtMost,
       lasted_s(overload_), l.overload_time_s},
      {"face_s", "s", "time with the tip pressed on the face around the mouth, up to the end",
       kAtMost, lasted_s(face_), l.catch_time_s},
      {"jam_s", "s", "time stuck in the cone under pull, up to the end", kAtMost, lasted_s(jam_),
       l.jam_time_s},
  };
}

OutcomeJudge::Verdicted OutcomeJudge::ConcludeHeld(const ShakeResult& shake) const {
  const std::string broken = BrokenLimitsText(Limits(shake));
  const std::string note = Sentence("tip %.0f mm deep, ", 1e3 * Depth(last_)) +
                           (broken.empty() ? "" : broken + ", ") +
                           Sentence("shake turned it %.1f deg and moved it %.1f mm",
                                    Degrees(shake.turn_rad), 1e3 * shake.travel_m);
  if (farthest_m_ < limits_.excursion_share * limits_.excursion_m) return {Outcome::kNotGone, note};
  const double seat = SeatDepth(station_.cone) - limits_.seated_within_m;
  if (std::min(Depth(last_), shake.least_depth_m) < seat) return {Outcome::kPartlySeated, note};
  if (last_.station_shift_m > limits_.station_shift_m) return {Outcome::kStationPushed, note};
  const bool overloaded = last_.cone_force_peak_n > station_.cone.rated_force_n;
  return {overloaded ? Outcome::kStationOverload : Outcome::kDocked, note};
}

OutcomeJudge::Verdicted OutcomeJudge::ConcludeGivenUp(int recoveries) const {
  const std::string where = TipPlace(last_) + StandNote();
  if (recoveries == 0) return {Outcome::kGaveUp, "gave up without a recovery, " + where};
  return {Outcome::kRecoveryLimit, "gave up after " + std::to_string(recoveries) +
                                       (recoveries == 1 ? " recovery, " : " recoveries, ") + where};
}

OutcomeJudge::Verdicted OutcomeJudge::Conclude(Verdict claimed, int recoveries,
                                               const ShakeResult& shake) const {
  const double now = last_.time_s;
  const bool firm = shake.done && shake.turn_rad < limits_.shake_turn_rad &&
                    shake.travel_m < limits_.shake_travel_m;
  if (claimed == Verdict::kDone && entered_at_rest() && firm) return ConcludeHeld(shake);

  struct Candidate {
    Outcome outcome;
    std::optional<double> since_s;
    std::string note;
  };
  std::array<Candidate, 9> candidates{{
      {Outcome::kTippedOver, tipped_.since_s, "the axle stands on end"},
      {Outcome::kTippedOver, behind_.since_s, "the arm went over the top and was not brought back"},
      {Outcome::kTetherOverload,
       overload_.Held(now, limits_.overload_time_s) ? overload_.since_s : std::nullopt,
       Sentence("tension above %.0f N", limits_.overload_n)},
      {Outcome::kFaceCatch, face_.Held(now, limits_.catch_time_s) ? face_.since_s : std::nullopt,
       Sentence("tip pressed on the flat face with %.0f N, %.0f mm off the axis",
                last_.face_force_n, 1e3 * Lateral(last_))},
      {Outcome::kJammed, jam_.Held(now, limits_.jam_time_s) ? jam_.since_s : std::nullopt,
       Sentence("stuck %.0f mm deep under %.0f N", 1e3 * Depth(last_), last_.tether_tension_n)},
      {Outcome::kMissedCone, missed_.since_s,
       Sentence("tip passed the mouth plane %.0f mm off the axis", 1e3 * Lateral(last_))},
      {Outcome::kNoDetection, blind_.since_s, "fewer than four fiducials found in either image"},
      {Outcome::kWrongCorrespondence, confused_.since_s,
       "detections matched to the wrong fiducials"},
      {Outcome::kPoseRejected, rejected_.since_s, "fiducials found, but no pose accepted"},
  }};
  const Candidate* first = nullptr;
  for (const Candidate& candidate : candidates) {
    if (candidate.since_s && (!first || *candidate.since_s < *first->since_s)) first = &candidate;
  }
  if (first) return {first->outcome, first->note};
  switch (claimed) {
    case Verdict::kDone:
      return {Outcome::kFalseDocked,
              "claimed docked; " + BrokenLimitsText(Limits(shake)) +
                  Sentence(", heading %.1f deg against the axis",
                           Degrees(WrapPi(AxleOnGround(last_.X_DR).heading - kPi)))};
    case Verdict::kGivenUp:
      return ConcludeGivenUp(recoveries);
    case Verdict::kUnderWay:
      break;
  }
  return {Outcome::kTimeout, "time ran out, " + TipPlace(last_) + StandNote()};
}

}  // namespace dockyard::axel
