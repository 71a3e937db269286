#include "sim/run/loop.h"
#include "sim/run/image_thinning.h"

#include <ctime>

#include <algorithm>
#include <cmath>

#include "controller/base/check.h"
#include "controller/base/split_mix.h"
#include "models/read/config_error.h"
#include "sim/base/hash.h"
#include "sim/base/random.h"
#include "sim/bridge/pipe_controller.h"
#include "sim/bridge/sandbox.h"
#include "sim/log/record_files.h"
#include "sim/log/run_log.h"
#include "sim/log/value_table.h"
#include "sim/run/camera_faults.h"
#include "sim/run/recorded_controller.h"
#include "sim/run/sensor_link.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard {
namespace {

constexpr Tick kHistoryPeriod = 100;  // 10 Hz
constexpr Tick kGroundPeriod = 1000;  // of the log: ruts change slowly
constexpr Tick kHashPeriod = 1000;    // the fingerprint takes in the whole state every second

double Clock(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Images of all cameras count as one word, so that a robot with one pair keeps its fingerprint.
std::uint64_t HashCommands(std::uint64_t hash, const Commands& commands, int camera_count) {
  for (const MotorCommand& motor : commands.motors) {
    hash = HashBits(hash, static_cast<std::uint64_t>(motor.mode));
    hash = HashDouble(hash, motor.target);
    hash = HashDouble(hash, motor.speed_limit_rad_s);
    hash = HashDouble(hash, motor.accel_rad_s2);
    hash = HashDouble(hash, motor.current_limit_a);
  }
  hash = HashBits(hash, !commands.take_images.empty());
  const auto taken = static_cast<int>(commands.take_images.size());
  if (taken > 0 && taken < camera_count) {
    for (const int camera : commands.take_images) {
      hash = HashBits(hash, static_cast<std::uint64_t>(camera));
    }
  }
  // Only where there is one, so that a run without brackets keeps its fingerprint.
  if (taken > 0 && commands.exposure_stops != 0.0) {
    hash = HashDouble(hash, commands.exposure_stops);
  }
  for (const std::uint8_t on : commands.switches) hash = HashBits(hash, on);
  return HashBits(hash, static_cast<std::uint64_t>(commands.verdict));
}

std::string SuccessWordOf(const System& system, const ReadyRun& ready) {
  if (!ready.success_word.empty()) return ready.success_word;
  const auto success = std::find_if(system.columns.outcomes.begin(), system.columns.outcomes.end(),
                                    [](const OutcomeName& each) { return each.success; });
  return success == system.columns.outcomes.end() ? "" : success->name;
}

/// One run under way: plant, controller, judge and their records.
class Run {
 public:
  Run(const System& system, const CampaignRun& what, const RunOptions& options)
      : system_(system),
        what_(what),
        options_(options),
        ready_(system.make_ready(what.scenario)),
        clock_(ready_.camera_times),
        link_(what.scenario.camera_faults, what.scenario.seed, ready_.camera_times),
        sensors_(ready_.sensors, what.scenario.seed),
        thinning_(what.scenario.log_image_gap_s),
        sensed_(ready_.sensors.size(), std::nan("")) {
    RequireAllowed(what.scenario, options);
    record_.result = StartOfRow(what);
    record_.result.success_word = SuccessWordOf(system, ready_);
    record_.columns = system.Columns(options.labels);
    record_.channels = system.columns.channels;
    record_.belief_columns = system.columns.beliefs;
    record_.sensors = ready_.sensors;
    if (!options.log_dir.empty()) {
      log_ = std::make_unique<RunLogWriter>(
          options.log_dir,
          RunLogHeader{.run = what.run,
                       .seed = what.scenario.seed.number,
                       .system = system.name,
                       .controller = what.scenario.controller,
                       .images_kept = what.scenario.log_images && options.log_images,
                       .nominal = ready_.nominal,
                       .motors = ready_.motors,
                       .cameras = ready_.cameras,
                       .sensors = ready_.sensors,
                       .channels = system.columns.channels,
                       .beliefs = system.columns.beliefs,
                       .commands_alone = options.log_commands_alone,
                       .image_gap_s = what.scenario.log_image_gap_s},
          YamlWithoutFolders(what.scenario, options.results_dir.string()));
    }
  }

  RunRecord Execute() {
    const auto time_limit = static_cast<Tick>(std::llround(what_.scenario.time_limit_s * 1e3));
    Commands commands;
    commands.motors.resize(static_cast<std::size_t>(ready_.motor_count));
    try {
      if (options_.run_limit_s > 0.0) end_ = DeadlineIn(options_.run_limit_s);
      controller_ = MakeController(system_, what_, ready_, options_);
      pipe_ = dynamic_cast<PipeController*>(controller_.get());
      Drive(time_limit, commands);
    } catch (const ControllerFailure& failure) {
      failure_ = failure;
    }
    if (pipe_) pipe_->Finish();
    // The run's last sample is of its end, wherever that lies between two periods.
    if (controller_) KeepSample(controller_->belief());
    Finish(commands);
    if (pipe_) {
      KeepUse(pipe_->Messages(), pipe_->use());
    } else if (failure_) {
      KeepUse(failure_->messages(), failure_->use());
    }
    return std::move(record_);
  }

 private:
  void KeepUse(const std::string& messages, const ProgramUse& use) {
    record_.messages = messages;
    record_.timing.controller_cpu_s = use.cpu_s;
    record_.timing.controller_wall_s = use.wall_s;
  }

  /// After its wall time the run is lost, as in a campaign.
  void RequireTime() const {
    if (options_.run_limit_s <= 0.0 || std::chrono::steady_clock::now() < end_) return;
    throw ControllerFailure(kStopped, OutOfTime(options_.run_limit_s));
  }

  void Drive(Tick time_limit, Commands& commands) {
    while (commands.verdict == Verdict::kUnderWay && plant().tick() < time_limit &&
           !ready_.judge->fatal()) {
      RequireTime();
      SensorFrame sensed = plant().Sense();
      sensed_ = sensed.values = sensors_.Pass(sensed.values, sensed.tick);
      const std::vector<int> exposing = clock_.Due(commands.take_images, sensed.tick);
      if (!exposing.empty() &&
          !link_.Send(plant().TakeImages(exposing, commands.exposure_stops), sensed.tick)) {
        ready_.judge->ObserveLostImages();
      }
      sensed.images = link_.Receive(sensed.tick);
      record_.result.images += static_cast<int>(sensed.images.size());
      commands = controller_->Step(sensed);
      if (log_) {
        const bool thinned =
            !sensed.images.empty() && !thinning_.Keeps(sensed.tick, controller_->belief().phase);
        log_->Append(sensed, commands, thinned);
      }
      hash_ = HashCommands(hash_, commands, ready_.camera_count);
      Keep(sensed.tick);
      plant().Advance(commands);
    }
  }

  Plant& plant() const { return *ready_.plant; }
  double time_s() const { return static_cast<double>(plant().tick()) * kTickSeconds; }

  /// Scores and stores the state of this control period.
  void Keep(Tick tick) {
    ready_.judge->Observe();
    const Belief& belief = controller_->belief();
    if (belief.sighting_count > sightings_ && belief.last_sighting) KeepSighting(belief);
    if (what_.scenario.command.empty()) ready_.judge->ObserveBelief(belief);
    if (belief.plan_count > plans_) {
      plans_ = belief.plan_count;
      record_.plans.push_back({time_s(), belief.plan});
      if (log_) log_->Append(record_.plans.back(), tick);
    }
    if (IsDue(tick, kHistoryPeriod)) KeepSample(belief);
    if (IsDue(tick, kHashPeriod)) hash_ = plant().StateHash(hash_);
  }

  /// Whether the control period that ends now is the first to reach a multiple of `every`.
  bool IsDue(Tick tick, Tick every) const {
    return tick == 0 || tick / every > (tick - ready_.control_period) / every;
  }

  void KeepSample(const Belief& belief) {
    record_.history.push_back(Sample(belief));
    if (!log_) return;
    LogTruth(plant().tick());
    log_->AppendValues(record_.value_names, record_.history.back().values, plant().tick());
  }

  void LogTruth(Tick tick) {
    const Stage stage = plant().Look();
    log_->Append(record_.history.back(), stage, tick);
    if (IsDue(tick, kGroundPeriod)) log_->AppendGround(stage.ground, tick);
  }

  void KeepSighting(const Belief& belief) {
    sightings_ = belief.sighting_count;
    SightingSample sample{.time_s = time_s(),
                          .X_DR = plant().X_DR(),
                          .report = *belief.last_sighting,
                          .X_DR_measured = {}};
    if (sample.report.accepted) sample.X_DR_measured = plant().MeasuredPose(sample.report);
    // A program numbers its marks as it likes; the judge knows the target's numbers alone.
    if (what_.scenario.command.empty()) ready_.judge->ObserveSighting(sample.report);
    if (log_) log_->Append(sample, plant().tick());
    record_.sightings.push_back(std::move(sample));
  }

  HistorySample Sample(const Belief& belief) {
    HistorySample sample{
        .time_s = time_s(),
        .X_DR = plant().X_DR(),
        .channels = {},
        .sensed = sensed_,
        .phase = belief.phase,
        .located = belief.located,
        .X_DR_believed = belief.X_DR,
        .sighting_count = belief.sighting_count,
        .plan_count = belief.plan_count,
        .beliefs = {},
        .values = FurtherValues(belief, record_.belief_columns, record_.value_names)};
    plant().AppendChannels(sample.channels);
    for (const Column& column : record_.belief_columns) {
      sample.beliefs.push_back(ValueOf(belief, column.name, std::nan("")));
    }
    return sample;
  }

  /// While the judge tries a claim, the history goes on under the judge's phase. Its last sample is
  /// of the trial's end.
  Conclusion Conclude(const Commands& commands) {
    Belief belief = controller_ ? controller_->belief() : Belief{};
    Tick kept = plant().tick();
    const auto watch = [&](const char* phase) {
      belief.phase = phase;
      if (plant().tick() - kept < kHistoryPeriod) return;
      kept = plant().tick();
      KeepSample(belief);
    };
    Conclusion conclusion = ready_.judge->Conclude(commands, belief, watch);
    if (plant().tick() != kept) KeepSample(belief);
    return conclusion;
  }

  /// The measures of the row: the judge's, then a margin for each limit that the system names.
  std::vector<double> WithMargins(const Conclusion& conclusion) const {
    std::vector<double> measures = conclusion.measures;
    const std::vector<Column>& columns = record_.columns.measures;
    DOCKYARD_CHECK(measures.size() + conclusion.limits.size() == columns.size());
    for (const JudgedLimit& limit : conclusion.limits) {
      DOCKYARD_CHECK(columns[measures.size()].name.ends_with("." + limit.name));
      measures.push_back(limit.margin());
    }
    return measures;
  }

  void Finish(const Commands& commands) {
    RunResult& row = record_.result;
    row.sim_time_s = time_s();
    Conclusion conclusion = Conclude(commands);
    if (failure_) {
      conclusion.outcome = failure_->outcome();
      conclusion.note = failure_->what();
    }
    row.outcome = conclusion.outcome;
    row.success = record_.columns.IsSuccess(conclusion.outcome);
    if (!IsLost(row.outcome)) row.measures = WithMargins(conclusion);
    record_.limits = std::move(conclusion.limits);
    record_.failure_note = conclusion.note;
    row.state_hash = plant().FinalHash(hash_);
    if (!log_) return;
    log_->AppendGround(plant().Look().ground, plant().tick());
    log_->Note("outcome", row.outcome + ": " + conclusion.note, plant().tick());
    log_->Finish(OutcomeJson(record_));
  }

  const System& system_;
  const CampaignRun& what_;
  const RunOptions& options_;
  ReadyRun ready_;
  CameraClock clock_;
  ImageLink link_;
  SensorLink sensors_;
  ImageThinning thinning_;
  std::vector<double> sensed_;  // last
  std::unique_ptr<Controller> controller_;
  PipeController* pipe_ = nullptr;  // the controller, if it is a program
  std::optional<ControllerFailure> failure_;
  std::unique_ptr<RunLogWriter> log_;
  RunRecord record_;
  int sightings_ = 0, plans_ = 0;
  std::uint64_t hash_ = kHashSeed;
  Deadline end_{};  // with a limit of wall time
};

}  // namespace

void RequireAllowed(const Scenario& scenario, const RunOptions& options) {
  if (scenario.command.empty() || options.recorded_dir) return;
  if (!options.allow_commands) {
    throw ConfigError(scenario.name +
                      ": controller.command: it starts a program; allow it with --allow-commands");
  }
  HideMemory();
  if (!options.sandbox) return;
  RequireSandbox();
  InSandbox(scenario.command, scenario.command_folder, options.results_dir);
}

std::uint64_t SeedOfProgram(std::uint64_t controller_seed, int run) {
  return SplitMix(StreamKey(controller_seed, "controller"), static_cast<std::uint64_t>(run));
}

std::unique_ptr<Controller> MakeController(const System& system, const CampaignRun& run,
                                           const ReadyRun& ready, const RunOptions& options) {
  if (options.recorded_dir) {
    return std::make_unique<RecordedController>(*options.recorded_dir);
  }
  const Scenario& scenario = run.scenario;
  RequireAllowed(scenario, options);
  if (scenario.script.kind != YamlNode::Kind::kNull) {
    if (system.play) return system.play(ready.nominal, scenario.script);
    throw ConfigError(scenario.script.place.Text() + ": script: expected none, as the system " +
                      system.name + " takes no script");
  }
  if (scenario.command.empty()) {
    return system.RequireController(scenario.controller).make(ready.nominal);
  }
  ProgramLimits limits{.answer_s = options.answer_limit_s};
  if (options.run_limit_s > 0.0) {
    limits.run_s = options.run_limit_s;
    limits.run_end = DeadlineIn(limits.run_s);
  }
  return std::make_unique<PipeController>(
      options.sandbox ? InSandbox(scenario.command, scenario.command_folder, options.results_dir)
                      : ProgramStart{scenario.command, scenario.command_folder, {}, {}},
      ControllerGreeting{.system = system.name,
                         .control_period = ready.control_period,
                         .motor_count = ready.motor_count,
                         .camera_count = ready.camera_count,
                         .switch_count = ready.switch_count,
                         .sensors = ToJson(ready.sensors),
                         .seed = SeedOfProgram(scenario.controller_seed, run.run),
                         .nominal = ready.nominal},
      limits);
}

bool StartsProgram(const RunResult& row) { return row.controller == "command"; }

RunResult StartOfRow(const CampaignRun& run) {
  RunResult row;
  row.run = run.run;
  row.seed = run.scenario.seed.number;
  row.system = run.scenario.system;
  row.controller = run.scenario.controller;
  row.labels = run.labels;
  return row;
}

RunRecord Simulate(const System& system, const CampaignRun& run, const RunOptions& options) {
  const double cpu = Clock(CLOCK_PROCESS_CPUTIME_ID), wall = Clock(CLOCK_MONOTONIC);
  RunRecord record = Run(system, run, options).Execute();
  record.timing.cpu_time_s = Clock(CLOCK_PROCESS_CPUTIME_ID) - cpu;
  record.timing.wall_time_s = Clock(CLOCK_MONOTONIC) - wall;
  return record;
}

}  // namespace dockyard
