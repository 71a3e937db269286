// State 5: rotate until something is seen, over a range that widens (F, D).
#pragma once

#include "controller/raposa/nominal/ferreira_options.h"

namespace dockyard::raposa {

/// Turns to the side opposite to the last rotation. After a certain angle it changes the side; the
/// angle doubles at each change and stays below a full turn.
class WideningSearch {
 public:
  explicit WideningSearch(const FerreiraMotion& options) : options_(options) {}
  /// Begins anew. last_turn_rad: of the last rotation, to the left; its side is what counts.
  void Begin(double last_turn_rad);
  bool begun() const { return begun_; }
  void End() { begun_ = false; }
  /// Turning rate, with the turn since the last call.
  double Step(double turned_rad);

 private:
  FerreiraMotion options_;
  bool begun_ = false;
  double side_ = 1.0, leg_rad_ = 0.0, done_rad_ = 0.0;
};

}  // namespace dockyard::raposa
