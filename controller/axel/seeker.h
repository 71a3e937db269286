// The search for a board that was never seen, or that is lost for good: the tether leads to it.
//
// With free wheels the tether turns the arm towards the station, as wind turns a vane. So the rover
// pulls and looks until its yaw no longer changes: the station is then ahead of it. What it does
// not see from there it looks for a little to each side, never with the tether abeam, and from
// nearer.
#pragma once

#include <optional>
#include <vector>

#include "controller/axel/options.h"
#include "controller/axel/search.h"

namespace dockyard::axel {

/// Where an image pair did not show the board.
struct SeekerPlace {
  double yaw_rad = 0.0;        // inertial
  double reeled_m = 0.0;       // tether taken up since power-on
  double rolled_m = 0.0;       // along the heading since power-on
  double elevation_rad = 0.0;  // of the arm
};

/// What a pull by the spool, wheels free, did to the rover.
enum class PullResult {
  kTurned,     // the arm swung towards the station
  kAligned,    // it came nearer along its heading: the station is ahead
  kBackwards,  // it was drawn along backwards: the station is behind
  kStuck,      // little tether came in
};
PullResult JudgePull(const SeekerPlace& before, const SeekerPlace& after,
                     const SearchOptions& options);

/// Chooses the moves between image pairs. Mirrored places give mirrored moves, but for turns
/// after a pull that turned the rover to neither side: they begin to the left.
class Seeker {
 public:
  explicit Seeker(const SearchOptions& options) : options_(options) {}

  /// The move after an image pair without the board; none when all round the tether's direction was
  /// looked at as near as the tether brings it.
  std::optional<SearchAction> Next(const SeekerPlace& here);

 private:
  void TakePull(const SeekerPlace& here);
  void PlanSweep(const SeekerPlace& here);
  bool LookedAt(const SeekerPlace& here, double yaw_rad) const;
  std::optional<SearchAction> Planned(const SeekerPlace& here);

  SearchOptions options_;
  std::vector<SeekerPlace> looked_;
  std::optional<SearchAction> last_;
  double side_ = 1.0;  // to which the last pull turned it
  double pulled_m_ = 0.0;
  int stuck_ = 0;
  bool tilted_ = false;
  // Moves planned, the next one first. The amount of a turn is the yaw to turn to.
  std::vector<SearchAction> planned_;
};

}  // namespace dockyard::axel
