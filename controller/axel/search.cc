#include "controller/axel/search.h"

#include <array>

namespace dockyard::axel {
namespace {

// Never seen: the tether is the only pointer to the station. Turns go left first.
std::optional<SearchAction> Lost(int attempt, const SearchOptions& options) {
  const std::array<SearchAction, 9> list = {{{SearchMove::kAgain, 0.0},
                                             {SearchMove::kTilt, options.tilt_rad},
                                             {SearchMove::kTilt, -options.tilt_rad},
                                             {SearchMove::kReel, options.reel_m},
                                             {SearchMove::kAgain, 0.0},
                                             {SearchMove::kReel, options.reel_m},
                                             {SearchMove::kTurn, options.turn_rad},
                                             {SearchMove::kTurn, -2.0 * options.turn_rad},
                                             {SearchMove::kReel, options.reel_m}}};
  if (attempt >= static_cast<int>(list.size())) return std::nullopt;
  return list[static_cast<std::size_t>(attempt)];
}

// Seen before: first towards where it should be, then on by dead reckoning. Turns go towards the
// side where it is expected first, so that a mirrored start gives mirrored moves.
std::optional<SearchAction> Remembering(int attempt, const SearchKnowledge& known,
                                        const SearchOptions& options) {
  const double side = known.expected_bearing_rad < 0.0 ? -1.0 : 1.0;
  const bool near = known.tip_gap_m < options.near_gap_m;
  const std::array<SearchAction, 9> list = {{{SearchMove::kAgain, 0.0},
                                             {SearchMove::kTilt, options.tilt_rad},
                                             {SearchMove::kTilt, -options.tilt_rad},
                                             {SearchMove::kAdvance, options.advance_m},
                                             {SearchMove::kAgain, 0.0},
                                             {SearchMove::kTurn, side * options.turn_rad},
                                             {SearchMove::kTurn, -2.0 * side * options.turn_rad},
                                             {SearchMove::kAdvance, options.advance_m},
                                             {SearchMove::kAgain, 0.0}}};
  if (attempt >= static_cast<int>(list.size())) return std::nullopt;
  if (attempt == 0 && !known.board_expected_in_view)
    return SearchAction{SearchMove::kTurn, known.expected_bearing_rad};
  const SearchAction action = list[static_cast<std::size_t>(attempt)];
  if (action.move == SearchMove::kAdvance && near) return SearchAction{SearchMove::kBackUp, 0.0};
  return action;
}

}  // namespace

std::optional<SearchAction> NextSearchAction(int attempt, const SearchKnowledge& known,
                                             const SearchOptions& options) {
  return known.located ? Remembering(attempt, known, options) : Lost(attempt, options);
}

}  // namespace dockyard::axel
