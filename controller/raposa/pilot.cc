#include "controller/raposa/pilot.h"

#include <array>
#include <cmath>

#include "controller/base/check.h"
#include "controller/motion/limits.h"
#include "controller/raposa/drive.h"
#include "controller/raposa/lean.h"
#include "controller/raposa/picture_report.h"

namespace dockyard::raposa {
namespace {

// A belief that changes by more, while the robot manoeuvres, is of another pose. Assumed, 0.1-0.3
// m, 8-20 deg.
constexpr double kOther_m = 0.2, kOther_rad = Radians(12.0);
// After so many pictures in which nothing fits the belief, every third is looked at without it.
// Assumed, 3-10 and 2-5.
constexpr int kFitless = 5, kAfresh = 3;

FerreiraMotion SearchOptions(const DockyardOptions& options) {
  FerreiraMotion search;
  search.search_turn_rad_s = options.search_rad_s;
  search.first_search_rad = options.first_search_rad;
  search.most_search_rad = 16.0 * options.first_search_rad;
  return search;
}

bool Moves(const Twist& twist) { return twist.speed_m_s != 0.0 || twist.turn_rad_s != 0.0; }

/// sure: of the angle. Without that nothing is claimed.
void Believe(const PyramidFilter& filter, bool sure, Belief* belief) {
  belief->located = sure;
  belief->values[4].value = filter.gauge_share();
  if (!sure) return;
  const Pose2 X_DN = filter.X_DN();
  belief->X_DR = {X_DN.x, X_DN.y, WrapPi(X_DN.heading + kPi)};
  belief->values[1].value = Degrees(filter.alpha_rad());
  belief->values[2].value = filter.range_m();
}

}  // namespace

Pilot::Pilot(const Nominal& nominal, const DockyardOptions& options)
    : nominal_(nominal),
      options_(options),
      belts_(nominal, options),
      filter_(nominal, options),
      doors_(nominal, options),
      search_(SearchOptions(options)),
      kept_{.door_open_m = nominal.door_travel_m} {
  belief_.phase = Name(here_.phase);
  belief_.values = {
      {"state", 0.0}, {"alpha_deg", 0.0}, {"r_m", 0.0}, {"passes", 0.0}, {"gauge_share", 1.0}};
}

ImageHints Pilot::Hints() const {
  ImageHints hints;
  hints.pitch_rad = CameraPitch(nominal_) + LeanOf(nominal_, belts_.arm_rad());
  hints.refuted = refuted_.things();
  // Where no image fits what is believed, one is searched afresh now and then.
  const bool afresh =
      round_.hypothetical || (guide_.fitless > kFitless && guide_.fitless % kAfresh == 0);
  if (!filter_.located() || afresh) return hints;
  hints.prior = filter_.Prior();
  hints.prior->covariance *= options_.prior_share * options_.prior_share;
  hints.prior->covariance.diagonal() +=
      Eigen::Vector3d(options_.prior_m, options_.prior_m, options_.prior_rad).cwiseAbs2();
  return hints;
}

void Pilot::Enter(Phase phase, const std::string& note) {
  DOCKYARD_CHECK(MayFollow(here_.phase, phase));
  here_ = {.phase = phase, .entered = now_};
  belief_.note = note;
  if (phase == Phase::kClose) doors_.Begin();
  if (phase != Phase::kTurn && phase != Phase::kLeg) tries_.crossing = false;
}

void Pilot::ReadDrives(const SensorFrame& sensed) {
  now_ = sensed.tick;
  doors_.Read(sensed);
  const auto steps = belts_.Read(sensed, Moves(kept_.twist));
  if (!steps) return;
  turned_rad_ = (steps->right_m - steps->left_m) / steps->gauge_m;
  const double driven_m = -0.5 * (steps->left_m + steps->right_m);
  here_.driven_m += driven_m;
  const double turn_rad = filter_.gauge_share() * turned_rad_;
  tries_.from_start_rad += turn_rad;
  const Pose2 X_NV = CameraInPlan(nominal_);
  refuted_.Move(
      Inverse(X_NV) *
      Pose2{driven_m * std::cos(0.5 * turn_rad), driven_m * std::sin(0.5 * turn_rad), turn_rad} *
      X_NV);
  Carry(turn_rad, std::abs(driven_m), &guide_);
  filter_.Drive(*steps);
}

void Pilot::TakeImage(const PyramidSighting& sighting, double age_s) {
  const bool fits = !sighting.fits.empty();
  ++belief_.sighting_count;
  belief_.last_sighting =
      ReportOf(sighting, fits ? filter_.PlacedBy(sighting.fits.front(), age_s) : Pose2{}, nominal_);
  for (const PyramidSighting::Known& known : sighting.known) {
    refuted_.Correct(known.thing, known.bearing_rad);
  }
  Take(sighting, now_, &guide_);
  if (fits) ++here_.fits;
  if (round_.hypothetical && fits) {
    round_.hypothetical = false;
    filter_.Forget();
    filter_.See(sighting, age_s);
    return Enter(Phase::kLook, "marks in view");
  }
  const bool was = filter_.located();
  const Pose2 before = was ? filter_.X_DN() : Pose2{};
  filter_.See(sighting, age_s);
  if (fits && filter_.agrees()) ++here_.agreed;
  const Phase phase = here_.phase;
  if (!was || (phase != Phase::kTurn && phase != Phase::kLeg && phase != Phase::kFace)) return;
  const Pose2 change = Inverse(before) * filter_.X_DN();
  if (std::hypot(change.x, change.y) > kOther_m || std::abs(change.heading) > kOther_rad) {
    Enter(Phase::kLook, "the pyramid stands otherwise than thought");
  }
}

Commands Pilot::Step(const SensorFrame& sensed, const PyramidSighting* sighting, double age_s) {
  ReadDrives(sensed);
  if (sighting != nullptr && Looks()) TakeImage(*sighting, age_s);
  kept_.twist = Act();
  Commands commands = BrakedCommands();
  if (Moves(kept_.twist)) {
    // drive.h reckons with the gauge of a level arm.
    const double share = belts_.gauge_m() / nominal_.effective_gauge_m;
    SetBelts(nominal_, {kept_.twist.speed_m_s, share * kept_.twist.turn_rad_s}, &commands);
  }
  SetArm(nominal_, kept_.arm_rad, &commands);
  SetDoors(nominal_, kept_.door_open_m, &commands);
  if (Looks()) commands.take_images = {kBackCamera};
  commands.switches[kLamps] = kept_.lamps ? 1 : 0;
  commands.verdict = here_.phase == Phase::kDocked    ? Verdict::kDone
                     : here_.phase == Phase::kGivenUp ? Verdict::kGivenUp
                                                      : Verdict::kUnderWay;
  belief_.phase = Name(here_.phase);
  belief_.values[0].value = static_cast<double>(here_.phase);
  belief_.values[3].value = tries_.passes;
  Believe(filter_, !round_.hypothetical && SureOfAngle(filter_, options_), &belief_);
  KeepLimits(nominal_.motors, &commands);
  return commands;
}

Twist Pilot::Act() {
  static constexpr std::array<Twist (Pilot::*)(), kPhaseCount> kSteps{
      &Pilot::Look,  &Pilot::Search,   &Pilot::Creep, &Pilot::Glance,   &Pilot::Back,
      &Pilot::Turn,  &Pilot::DriveLeg, &Pilot::Face,  &Pilot::Approach, &Pilot::Brake,
      &Pilot::Close, &Pilot::Ajar,     &Pilot::Prove, &Pilot::Retreat};
  const auto step = kSteps[static_cast<std::size_t>(here_.phase)];
  if (step == nullptr) return {};
  if (here_.For(now_) > options_.phase_s) {
    TryAgain(std::string("no end of ") + Name(here_.phase));
    return {};
  }
  return (this->*step)();
}

bool Pilot::Looks() const {
  const bool blind =
      here_.phase == Phase::kApproach && filter_.located() && filter_.range_m() <= options_.blind_m;
  // The likelier of two poses may change with each image; the leg across belongs to one of them.
  return TakesImages(here_.phase) && !blind && !tries_.crossing;
}

}  // namespace dockyard::raposa
