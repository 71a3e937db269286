#include "sim/bridge/pipe_controller.h"

#include <algorithm>
#include <cmath>

#include "sim/base/text.h"
#include "sim/bridge/answer_json.h"
#include "sim/log/column.h"
#include "sim/log/frame_codec.h"

namespace dockyard {
namespace {

using Clock = std::chrono::steady_clock;

constexpr char kHello = 'H', kFrame = 'F', kCommands = 'C', kBelief = 'B', kBye = 'X';
constexpr std::uint32_t kLongestAnswer = 1u << 20;
constexpr double kByeSeconds = 2.0;
// Beliefs before one answer; assumed, 10-100 000. A controller has one in each control period.
constexpr int kMostBeliefs = 1000;

std::string LastLine(const std::string& text) {
  const std::size_t end = text.find_last_not_of(" \n\r\t");
  if (end == std::string::npos) return "";
  const std::size_t begin = text.find_last_of('\n', end);
  return text.substr(begin == std::string::npos ? 0 : begin + 1,
                     end - (begin == std::string::npos ? 0 : begin + 1) + 1);
}

/// For a note, which goes into CSV, JSON and a terminal: a program may have written any bytes.
std::string Printable(std::string text) {
  constexpr std::size_t kMost = 300;
  if (text.size() > kMost) text = text.substr(0, kMost) + " ...";
  for (char& c : text) {
    if (c < 0x20 || c > 0x7e) c = '?';
  }
  return text;
}

}  // namespace

PipeController::PipeController(const ProgramStart& program, const ControllerGreeting& greeting,
                               const ProgramLimits& limits)
    : greeting_(greeting), limits_(limits), process_(program), belief_(greeting.camera_count) {
  const Json hello{{"protocol", kControllerProtocol},
                   {"system", greeting.system},
                   {"control_period_ms", greeting.control_period},
                   {"motors", greeting.motor_count},
                   {"cameras", greeting.camera_count},
                   {"switches", greeting.switch_count},
                   {"sensors", greeting.sensors},
                   {"seed", greeting.seed},
                   {"nominal", greeting.nominal}};
  const Deadline deadline = AnswerDeadline();
  Send(kHello, hello.dump(), deadline);
  CheckHello(Receive(deadline));
  StopWaiting();
}

Deadline PipeController::AnswerDeadline() const {
  return std::min(DeadlineIn(limits_.answer_s), limits_.run_end);
}

void PipeController::CheckHello(const Message& hello) {
  if (hello.kind != kHello) FailBadly("a first message that is no hello");
  try {
    const Json json = AnswerFrom(hello.payload);
    const Json protocol = json.value("protocol", Json());
    if (!protocol.is_number_integer()) throw AnswerError("no whole number as its protocol");
    if (protocol == kControllerProtocol) return;
    FailBadly("a hello: it speaks protocol " + protocol.dump() + ", expected " +
              std::to_string(kControllerProtocol));
  } catch (const AnswerError& error) {
    FailBadly(std::string("a bad hello: ") + error.what());
  }
}

void PipeController::Send(char kind, const std::string& payload, Deadline deadline) {
  std::string head;
  PutU32(head, static_cast<std::uint32_t>(payload.size()));
  head += kind;
  Trouble trouble = process_.Write(head, deadline);
  if (trouble == Trouble::kNone) trouble = process_.Write(payload, deadline);
  // A program that has ended may have said why: what it wrote before is read first. Else the
  // outcome would depend on which of the two was faster.
  if (trouble != Trouble::kNone && trouble != Trouble::kEnded) Fail(trouble);
}

PipeController::Message PipeController::Receive(Deadline deadline) {
  std::string head;
  Trouble trouble = process_.Read(5, deadline, head);
  if (trouble != Trouble::kNone) Fail(trouble);
  const std::uint32_t length = ByteReader(head).U32();
  if (length > kLongestAnswer) {
    FailBadly("a message of " + std::to_string(length) +
              " bytes; does it print to its standard output?");
  }
  Message message{head[4], {}};
  trouble = process_.Read(length, deadline, message.payload);
  if (trouble != Trouble::kNone) Fail(trouble);
  return message;
}

Commands PipeController::Step(const SensorFrame& sensed) {
  bytes_.clear();
  PutFrame(bytes_, sensed, ImageCoding::kRaw);
  // One deadline for the frame and all that answers it, else beliefs could go on for ever.
  const Deadline deadline = AnswerDeadline();
  waiting_since_ = Clock::now();
  Send(kFrame, bytes_, deadline);
  Commands commands = Answer(deadline);
  StopWaiting();
  return commands;
}

Commands PipeController::Answer(Deadline deadline) {
  for (int beliefs = 0;; ++beliefs) {
    if (beliefs > kMostBeliefs) {
      FailBadly("more than " + std::to_string(kMostBeliefs) + " beliefs before its commands");
    }
    const Message message = Receive(deadline);
    try {
      if (message.kind == kBelief) {
        belief_.Take(AnswerFrom(message.payload));
        continue;
      }
      if (message.kind != kCommands) {
        FailBadly("a message of unknown kind; does it print to its standard output?");
      }
      ByteReader in(message.payload);
      const Commands commands = TakeCommands(in);
      if (!in.AtEnd()) FailBadly("commands longer than their content");
      CheckCommands(commands);
      belief_.EndAnswer();
      return commands;
    } catch (const DataError& error) {
      FailBadly(std::string("bad commands: ") + error.what());
    } catch (const AnswerError& error) {
      FailBadly(std::string("a bad belief: ") + error.what());
    }
  }
}

void PipeController::CheckCommands(const Commands& commands) const {
  const auto bad = [](const std::string& what) { throw DataError(what); };
  if (commands.motors.size() != static_cast<std::size_t>(greeting_.motor_count)) {
    bad("expected " + std::to_string(greeting_.motor_count) + " motors, found " +
        std::to_string(commands.motors.size()));
  }
  for (const MotorCommand& motor : commands.motors) {
    if (!std::isfinite(motor.target) || !(motor.speed_limit_rad_s >= 0.0) ||
        !(motor.accel_rad_s2 >= 0.0) || !(motor.current_limit_a >= 0.0) ||
        !std::isfinite(motor.speed_limit_rad_s + motor.accel_rad_s2 + motor.current_limit_a)) {
      bad("a motor's numbers and the sum of its limits must be finite, no limit negative");
    }
  }
  for (const int camera : commands.take_images) {
    if (camera < 0 || camera >= greeting_.camera_count) {
      bad("there is no camera " + std::to_string(camera));
    }
    if (std::count(commands.take_images.begin(), commands.take_images.end(), camera) > 1) {
      bad("camera " + std::to_string(camera) + " is asked for twice");
    }
  }
  if (!commands.switches.empty() &&
      commands.switches.size() != static_cast<std::size_t>(greeting_.switch_count)) {
    bad("expected " + std::to_string(greeting_.switch_count) + " switches, found " +
        std::to_string(commands.switches.size()));
  }
}

void PipeController::Finish() {
  StopWaiting();
  waiting_since_ = Clock::now();
  bytes_.assign(4, '\0');
  bytes_ += kBye;
  process_.Write(bytes_, DeadlineIn(kByeSeconds));
  process_.End(kByeSeconds);
  StopWaiting();
}

void PipeController::StopWaiting() {
  waited_s_ = use().wall_s;
  waiting_since_.reset();
}

ProgramUse PipeController::use() const {
  const double now_s =
      waiting_since_ ? std::chrono::duration<double>(Clock::now() - *waiting_since_).count() : 0.0;
  return {waited_s_ + now_s, process_.cpu_time_s()};
}

void PipeController::Fail(Trouble trouble) {
  const std::string how = process_.End(trouble == Trouble::kEnded ? kByeSeconds : 0.0);
  const auto failure = [&](const char* outcome, const std::string& what) {
    return ControllerFailure(outcome, what, process_.Messages(), use());
  };
  if (trouble == Trouble::kTooLarge) {
    const SharedLimits& shared = process_.limits();
    throw failure(
        kControllerCrashed,
        "the controller's program was ended: with all that it started it took more than " +
            std::to_string(shared.threads) + " threads or " + std::to_string(shared.memory_mib) +
            " MiB of main memory");
  }
  if (trouble == Trouble::kLate && Clock::now() >= limits_.run_end) {
    throw failure(kStopped, OutOfTime(limits_.run_s));
  }
  if (trouble == Trouble::kLate) {
    throw failure(kControllerTimeout, "the controller's program gave no whole answer within " +
                                          NumberText(limits_.answer_s) + " s");
  }
  const std::string last = Printable(LastLine(process_.Messages()));
  throw failure(kControllerCrashed,
                "the controller's program ended: " + how + (last.empty() ? "" : ", " + last));
}

void PipeController::FailBadly(const std::string& what) {
  process_.End(0.0);
  throw ControllerFailure(kControllerError, "the controller's program sent " + Printable(what),
                          process_.Messages(), use());
}

std::string OutOfTime(double run_s) {
  return "it took more than " + NumberText(run_s) + " s of wall time";
}

}  // namespace dockyard
