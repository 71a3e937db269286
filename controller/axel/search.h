// What to do when the board is not seen: a fixed, bounded list of things to try between looks.
#pragma once

#include <optional>

#include "controller/axel/options.h"

namespace dockyard::axel {

enum class SearchMove {
  kAgain,    // light and noise change
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

/// What is known while not seeing.
struct SearchKnowledge {
  bool located = false;
  bool board_expected_in_view = false;
  double expected_bearing_rad = 0.0;  // left positive
  double tip_gap_m = 0.0;
};

/// The attempt-th thing to try since the board was last seen, from 0; none when all were tried.
std::optional<SearchAction> NextSearchAction(int attempt, const SearchKnowledge& known,
                                             const SearchOptions& options);

}  // namespace dockyard::axel
