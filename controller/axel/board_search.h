// The search of a rover that does not find the board: which move is next, and the moves by wheels
// and tether.
#pragma once

#include <optional>

#include "controller/axel/search.h"
#include "controller/axel/seeker.h"
#include "controller/axel/senses.h"
#include "controller/axel/tether_pull.h"

namespace dockyard::axel {

class BoardSearch {
 public:
  BoardSearch(const Nominal& nominal, const AxelOptions& options)
      : nominal_(nominal), options_(options), seeker_(options.search), pull_(nominal, options) {}

  /// Chooses the next move.
  void Begin(const Senses& senses, const SearchKnowledge& known);
  /// None: all were tried.
  const std::optional<SearchAction>& action() const { return action_; }
  /// A turn, a pull or a reverse since then. Whether it is over.
  bool Move(const Senses& senses, const Moment& since, Commands* commands);
  /// The board was found.
  void Found();

  /// Whether a rover that has found the board pulls before it drives: with the tether so far aside
  /// that driving would tip it over, and not for ever.
  bool PullsFirst(const SearchKnowledge& known);
  /// Whether a leg ends here: on sand a rover that drives with the tether abeam tips its arm over.
  bool StopsAbeam(const SearchKnowledge& known) const;
  void Seek() { seeking_ = true; }
  void Drives() { seeking_ = false; }
  /// Whether a pull has pulled the station along.
  bool station_slides() const { return pull_.slid(); }

 private:
  Nominal nominal_;
  AxelOptions options_;
  Seeker seeker_;
  TetherPull pull_;
  int attempts_ = 0, turning_pulls_ = 0;
  bool seeking_ = true;  // it has not driven since the board was lost
  std::optional<SearchAction> action_;
};

}  // namespace dockyard::axel
