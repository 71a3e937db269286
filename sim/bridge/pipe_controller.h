// A controller that is a program of its own, in any language. It gets the sensor readings on its
// standard input and answers on its standard output. The simulation waits for each answer. The
// program never gets the truth. docs/reference/controller_protocol.md defines every byte.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "controller/io/controller.h"
#include "sim/base/json.h"
#include "sim/bridge/process.h"

namespace dockyard {

inline constexpr int kControllerProtocol = 3;

/// The first message to such a controller.
struct ControllerGreeting {
  std::string system;
  Tick control_period = 20;
  int motor_count = 0, camera_count = 0, switch_count = 0, contact_count = 0;
  std::uint64_t seed = 0;  // for its own random draws; reveals nothing of the world
  Json nominal;
};

/// The program ended, did not answer in time, or answered nonsense. `outcome` is one of
/// ControllerOutcomes.
class ControllerFailure : public std::runtime_error {
 public:
  ControllerFailure(std::string outcome, const std::string& message, std::string messages)
      : std::runtime_error(message), outcome_(std::move(outcome)), messages_(std::move(messages)) {}
  const std::string& outcome() const { return outcome_; }
  /// The program's output on its standard error.
  const std::string& messages() const { return messages_; }

 private:
  std::string outcome_, messages_;
};

inline constexpr const char* kControllerCrashed = "controller_crashed";
inline constexpr const char* kControllerTimeout = "controller_timeout";
inline constexpr const char* kControllerError = "controller_error";

class PipeController final : public Controller {
 public:
  /// @param limit_s  wall time from the start of a message to the end of its whole answer
  /// Throws ControllerFailure, also from Step, and IoError.
  PipeController(const std::vector<std::string>& command, const std::filesystem::path& folder,
                 const ControllerGreeting& greeting, double limit_s);

  Commands Step(const SensorFrame& sensed) override;
  const Belief& belief() const override { return belief_; }

  /// Sends the good-bye and waits a little for the program's end.
  void Finish();
  /// The program's output on its standard error.
  std::string Messages() const { return process_.Messages(); }

 private:
  struct Message {
    char kind = 0;
    std::string payload;
  };
  void Send(char kind, const std::string& payload, Deadline deadline);
  Message Receive(Deadline deadline);
  void CheckHello(const Message& hello);
  void CheckCommands(const Commands& commands) const;
  [[noreturn]] void Fail(Trouble trouble);
  [[noreturn]] void FailBadly(const std::string& what);

  ControllerGreeting greeting_;
  double limit_s_;
  Process process_;
  Belief belief_;
  std::string bytes_;  // kept between calls for its memory
};

}  // namespace dockyard
