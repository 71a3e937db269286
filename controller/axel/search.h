// The search for a board that is not seen: a fixed, bounded list of moves between image pairs.
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
};

struct SearchAction {
  SearchMove move = SearchMove::kAgain;
  double amount = 0.0;  // [rad] or [m], counter-clockwise and nose-down positive
};

/// Knowledge while the board is not seen.
struct SearchKnowledge {
  bool located = false;
  bool board_expected_in_view = false;
  double expected_bearing_rad = 0.0;  // left positive
  double tip_gap_m = 0.0;
};

/// The move of this attempt, counted from 0 since the board was last seen; none when all were
/// tried.
std::optional<SearchAction> NextSearchAction(int attempt, const SearchKnowledge& known,
                                             const SearchOptions& options);

}  // namespace dockyard::axel
