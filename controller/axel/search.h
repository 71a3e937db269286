// The search for a board that was seen before: a fixed, bounded list of moves between image pairs.
// Where it ends, and for a board that was never seen, there is the Seeker.
#pragma once

#include <optional>

#include "controller/axel/options.h"

namespace dockyard::axel {

enum class SearchMove {
  kAgain,    // another image pair: light and noise change
  kTilt,     // pitch the cameras by amount
  kTurn,     // turn in place by amount
  kReel,     // wheels free, reel: the arm swings towards the station and comes nearer [m]
  kAdvance,  // drive on by dead reckoning
  kBackUp,   // too near to go on blindly
  kReverse,  // straight back by amount: away from the station, or out of a hole [m]
};

struct SearchAction {
  SearchMove move = SearchMove::kAgain;
  double amount = 0.0;  // [rad] or [m], counter-clockwise and nose-down positive
};

/// Knowledge while the board is not seen.
struct SearchKnowledge {
  bool board_expected_in_view = false;
  double expected_bearing_rad = 0.0;  // left positive
  double tip_gap_m = 0.0;             // tip to mouth, whichever way
  double tether_rad = 0.0;            // against the arm in plan, left positive
  bool station_slides = false;        // when it is pulled
};

/// Whether the tether is abeam, with room for a pull that turns the rover towards the station.
bool PullFirst(const SearchKnowledge& known, const SearchOptions& options);

/// The move of this attempt, counted from 0 since the board was last seen; none when all were
/// tried. With the tether abeam the rover does not turn by its wheels, which tips it over on loose
/// soil: the tether turns it, seen or not.
std::optional<SearchAction> NextSearchAction(int attempt, const SearchKnowledge& known,
                                             const SearchOptions& options);

}  // namespace dockyard::axel
