// A campaign's results folder:
//   campaign.yaml, files/   what was run; the files that it names are copies of the models
//   manifest.json           fingerprints of all of that and of the program; where it ran
//   shards/K-of-N.rows      a row for each finished run, as it ended (shard_file.h)
//   results.csv, timing.csv, results.sqlite, summary.txt
//   points.csv, points.md   of a campaign with a grid or arms: a line per point
//   plots/                  curves.svg, bars.svg and figures of the system
//   runs/NNN/               of the runs whose log is kept: run.mcap, history.csv, sightings.json,
//                           plans.json, outcome.json, figures of the system, messages.txt (the
//                           run's printed lines, if any)
//   work/                   of the runs under way
#pragma once

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>

#include "sim/campaign/manifest.h"

namespace dockyard {

/// The folder holds something else, or is in use. The message says what to do.
class FolderTaken : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// "runs/007" of a results folder.
std::filesystem::path RunFolder(const std::filesystem::path& dir, int run);

/// A run of a campaign, told by the folder of its log.
struct RunOfFolder {
  std::filesystem::path campaign;
  int run = 0;
};
/// If the folder is "runs/007" of a campaign's results folder.
std::optional<RunOfFolder> FindRunOfFolder(const std::filesystem::path& run_folder);

/// "sightings/007.json" of a results folder.
std::filesystem::path SightingsFile(const std::filesystem::path& dir, int run);

/// Whether the folder holds a campaign's results.
bool HoldsCampaign(const std::filesystem::path& dir);

/// Makes the folder with the copies of the files, or checks that it was made for the same campaign,
/// files and program. Several programs may do so at once. Throws FolderTaken and IoError.
void ClaimFolder(const std::filesystem::path& dir, const CampaignIdentity& identity,
                 const Json& facts);

/// Empties and makes the folder. Throws IoError.
void EmptyFolder(const std::filesystem::path& path);

}  // namespace dockyard
