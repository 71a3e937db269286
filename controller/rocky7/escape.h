// What a rover does that comes no nearer to its target: it backs off, by what its back cameras
// show, and comes again by another path.
#pragma once

#include "controller/imaging/image_request.h"
#include "controller/rocky7/ground_behind.h"
#include "controller/rocky7/pair_work.h"
#include "controller/rocky7/retreat.h"

namespace dockyard::rocky7 {

struct EscapeOptions {
  // The number of pairs in a row that came no nearer, near the target: in sand short arcs slip by
  // more than they correct, and a wheel may be held by a stone. 0: never.
  int most_stalls = 0;
  double near_m = 1e9;          // from the target
  bool ground_as_body = false;  // the ground behind is taken to be parallel to the body
};

class Escape {
 public:
  Escape(const Nominal& nominal, const EscapeOptions& options);

  /// An image pair that has the point so far off the target. True: it backs off now.
  bool Decide(double off_m);
  /// It waits for the back pair, in Observe, before the first arc.
  bool awaits_pair() const { return awaits_pair_; }
  /// Asks for the pair and decides by it. Without an answer it backs off all the same.
  void Observe(const SensorFrame& sensed, Commands& commands);
  bool backs_off() const { return retreat_.HasArcs(); }
  /// The next arc back.
  Arc Next() { return retreat_.Next(); }

 private:
  const Nominal nominal_;
  const EscapeOptions options_;
  Retreat retreat_;
  GroundBehind behind_;
  PairWork work_;
  ImageRequest request_;
  bool awaits_pair_ = false;
};

}  // namespace dockyard::rocky7
