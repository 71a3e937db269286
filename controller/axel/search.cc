#include "controller/axel/search.h"

#include <array>
#include <cmath>

namespace dockyard::axel {
namespace {

// First towards where it should be, then on by dead reckoning. Turns go towards the
// side where it is expected first, so that a mirrored start gives mirrored moves.
std::optional<SearchAction> Listed(int attempt, const SearchKnowledge& known,
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

bool PullFirst(const SearchKnowledge& known, const SearchOptions& options) {
  return !known.station_slides && std::abs(known.tether_rad) > options.tether_rad &&
         known.tip_gap_m > options.reel_m + options.pull_room_m;
}

std::optional<SearchAction> NextSearchAction(int attempt, const SearchKnowledge& known,
                                             const SearchOptions& options) {
  const std::optional<SearchAction> action = Listed(attempt, known, options);
  const bool turns = attempt == 0 || (action && action->move == SearchMove::kTurn);
  if (action && turns && PullFirst(known, options))
    return SearchAction{SearchMove::kReel, options.reel_m};
  return action;
}

}  // namespace dockyard::axel
