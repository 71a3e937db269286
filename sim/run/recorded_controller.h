// A controller that gives the commands that a log has, in place of a program that is not here.
#pragma once

#include <cstddef>
#include <optional>

#include "controller/io/controller.h"
#include "sim/log/logged_run.h"
#include "sim/log/run_log.h"

namespace dockyard {

class RecordedController final : public Controller {
 public:
  /// Throws IoError, and DataError for a log that is damaged or cut short.
  explicit RecordedController(const Folder& log_dir);

  /// The commands of the log's next frame. Throws DataError where the readings are not those of the
  /// log, bit for bit: the commands answer another world. Images are not compared. Throws
  /// ControllerFailure where the log ends because the program failed.
  Commands Step(const SensorFrame& sensed) override;
  /// The log's newest belief: phase, pose and values of its history, and the newest sighting.
  const Belief& belief() const override { return belief_; }

 private:
  void TakeBelief(Tick tick);
  void TakeSample(std::size_t at);
  [[noreturn]] void EndOfLog() const;

  LoggedRun run_;
  RunLogReader log_;
  std::optional<RunLogEntry> next_;
  Belief belief_;
  std::size_t samples_ = 0, notes_ = 0;  // up to now
};

}  // namespace dockyard
