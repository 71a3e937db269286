#include "sim/run/recorded_controller.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "sim/bridge/pipe_controller.h"
#include "sim/log/frame_codec.h"
#include "sim/log/pose_numbers.h"

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
  const auto past = [&](double each_s) { return !next_ || each_s <= time_s; };
  while (samples_ < run_.times_s.size() && past(run_.times_s[samples_])) ++samples_;
  if (samples_ > 0) TakeSample(samples_ - 1);
  while (notes_ < run_.notes.size() && past(run_.notes[notes_].time_s)) {
    const LoggedNote& note = run_.notes[notes_++].value;
    if (note.name == "phase") belief_.phase = note.text;
  }
  const auto count = static_cast<std::size_t>(belief_.sighting_count);
  if (count == run_.sightings.size() || !past(run_.sightings[count].time_s)) return;
  ++belief_.sighting_count;  // a program reports one with an answer
  belief_.last_sighting = run_.sightings[count].report;
}

void RecordedController::TakeSample(std::size_t at) {
  belief_.values.clear();
  std::array<double, 6> pose{};
  const auto add = [&](const std::string& name, double value) {
    if (!std::isnan(value)) belief_.values.push_back({name, value});
  };
  for (const auto& [name, values] : run_.belief) {
    const double value = values[at];
    const auto part = std::find(kPoseNames.begin(), kPoseNames.end(), name);
    if (name == "located") {
      belief_.located = value != 0.0;
    } else if (part != kPoseNames.end()) {
      pose[static_cast<std::size_t>(part - kPoseNames.begin())] = value;
    } else {
      add(name, value);
    }
  }
  belief_.X_DR = PoseFromNumbers(pose);
  for (const auto& [name, values] : run_.values) add(name, values[at]);
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
