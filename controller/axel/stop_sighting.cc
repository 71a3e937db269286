#include "controller/axel/stop_sighting.h"

#include "controller/axel/moving_looks.h"
#include "controller/axel/sighting.h"

namespace dockyard::axel {

void StopSighting::Begin(Tick now) {
  request_ = {};
  unanswered_ = false;
  bracket_.NewStop();
  Again(now);
}

std::optional<LocateOutput> StopSighting::Step(const SensorFrame& sensed, const Senses& senses,
                                               const Locator& locate, Commands* commands) {
  if (bracket_.under_way()) return StepBracket(sensed, senses, locate, commands);
  if (const std::optional<StereoImages> images = AnswerTo(request_, sensed)) {
    answer_wait_ = WaitOf(request_, patience_);
    request_ = {};
    const LocateHints hints = HintsFrom(senses);
    const LocateOutput seen = locate(*images, hints);
    if (!bracket_.Begins(*images, seen, hints)) return seen;
    return StepBracket(sensed, senses, locate, commands);
  }
  if (senses.now() - settle_from_ < settle_) return std::nullopt;
  const RequestState state = StateOf(request_, patience_, senses.now());
  unanswered_ = state == RequestState::kUnanswered;
  if (state == RequestState::kDue)
    Ask({kLeftCamera, kRightCamera}, senses.now(), &request_, commands);
  return std::nullopt;
}

// Images of other exposures are waited for as long as the first pair was, and not asked for again.
std::optional<LocateOutput> StopSighting::StepBracket(const SensorFrame& sensed,
                                                      const Senses& senses, const Locator& locate,
                                                      Commands* commands) {
  const ImagePatience patience{.wait = answer_wait_};
  if (AnswerTo(request_, sensed)) {
    bracket_.Take(GrayImageOf(sensed, kLeftCamera), GrayImageOf(sensed, kRightCamera));
    request_ = {};
  } else if (StateOf(request_, patience, senses.now()) == RequestState::kUnanswered) {
    bracket_.Stop();
  }
  if (bracket_.under_way()) {
    if (request_.asked) return std::nullopt;
    Ask({kLeftCamera, kRightCamera}, senses.now(), &request_, commands);
    commands->exposure_stops = bracket_.stops();
    return std::nullopt;
  }
  request_ = {};
  std::optional<LocateOutput> merged;
  if (bracket_.HasMore()) merged = locate(bracket_.Merged(), HintsFrom(senses));
  return bracket_.Better(merged);
}

}  // namespace dockyard::axel
