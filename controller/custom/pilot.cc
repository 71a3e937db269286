#include "controller/custom/pilot.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "controller/base/check.h"
#include "controller/custom/sighting_fix.h"

namespace dockyard::custom {
namespace {

// How far back images may have been exposed; assumed, 2-10 s.
constexpr Tick kKept = 5000;
// By which the estimate may be off after a try that failed. Assumed, 1-5 cm, 1-5 deg.
constexpr double kFailed_m = 0.02, kFailed_rad = Radians(2.0);
// Turns that come about, over those of wheels without slip. Assumed, 0.2-0.5 and 1.1-1.5.
constexpr double kLeastTurn = 0.3, kMostTurn = 1.2;
// Where a contact stayed open the board or the pins are off their drawings, and the same approach
// would miss again: the next ones aim to the left, to the right, and so on. Assumed, 3-8 mm.
constexpr double kShift_m = 0.005;
constexpr double kStagedNear_m = 0.05;  // a robot so near to the staging pose need not back off

/// By how much the docked pose moves after the n-th contact that stayed open, from where it was:
/// 1, -2, 3, ... shifts.
double ShiftOf(int n) { return (n % 2 == 1 ? n : -n) * kShift_m; }

Commands Braked(std::size_t motors) {
  Commands commands;
  commands.motors.resize(motors);
  return commands;
}

}  // namespace

Pilot::Pilot(PilotParts parts)
    : parts_(std::move(parts)),
      odometry_(parts_.nominal, parts_.drive),
      past_(kKept),
      filter_({}, parts_.nominal.has_imu),
      requests_(parts_.nominal, parts_.plan.cameras),
      limits_(parts_.nominal.docking) {
  belief_.values = {{"retries", 0.0},           {"dock_sigma_x_m", 0.0},
                    {"dock_sigma_y_m", 0.0},    {"dock_sigma_yaw_deg", 0.0},
                    {"tag_branches_open", 0.0}, {"contact_voltage_v", 0.0},
                    {"contact_closed", 0.0}};
  belief_.phase = Name(here_.phase);
}

Pose2 Pilot::X_DA() const { return Inverse(filter_.X_OD()) * odometry_.X_OA(); }

/// Of the docked pose in O, along and across x of D [m], and of its heading [rad].
Eigen::Vector3d Pilot::DockedSigma() const {
  const Pose2 X_OD = filter_.X_OD();
  const Eigen::Matrix3d R_DO = RotZ(-X_OD.heading);
  Eigen::Matrix3d P = R_DO * filter_.covariance() * R_DO.transpose();
  Eigen::Matrix3d J = Eigen::Matrix3d::Identity();
  J(0, 2) = -parts_.plan.X_DA_docked.y;
  J(1, 2) = parts_.plan.X_DA_docked.x;
  P = J * P * J.transpose();
  return P.diagonal().cwiseSqrt();
}

Twist Pilot::Enter(Phase phase, const std::string& note) {
  DOCKYARD_CHECK(MayFollow(here_.phase, phase));
  here_ = {.phase = phase, .entered = now_};
  belief_.note = note;
  if (phase == Phase::kPerceive) requests_.Restart();
  if (phase == Phase::kControl) {
    tries_.searched_rad = 0.0;
    tries_.stagings = tries_.searches = 0;
    tries_.wiggled = false;
    tries_.marks_at = tries_.nearer_at = now_;
    tries_.least_left_m = parts_.plan.Left(X_DA());
  }
  return {};
}

Twist Pilot::TryAgain(const std::string& why) {
  const DockingOptions& options = parts_.nominal.docking;
  if (++tries_.retries > options.retries) {
    tries_.retries = options.retries;
    return Enter(Phase::kGivenUp, why + ", after " + std::to_string(options.retries) + " retries");
  }
  if (here_.phase == Phase::kWait && parts_.contact.exists())
    parts_.plan.Shift(ShiftOf(++tries_.opens));
  filter_.Loosen(kFailed_m, kFailed_rad);
  tries_.realigned = 0;
  return LeaveDock(why);
}

/// Back to the staging pose, to measure the dock anew.
Twist Pilot::LeaveDock(const std::string& why) {
  const bool is_in = MayFollow(here_.phase, Phase::kBackOff);
  if (is_in) tries_.back_m = parts_.nominal.docking.staging_m - parts_.plan.Left(X_DA());
  if (is_in && tries_.back_m > kStagedNear_m) return Enter(Phase::kBackOff, why);
  return Enter(Phase::kPerceive, why);
}

void Pilot::ReadSensors(const SensorFrame& sensed) {
  const double dt_s = now_ == 0 ? 0.0 : kTickSeconds * static_cast<double>(sensed.tick - now_);
  now_ = sensed.tick;
  const Motion motion = odometry_.Read(sensed);
  filter_.Drive(odometry_.X_OA(), motion, dt_s);
  here_.driven_m += motion.length_m;
  here_.turned_rad += motion.turn_rad;
  past_.Add({now_, odometry_.X_OA(), parts_.nominal.has_imu ? sensed.imu : ImuSample{}});
  parts_.contact.Read(sensed);
  if (parts_.nominal.has_imu)
    parts_.drive.turn_share = std::clamp(odometry_.turn_share(), kLeastTurn, kMostTurn);
  requests_.Read(sensed);
}

void Pilot::TakeImage(const CameraImage& image) {
  const auto& used = requests_.cameras();
  if (std::find(used.begin(), used.end(), image.camera) == used.end()) return;
  if (!past_.Holds(image.exposed)) return;
  const PastMoment then = past_.Nearest(image.exposed);
  for (const BoardSighting& sighting : parts_.perceive(image, UpIn(then.imu))) See(sighting, then);
}

void Pilot::See(const BoardSighting& sighting, const PastMoment& then) {
  ++belief_.sighting_count;
  SightingReport report = ReportOf(sighting, parts_.nominal);
  if (!sighting.branches.empty()) {
    const Pose2 X_OR = then.X_OR * Inverse(parts_.drive.X_RA);  // then.X_OR is X_OA
    report.accepted = filter_.See(FixesOf(sighting, parts_.nominal, X_OR, then.imu));
    if (!report.accepted) report.reason = "contradicts the floor or the odometry";
  }
  if (report.accepted) {
    ++here_.fixes;
    tries_.marks_at = now_;
  }
  belief_.last_sighting = std::move(report);
}

Commands Pilot::Step(const SensorFrame& sensed) {
  ReadSensors(sensed);
  if (TakesImages(here_.phase)) {
    for (const CameraImage& image : sensed.images) TakeImage(image);
  }
  const Twist twist = limits_.Step(Act(), parts_.nominal.control_period_s);
  const bool over = here_.phase == Phase::kDocked || here_.phase == Phase::kGivenUp;
  Commands commands =
      over ? Braked(parts_.nominal.motors.size()) : RunAt(parts_.drive, parts_.nominal, twist);
  if (TakesImages(here_.phase)) requests_.AskDue(now_, &commands);
  if (here_.phase == Phase::kDocked) commands.verdict = Verdict::kDone;
  if (here_.phase == Phase::kGivenUp) commands.verdict = Verdict::kGivenUp;
  Believe();
  return commands;
}

Twist Pilot::Act() {
  static constexpr std::array<Twist (Pilot::*)(), kPhaseCount> kSteps{
      &Pilot::PerceiveDock, &Pilot::Search,    &Pilot::TurnTo,  &Pilot::Stage,
      &Pilot::Face,         &Pilot::TurnRound, &Pilot::Control, &Pilot::Press,
      &Pilot::Wait,         &Pilot::Wiggle,    &Pilot::BackOff};
  const auto step = kSteps[static_cast<std::size_t>(here_.phase)];
  if (step == nullptr) return {};
  if (here_.For(now_) > Most_s(here_.phase))
    return TryAgain(std::string("no end of ") + Name(here_.phase));
  return (this->*step)();
}

void Pilot::Believe() {
  belief_.phase = Name(here_.phase);
  belief_.located = filter_.located();
  belief_.values[0].value = tries_.retries;
  belief_.values[4].value = filter_.open() ? 1.0 : 0.0;
  belief_.values[5].value = parts_.contact.voltage_v();
  belief_.values[6].value = parts_.contact.closed() ? 1.0 : 0.0;
  if (!filter_.located()) return;
  belief_.X_DR = X_DA() * Inverse(parts_.drive.X_RA);
  const Eigen::Vector3d sigma = DockedSigma();
  belief_.values[1].value = sigma.x();
  belief_.values[2].value = sigma.y();
  belief_.values[3].value = Degrees(sigma.z());
}

}  // namespace dockyard::custom
