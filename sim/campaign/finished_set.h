// Which runs of a campaign have a result: what a program needs to go on, a byte for each run.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sim/campaign/shard_file.h"

namespace dockyard {

/// Counts of finished runs.
struct Tally {
  std::int64_t done = 0, successes = 0, lost = 0;  // lost: crashed or stopped
  std::map<std::string, std::int64_t> failures;    // by outcome, lost runs included
};

class FinishedSet {
 public:
  explicit FinishedSet(std::int64_t run_count) : states_(static_cast<std::size_t>(run_count), 0) {}

  std::int64_t run_count() const { return static_cast<std::int64_t>(states_.size()); }
  bool Has(std::int64_t index) const { return StateOf(index) != 0; }
  bool Lost(std::int64_t index) const { return Has(index) && OutcomeOf(index).lost; }
  /// A result takes the place of a lost run, never the other way round.
  void Add(std::int64_t index, bool success, std::string_view outcome);
  /// Of the shard's runs.
  Tally TallyOf(const Shard& shard) const;

 private:
  struct Outcome {
    std::string name;
    bool success = false, lost = false;
  };
  std::uint8_t StateOf(std::int64_t index) const {
    return states_[static_cast<std::size_t>(index)];
  }
  const Outcome& OutcomeOf(std::int64_t index) const { return outcomes_[StateOf(index) - 1u]; }

  std::vector<std::uint8_t> states_;  // 0: no result; else a place in outcomes_, plus 1
  std::vector<Outcome> outcomes_;
};

/// The runs that the folder's shards hold. Throws ResultsError for a row that does not belong to
/// the campaign, UnsafeContent and IoError.
/// @param damaged  places of damaged lines, as "FILE:LINE", are added
FinishedSet ReadFinished(const std::filesystem::path& dir, const RowCheck& check,
                         const RowColumns& columns, std::vector<std::string>& damaged);

}  // namespace dockyard
