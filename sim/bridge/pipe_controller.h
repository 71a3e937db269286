// A controller that is a program of its own, in any language. It gets the sensor readings on its
// standard input and answers on its standard output. The simulation waits for each answer. The
// program never gets the truth. docs/reference/controller_protocol.md defines every byte.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "controller/io/controller.h"
#include "sim/base/json.h"
#include "sim/bridge/process.h"
#include "sim/bridge/program_belief.h"

namespace dockyard {

inline constexpr int kControllerProtocol = 4;

/// The first message to such a controller.
struct ControllerGreeting {
  std::string system;
  Tick control_period = 20;
  int motor_count = 0, camera_count = 0, switch_count = 0;
  Json sensors = Json::array();  // of NamedSensors (sim/log/named_sensor.h)
  std::uint64_t seed = 0;        // for its own random draws; reveals nothing of the world
  Json nominal;
};

/// What a run's program took.
struct ProgramUse {
  double wall_s = 0.0;  // that we waited for it, from its start on
  double cpu_s = 0.0;   // of it and all that it started
};

/// How long it may take, and what it may reach.
struct ProgramLimits {
  double answer_s = 10.0;              // wall time of a message and its whole answer
  Deadline run_end = Deadline::max();  // of the whole run
  double run_s = 0.0;                  // the run's wall time that ends then, for the message
};

/// The program ended, did not answer in time, or answered nonsense. `outcome` is one of
/// ControllerOutcomes, or kStopped.
class ControllerFailure : public std::runtime_error {
 public:
  ControllerFailure(std::string outcome, const std::string& message, std::string messages = "",
                    const ProgramUse& use = {})
      : std::runtime_error(message),
        outcome_(std::move(outcome)),
        messages_(std::move(messages)),
        use_(use) {}
  const std::string& outcome() const { return outcome_; }
  /// The program's output on its standard error.
  const std::string& messages() const { return messages_; }
  const ProgramUse& use() const { return use_; }

 private:
  std::string outcome_, messages_;
  ProgramUse use_;
};

inline constexpr const char* kControllerCrashed = "controller_crashed";
inline constexpr const char* kControllerTimeout = "controller_timeout";
inline constexpr const char* kControllerError = "controller_error";

/// Why a run was stopped after its wall time.
std::string OutOfTime(double run_s);

class PipeController final : public Controller {
 public:
  /// Throws ControllerFailure, also from Step, and IoError.
  PipeController(const ProgramStart& program, const ControllerGreeting& greeting,
                 const ProgramLimits& limits);

  Commands Step(const SensorFrame& sensed) override;
  const Belief& belief() const override { return belief_.belief(); }

  /// Sends the good-bye and waits a little for the program's end, where it still runs.
  void Finish();
  /// The program's output on its standard error.
  const std::string& Messages() const { return process_.Messages(); }
  /// The processor time only after Finish.
  ProgramUse use() const;

 private:
  struct Message {
    char kind = 0;
    std::string payload;
  };
  void Send(char kind, const std::string& payload, Deadline deadline);
  Message Receive(Deadline deadline);
  /// When the answer to a message that starts now must have come.
  Deadline AnswerDeadline() const;
  Commands Answer(Deadline deadline);
  void StopWaiting();
  void CheckHello(const Message& hello);
  void CheckCommands(const Commands& commands) const;
  [[noreturn]] void Fail(Trouble trouble);
  [[noreturn]] void FailBadly(const std::string& what);

  ControllerGreeting greeting_;
  ProgramLimits limits_;
  double waited_s_ = 0.0;  // before waiting_since_
  std::optional<Deadline> waiting_since_ = std::chrono::steady_clock::now();
  Process process_;
  ProgramBelief belief_;
  std::string bytes_;  // kept between calls for its memory
};

}  // namespace dockyard
