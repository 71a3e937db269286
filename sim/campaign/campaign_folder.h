// A campaign's results folder:
//   campaign.yaml, files/   what was run; the files that it names are copies of the models
//   manifest.json           fingerprints of all of that and of the program; where it ran
//   shards/K-of-N.rows      a row for each finished run, as it ended (shard_file.h)
//   results.csv, timing.csv, results.sqlite, summary.txt
//   points.csv, points.md   of a campaign with a grid or arms: a line per point
//   plots/                  curves.svg, bars.svg and figures of the system
//   runs/NNN/               of the runs whose log is kept: run.mcap, history.csv, values.csv,
//                           sightings.json, plans.json, outcome.json, figures of the system,
//                           messages.txt (the run's printed lines, if any)
//   commands/NNN/           of the other runs whose controller is a program: run.mcap with its
//                           commands, messages.txt
//   work/                   of the runs under way
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "sim/base/folder.h"
#include "sim/campaign/manifest.h"

namespace dockyard {

/// The folder holds something else, or is in use. The message says what to do.
class FolderTaken : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Of manifest.json; assumed, 8 to 512 MiB: a shard's part takes about 1 KiB.
inline constexpr std::uint64_t kMostManifestBytes = 64u << 20;
/// Of campaign.yaml and each of files/; assumed, 4 to 1024 MiB: meshes have up to some 10 MiB.
inline constexpr std::uint64_t kMostFileBytes = 256u << 20;
/// Of sightings.json; assumed, 16 to 1024 MiB: a sighting takes about 5 KiB.
inline constexpr std::uint64_t kMostSightingsBytes = 256u << 20;
/// What a run printed, or its program.
inline constexpr const char* kMessagesFile = "messages.txt";
/// Of messages.txt, which is shown; assumed, 1 to 256 MiB.
inline constexpr std::uint64_t kMostMessagesBytes = 64u << 20;
/// Of small texts: a run's row and scenario, a test's aims; assumed, 1 to 64 MiB.
inline constexpr std::uint64_t kMostTextBytes = 16u << 20;

/// manifest.json of a results folder; an empty object where there is none that can be read. Throws
/// UnsafeContent and IoError.
Json ReadManifest(const std::filesystem::path& dir);

/// "runs/007" of a results folder.
std::filesystem::path RunFolder(const std::filesystem::path& dir, int run);

/// "commands/007" of a results folder.
std::filesystem::path CommandsFolder(const std::filesystem::path& dir, int run);
/// The folder whose log has the run's commands.
Folder FolderOfCommands(const std::filesystem::path& dir, int run);

/// A run of a campaign, told by the folder of its log.
struct RunOfFolder {
  std::filesystem::path campaign;
  int run = 0;
};
/// If the folder is "runs/007" of a campaign's results folder.
std::optional<RunOfFolder> FindRunOfFolder(const std::filesystem::path& run_folder);

/// "sightings/007.json" of a results folder.
std::filesystem::path SightingsFile(const std::filesystem::path& dir, int run);

/// Whether the folder holds a campaign's results. Throws UnsafeContent where its manifest,
/// campaign.yaml or one of its own folders is a link or anything else that it may not be, and for
/// such content of files/.
bool HoldsCampaign(const std::filesystem::path& dir);
/// Whether the folder holds a single run's results. Throws UnsafeContent.
bool HoldsRun(const std::filesystem::path& dir);
/// Throws UnsafeContent unless all that the folder holds of a campaign is files and folders.
void RequirePlain(const std::filesystem::path& dir);
/// Until it is closed, other programs wait that write tables of all rows, a minute at most: then
/// they throw FolderTaken. A file system that knows no locks gives them to all.
Descriptor LockResults(const std::filesystem::path& dir);
/// None where another program has it.
std::optional<Descriptor> TryLockResults(const std::filesystem::path& dir);

/// Makes the folder with the copies of the files, or checks that it was made for the same campaign,
/// files and program. Several programs may do so at once. Throws FolderTaken and IoError.
void ClaimFolder(const std::filesystem::path& dir, const CampaignIdentity& identity,
                 const Json& facts);

}  // namespace dockyard
