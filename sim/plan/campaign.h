// A campaign: which runs there are, and what each sets. Read from a file; the runs themselves are
// made one by one, when it is their turn (make_run.h).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "models/read/yaml_tree.h"
#include "sim/draws/copula.h"
#include "sim/draws/design.h"
#include "sim/plan/dispersion.h"
#include "sim/plan/factor.h"
#include "sim/plan/table.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// One of the things compared, such as a controller: keys that it sets on top of the base. All arms
/// meet the same draws.
struct Arm {
  std::string name;
  std::vector<KeyValue> sets;
};

/// Which runs leave a folder with log, history and figures.
struct Keep {
  std::int64_t failures_per_cause = -1;  // those with the lowest numbers; -1: all
  std::int64_t every_nth_success = 1;    // one success in n; 0: none
  bool pictures = true;                  // in the logs
  bool sightings = false;                // of every run, whether it leaves a folder or not

  static Keep None() { return {0, 0, false}; }
  bool none() const { return failures_per_cause == 0 && every_nth_success == 0 && !sightings; }
};

/// What a run may take. It is no part of what is run.
struct RunLimits {
  double wall_s = 900.0;           // assumed, 60-3600: the longest docking takes about 30 s
  std::int64_t memory_mib = 2048;  // assumed, 512-8192: a docking takes about 150 MiB
  int retries = 1;                 // of a run that is lost
};

/// The plots of a campaign's curves. Keys are labels of the campaign; empty: none.
struct Figures {
  std::string x{}, curves{}, panels{};
  std::vector<std::string> measures;  // columns
};

struct Campaign {
  std::string name, file;
  Seed seed;                          // with a secret: a sealed campaign
  std::string sealed_sha256;          // of a sealed one: its secret's fingerprint
  YamlNode base;                      // a scenario's tree, the same for all runs
  std::vector<Arm> arms;              // empty: the base alone
  RunTable table;                     // without rows: none
  std::vector<Factor> grid;           // every combination is a point; the first changes fastest
  std::vector<Factor> named;          // columns of the table whose cells are names of values
  std::vector<Factor> one_at_a_time;  // each value set alone, at every point
  std::vector<std::string> tags;      // columns of the table that set nothing
  std::vector<Dispersion> dispersions;
  std::optional<Correlation> correlation;  // of the dispersions, in their order
  DesignKind design = DesignKind::kMonteCarlo;
  int repeats = 1;  // runs at each point and arm
  Keep keep;
  RunLimits limits;
  Figures figures;
  std::vector<std::string> labels;  // of a run: arm, place, keys and tags, by name
  bool sets_controller = false;     // by name: the result's own column tells it, no label does
  YamlNode tree;                    // the whole file as read, options included

  /// Rows of the table, or 1.
  std::int64_t row_count() const;
  std::int64_t grid_size() const;
  /// Places of the grid and the table, each with at most one key changed.
  std::int64_t point_count() const;
  /// Whether its worlds cannot be made here: it is sealed, and the secret is not known.
  bool is_hidden() const { return !sealed_sha256.empty() && !seed.secret; }
  /// Seals it, or gives the secret of a sealed one.
  void Seal(const Secret& secret) {
    seed.secret = secret;
    sealed_sha256 = Fingerprint(secret);
  }
  std::int64_t run_count() const;
  /// The arms that each row and point has a run of, at least 1.
  std::int64_t arm_count() const;
  /// Whether a run's number is that of its row in the table.
  bool numbered_by_table() const;
  /// Labels by which results are summed up: arm, the grid's keys, the key changed alone.
  std::vector<std::string> settings() const;
  /// Whether the runs' labels tell the point, and the repeat.
  bool has_points() const;
  bool has_repeats() const;
};

/// Whether the table's column is a tag.
bool IsTag(const Campaign& campaign, const std::string& column);
/// All keys that the runs set themselves, but for those of arms and those changed one at a time.
std::vector<YamlNode::Key> KeysOfRuns(const Campaign& campaign);

/// Whether a result's own column `controller` tells the value of this key. `named`: its values, if
/// the file names them.
bool TellsController(const std::string& key, const Factor* named);

/// The part of the systems that a campaign's reader needs.
struct CampaignSystems {
  std::vector<KnownSystem> known;
  /// Columns of a system's result rows that a figure can show. Empty: none is known.
  std::function<std::vector<std::string>(const std::string& system)> measures;
};

/// Overrides are "key.path=value" as of LoadScenario, for keys of the campaign's file. Throws
/// ConfigError with file, line and column. The runs are checked by CheckRuns (make_run.h).
Campaign LoadCampaign(const std::string& file, const std::vector<std::string>& overrides,
                      const CampaignSystems& systems);

/// The campaign as one file that reads back to the same, its paths as they are.
std::string CampaignYaml(const Campaign& campaign);

}  // namespace dockyard
