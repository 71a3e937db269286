// The sighting of a rover at rest: an image pair is asked for until it comes, and once more
// with other exposures where one does not hold the board.
#pragma once

#include <optional>

#include "controller/axel/axel.h"
#include "controller/axel/bracket.h"
#include "controller/axel/senses.h"
#include "controller/imaging/image_request.h"

namespace dockyard::axel {

class StopSighting {
 public:
  StopSighting(const Nominal& nominal, const AxelOptions& options)
      : patience_{options.look.image_limit, options.look.unanswered_asks, true},
        settle_(options.look.settle),
        bracket_(options.bracket, nominal) {}

  /// A stop begins.
  void Begin(Tick now);
  /// Another sighting from the same stop, once the body is at rest.
  void Again(Tick now) { settle_from_ = now; }
  /// The board as located, once images have come.
  std::optional<LocateOutput> Step(const SensorFrame& sensed, const Senses& senses,
                                   const Locator& locate, Commands* commands);
  /// No camera has answered, however often it was asked.
  bool unanswered() const { return unanswered_; }

 private:
  std::optional<LocateOutput> StepBracket(const SensorFrame& sensed, const Senses& senses,
                                          const Locator& locate, Commands* commands);

  ImagePatience patience_;
  Tick settle_;
  Bracket bracket_;
  ImageRequest request_;
  Tick settle_from_ = 0;
  Tick answer_wait_ = 0;  // the patience with which the last pair came
  bool unanswered_ = false;
};

}  // namespace dockyard::axel
