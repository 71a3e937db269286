#include "sim/run/recorded_controller.h"

#include <cmath>
#include <string>
#include <utility>

#include "sim/bridge/pipe_controller.h"
#include "sim/log/frame_codec.h"

namespace dockyard {
namespace {

/// The readings without the images, as the log's bytes have them.
std::string ReadingsOf(SensorFrame sensed) {
  sensed.images.clear();
  std::string bytes;
  PutFrame(bytes, sensed, ImageCoding::kRaw);
  return bytes;
}

}  // namespace

RecordedController::RecordedController(const Folder& log_dir)
    : run_(ReadLoggedRun(log_dir)), log_(log_dir), next_(log_.Next()) {
  if (!run_.complete) throw DataError("the log is cut short: it does not hold all commands");
}

Commands RecordedController::Step(const SensorFrame& sensed) {
  if (!next_) EndOfLog();
  RunLogEntry entry = *std::move(next_);
  next_ = log_.Next();
  if (ReadingsOf(entry.sensed) != ReadingsOf(sensed)) {
    throw DataError("the log, at tick " + std::to_string(entry.sensed.tick) +
                    ": its readings are not those of this world");
  }
  TakeBelief(sensed.tick);
  return std::move(entry.commands);
}

// A program says what it believes before it answers: a sample holds it with the next one. The last
// sample is of the run's end.
void RecordedController::TakeBelief(Tick tick) {
  const double time_s = (static_cast<double>(tick) + 0.5) * kTickSeconds;
  while (samples_ < run_.times_s.size() && run_.times_s[samples_] <= time_s) ++samples_;
  const std::size_t at = next_ ? samples_ : run_.times_s.size();
  if (at == 0) return;
  belief_.values.clear();
  for (const auto& [name, values] : run_.belief) {
    if (!std::isnan(values[at - 1])) belief_.values.push_back({name, values[at - 1]});
  }
}

void RecordedController::EndOfLog() const {
  const std::string outcome =
      run_.outcome.is_object() ? run_.outcome.value("outcome", std::string()) : std::string();
  for (const char* failed : {kControllerCrashed, kControllerTimeout, kControllerError}) {
    if (outcome == failed) {
      throw ControllerFailure(outcome, run_.outcome.value("failure_note", std::string()), "");
    }
  }
  throw DataError("the log ends before the run does");
}

}  // namespace dockyard
