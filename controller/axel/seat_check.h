// Where the reel-in has stopped: the tether is drawn taut and the spool braked, under which nothing
// may slip, an image is taken, and an arm that leans in it is straightened.
#pragma once

#include <optional>

#include "controller/axel/axel.h"
#include "controller/axel/mating.h"
#include "controller/axel/sighting.h"
#include "controller/imaging/image_request.h"

namespace dockyard::axel {

class SeatCheck {
 public:
  SeatCheck(const Nominal& nominal, const AxelOptions& options)
      : nominal_(nominal), options_(options), still_(options.tether.still_m) {}

  void Begin();
  /// Whether it is over. in_phase: since the reel-in stopped.
  bool Step(const SensorFrame& sensed, Tick in_phase, const Locator& locate, SightingJudge* judge,
            Senses* senses, Commands* commands);
  /// By the image; none if it does not show the board.
  const std::optional<TipSeen>& tip() const { return tip_; }
  double slipped_m(const Senses& senses) const;

 private:
  bool Steadied(const Senses& senses, Tick in_phase, Commands* commands);
  bool TookImage(const SensorFrame& sensed, const Locator& locate, SightingJudge* judge,
                 Senses* senses, Commands* commands);
  bool TautAgain(const Senses& senses, Commands* commands);
  MotorCommand DrawnTaut(const Senses& senses) const;

  Nominal nominal_;
  AxelOptions options_;
  StillWatch still_;
  ImageRequest request_;
  struct Braked {
    Tick since = 0;
    double reeled_m = 0.0;
  };
  std::optional<Braked> braked_;
  bool took_image_ = false;
  std::optional<TipSeen> tip_;
  std::optional<Straighten> straighten_;
  std::optional<Tick> taut_from_, again_;  // after that: drawn taut, braked
};

}  // namespace dockyard::axel
