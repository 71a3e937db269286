#include "sim/run/loop.h"

#include <ctime>

#include <algorithm>
#include <cmath>

#include "sim/base/hash.h"
#include "sim/log/result_row.h"
#include "sim/log/run_log.h"
#include "sim/physics/sensors.h"
#include "sim/physics/world.h"
#include "sim/run/build_run.h"
#include "sim/run/outcome.h"
#include "sim/run/shake.h"
#include "sim/run/view.h"

namespace dockyard {
namespace {

constexpr Tick kHistoryPeriod = 100;  // 10 Hz
constexpr Tick kHashPeriod = 1000;    // the fingerprint takes in the whole state every second
constexpr Tick kSettleTicks = 2000;   // after a claim: time to come to rest before the shake

double Clock(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Mean and peak of currents drawn while anything is driven.
struct CurrentMeter {
  double sum = 0.0, peak = 0.0;
  long count = 0;
  void Add(double current_a) {
    if (current_a > 0.0) {
      sum += current_a;
      ++count;
    }
    peak = std::max(peak, current_a);
  }
  double mean() const { return count ? sum / static_cast<double>(count) : 0.0; }
};

std::uint64_t HashCommands(std::uint64_t hash, const Commands& commands) {
  for (const MotorCommand& motor : commands.motors) {
    hash = HashBits(hash, static_cast<std::uint64_t>(motor.mode));
    hash = HashDouble(hash, motor.target);
    hash = HashDouble(hash, motor.speed_limit_rad_s);
    hash = HashDouble(hash, motor.accel_rad_s2);
    hash = HashDouble(hash, motor.current_limit_a);
  }
  hash = HashBits(hash, commands.take_images);
  return HashBits(hash, static_cast<std::uint64_t>(commands.verdict));
}

/// One run under way: the world, the eyes, the brain and what is kept of them.
class Run {
 public:
  Run(const CampaignRun& what, const ControllerFactory& make_controller, const RunOptions& options)
      : what_(what),
        built_(BuildRun(what.scenario)),
        world_(built_.world),
        sensors_(built_.world.rover, what.scenario.seed),
        controller_(make_controller(what.scenario.controller, built_.sheet)),
        scene_(built_.world.rover, built_.world.station, built_.world.soil, built_.lighting,
               what.scenario.X_WG, what.scenario.seed),
        judge_(built_.world.station, limits_) {
    CheckStart(built_, world_.truth());
    record_.result = StartOfRow(what);
    record_.cone = built_.world.station.cone;
    if (!options.log_dir.empty()) {
      log_ = std::make_unique<RunLogWriter>(options.log_dir,
                                            RunLogHeader{.run = what.run,
                                                         .seed = what.scenario.seed,
                                                         .controller = what.scenario.controller,
                                                         .images_kept = what.scenario.log_images,
                                                         .sheet = built_.sheet});
    }
  }

  RunRecord Execute() {
    const auto time_limit = static_cast<Tick>(std::llround(what_.scenario.time_limit_s * 1e3));
    Commands commands;
    while (commands.verdict == Verdict::kUnderWay && world_.tick() < time_limit &&
           !judge_.fatal()) {
      const SensorFrame sensed = Sense(commands.take_images);
      commands = controller_->Step(sensed);
      if (log_) log_->Append(sensed, commands);
      hash_ = HashCommands(hash_, commands);
      Keep(sensed);
      Advance(commands);
    }
    Finish(commands);
    return std::move(record_);
  }

 private:
  SensorFrame Sense(bool take_images) {
    truth_ = world_.truth();
    SensorFrame sensed = sensors_.Read(world_.tick(), truth_, world_.TakeTrueImu());
    if (take_images) sensed.images = TakeImages();
    return sensed;
  }

  StereoImages TakeImages() {
    // Made at the first picture: a run without eyes needs no context.
    if (!renderer_) renderer_ = std::make_unique<StereoRenderer>();
    const SensorOptions sensor =
        CameraSensor(built_.world.rover.stereo, what_.scenario.seed, record_.result.image_pairs++);
    return renderer_->Render(scene_.Make(truth_, world_.ground()), built_.built_rig, truth_.X_WR,
                             sensor);
  }

  /// Scores and stores what this control period showed.
  void Keep(const SensorFrame& sensed) {
    judge_.Observe(truth_);
    const Belief& belief = controller_->belief();
    if (belief.sighting_count > sightings_ && belief.last_sighting) KeepSighting(belief);
    if (belief.plan_count > plans_) {
      plans_ = belief.plan_count;
      record_.plans.push_back({truth_.time_s, belief.plan});
    }
    for (int i = 0; i < 2; ++i) wheel_current_.Add(truth_.motor_current_a[i]);
    spool_current_.Add(truth_.motor_current_a[static_cast<int>(Motor::kSpool)]);
    record_.result.cone_force_peak_n =
        std::max(record_.result.cone_force_peak_n, truth_.cone_force_n);
    record_.tension_peak_n = std::max(record_.tension_peak_n, truth_.tether_tension_n);
    if (sensed.tick % kHistoryPeriod == 0) record_.history.push_back(Sample(belief));
    if (sensed.tick % kHashPeriod == 0) hash_ = world_.StateHash(hash_);
  }

  void KeepSighting(const Belief& belief) {
    sightings_ = belief.sighting_count;
    SightingSample sample{.time_s = truth_.time_s,
                          .X_DR = ToGround(truth_.X_DR),
                          .report = *belief.last_sighting,
                          .X_DR_measured = {}};
    if (sample.report.accepted) {
      sample.X_DR_measured = ToGround(built_.sheet.X_DB * Inverse(sample.report.X_RB));
    }
    const Pose3 X_RB = Inverse(truth_.X_WR) * truth_.X_WS * BoardInStation(built_.world.station);
    judge_.ObserveLook(truth_.time_s, JudgeLook(sample.report, X_RB, built_.built_rig,
                                                built_.sheet.board, limits_));
    record_.sightings.push_back(std::move(sample));
  }

  HistorySample Sample(const Belief& belief) const {
    const RollPitchYaw rpy = ToRollPitchYaw(truth_.X_WR.R);
    return {.time_s = truth_.time_s,
            .X_DR = ToGround(truth_.X_DR),
            .z_m = truth_.X_DR.p.z(),
            .roll_rad = rpy.roll,
            .pitch_rad = rpy.pitch,
            .arm_rad = truth_.arm_rad,
            .tip_depth_m = -truth_.p_MT.x(),
            .tip_lateral_m = std::hypot(truth_.p_MT.y(), truth_.p_MT.z()),
            .tension_n = truth_.tether_tension_n,
            .cone_force_n = truth_.cone_force_n,
            .station_shift_m = truth_.station_shift_m,
            .left_current_a = truth_.motor_current_a[0],
            .right_current_a = truth_.motor_current_a[1],
            .spool_current_a = truth_.motor_current_a[3],
            .left_sinkage_m = truth_.left_sinkage_m,
            .right_sinkage_m = truth_.right_sinkage_m,
            .phase = belief.phase,
            .located = belief.located,
            .X_DR_believed = belief.X_DR,
            .sighting_count = belief.sighting_count,
            .plan_count = belief.plan_count,
            .recoveries = belief.recoveries};
  }

  void Advance(const Commands& commands) {
    const int steps = static_cast<int>(
        std::llround(kControlPeriod * kTickSeconds / what_.scenario.physics_step_s));
    for (int i = 0; i < steps; ++i) world_.Step(commands.motors);
  }

  void Finish(const Commands& commands) {
    RunResult& row = record_.result;
    ShakeResult shake;
    row.sim_time_s = world_.tick() * kTickSeconds;
    if (commands.verdict == Verdict::kDocked) {
      for (Tick t = 0; t < kSettleTicks; t += kControlPeriod) {
        truth_ = world_.truth();
        judge_.Observe(truth_);
        Advance(commands);
      }
    }
    truth_ = world_.truth();
    judge_.Observe(truth_);
    FillRow();
    if (judge_.at_rest_home()) shake = Shake(world_, built_.world.rover);
    const auto verdict = judge_.Conclude(commands.verdict, controller_->belief().recoveries, shake);
    row.outcome = verdict.outcome;
    row.docked = verdict.outcome == Outcome::kDocked;
    record_.failure_note = verdict.note;
    // The ruts sum up all that the wheels did: once, at the end, is enough.
    for (const double height : world_.ground().heights_m) hash_ = HashDouble(hash_, height);
    row.state_hash = world_.StateHash(hash_);
    if (log_) log_->Finish();
  }

  void FillRow() {
    RunResult& row = record_.result;
    row.recoveries = controller_->belief().recoveries;
    row.tip_depth_m = -truth_.p_MT.x();
    row.lateral_error_m = std::hypot(truth_.p_MT.y(), truth_.p_MT.z());
    row.yaw_error_deg = Degrees(WrapPi(ToGround(truth_.X_DR).heading - kPi));
    row.station_shift_m = truth_.station_shift_m;
    row.spool_current_mean_a = spool_current_.mean();
    row.spool_current_peak_a = spool_current_.peak;
    row.wheel_current_mean_a = wheel_current_.mean();
    row.wheel_current_peak_a = wheel_current_.peak;
  }

  const CampaignRun& what_;
  const OutcomeLimits limits_{};
  BuiltRun built_;
  World world_;
  SensorSuite sensors_;
  std::unique_ptr<Controller> controller_;
  SceneBuilder scene_;
  std::unique_ptr<StereoRenderer> renderer_;
  std::unique_ptr<RunLogWriter> log_;
  OutcomeJudge judge_;
  Truth truth_{};
  RunRecord record_;
  CurrentMeter wheel_current_, spool_current_;
  int sightings_ = 0, plans_ = 0;
  std::uint64_t hash_ = kHashSeed;
};

}  // namespace

RunRecord RunDocking(const CampaignRun& run, const ControllerFactory& make_controller,
                     const RunOptions& options) {
  const double cpu = Clock(CLOCK_PROCESS_CPUTIME_ID), wall = Clock(CLOCK_MONOTONIC);
  RunRecord record = Run(run, make_controller, options).Execute();
  record.timing = {Clock(CLOCK_PROCESS_CPUTIME_ID) - cpu, Clock(CLOCK_MONOTONIC) - wall};
  return record;
}

}  // namespace dockyard
