// The runs of a campaign, each made when it is its turn.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "sim/plan/campaign.h"

namespace dockyard {

/// Makes runs in any order: a run follows from the campaign and its index alone.
class RunMaker {
 public:
  /// Both must outlive it.
  RunMaker(const Campaign& campaign, const std::vector<KnownSystem>& systems);

  std::int64_t run_count() const { return campaign_.run_count(); }
  /// @param index  0 .. run_count() - 1: arm by arm, repeat by repeat, point by point
  /// Throws ConfigError for a scenario that its reader refuses, and for a campaign whose secret is
  /// not known.
  CampaignRun Make(std::int64_t index) const;
  /// The run's labels, as Make gives them but without its scenario.
  std::vector<std::string> Labels(std::int64_t index) const;
  /// The run's number, which names it in results.
  int Number(std::int64_t index) const;
  /// The number of its world's seed, which its row has: the same for all arms and for every key
  /// changed alone.
  /// None: the campaign is sealed, and its secret is not known.
  std::optional<std::uint64_t> SeedNumber(std::int64_t index) const;
  /// The index of the run with that number; -1: there is none.
  std::int64_t IndexOf(int number) const;

 private:
  struct Place;
  Place PlaceOf(std::int64_t index) const;
  std::uint64_t WorldPlace(const Place& place) const;
  Seed SeedAt(const Place& place) const;
  // They set the keys of a tree, if there is one, and add labels.
  void SetAll(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const;
  void SetArm(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const;
  void SetRow(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const;
  void SetGrid(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const;
  void SetChange(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const;
  void Draw(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const;

  const Campaign& campaign_;
  const std::vector<KnownSystem>& systems_;
  Design design_;
  std::unordered_map<int, std::int64_t> rows_;  // of a table that numbers the runs
};

/// Makes runs to find every mistake of the file before the first is simulated: each place once, and
/// the ends of every distribution. `check` gets a scenario for each set of models, for what its
/// system alone sees; it may be empty. Of more than 10 000 places, or 300 sets of models, it makes
/// a part, with each row and each value of a key at least once. Throws ConfigError.
void CheckRuns(const Campaign& campaign, const std::vector<KnownSystem>& systems,
               const std::function<void(const Scenario&)>& check);

/// The runs as CSV with a line each: a table that makes the same runs again.
std::string PlanCsv(const Campaign& campaign, const std::vector<KnownSystem>& systems);

}  // namespace dockyard
