#include "sim/campaign/campaign_folder.h"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <thread>

#include "sim/base/files.h"
#include "sim/log/run_log.h"
#include "sim/mcap/mcap_reader.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

/// The folders that programs of a campaign read, write and empty.
constexpr const char* kOwnFolders[] = {"files",     "shards", "runs", "commands",
                                       "sightings", "plots",  "work", "submit"};

/// Nothing, or what is left of a claim that was cut short.
bool HoldsOnlyScraps(const fs::path& dir) {
  std::error_code error;
  const bool begun = Folder(dir).HasFile("manifest.json");
  for (const auto& entry : fs::directory_iterator(dir, error)) {
    const std::string name = entry.path().filename().string();
    const bool of_claim = begun && (name == "manifest.json" || name == "files");
    if (!of_claim && entry.path().extension() != ".tmp") return false;
  }
  if (error) throw IoError("cannot read folder " + dir.string() + ": " + error.message());
  return true;
}

void Copy(const fs::path& from, const fs::path& dir, const fs::path& copy) {
  const auto bytes = ReadWhole(from);
  if (!bytes) throw IoError("cannot read " + from.string() + ": it is not there");
  Folder(dir).Make(copy.parent_path());
  Folder(dir).Write(copy, *bytes);
}

std::string NumberName(int run) {
  char name[32];
  std::snprintf(name, sizeof name, "%03d", run);
  return name;
}

}  // namespace

Json ReadManifest(const fs::path& dir) {
  const auto text = Folder(dir).Read("manifest.json", kMostManifestBytes);
  Json manifest = Json::parse(text.value_or(""), nullptr, /*allow_exceptions=*/false);
  return manifest.is_object() ? manifest : Json::object();
}

fs::path RunFolder(const fs::path& dir, int run) { return dir / "runs" / NumberName(run); }

fs::path CommandsFolder(const fs::path& dir, int run) { return dir / "commands" / NumberName(run); }

Folder FolderOfCommands(const fs::path& dir, int run) {
  const Folder whole = Folder(dir).In(RunFolder("", run));
  const Folder commands = Folder(dir).In(CommandsFolder("", run));
  return !whole.HasFile(kRunLogFile) && commands.HasFile(kRunLogFile) ? commands : whole;
}

std::optional<RunOfFolder> FindRunOfFolder(const fs::path& run_folder) {
  std::error_code ignored;
  const fs::path folder = fs::weakly_canonical(run_folder, ignored);
  const std::string name = folder.filename().string();
  RunOfFolder found{folder.parent_path().parent_path()};
  const auto read = std::from_chars(name.data(), name.data() + name.size(), found.run);
  if (read.ec != std::errc() || RunFolder(found.campaign, found.run) != folder) return std::nullopt;
  if (!HoldsCampaign(found.campaign)) return std::nullopt;
  return found;
}

fs::path SightingsFile(const fs::path& dir, int run) {
  return dir / "sightings" / (NumberName(run) + ".json");
}

bool HoldsCampaign(const fs::path& dir) {
  std::error_code ignored;
  if (!fs::is_directory(dir, ignored)) return false;
  const Folder folder(dir);
  if (!folder.HasFile("campaign.yaml") || !folder.HasFile("manifest.json")) return false;
  folder.Checked("campaign.yaml", kMostFileBytes);
  folder.Checked("files", kMostFileBytes);
  for (const char* part : kOwnFolders) folder.HasFolder(part);
  return true;
}

bool HoldsRun(const fs::path& dir) {
  std::error_code ignored;
  if (!fs::is_directory(dir, ignored)) return false;
  const Folder folder(dir);
  folder.Checked("resolved.yaml", kMostTextBytes);
  return folder.HasFile("resolved.yaml");
}

void RequirePlain(const fs::path& dir) {
  for (const char* part : kOwnFolders) Folder(dir).Checked(part, kMostLogBytes);
}

std::optional<Descriptor> TryLockResults(const fs::path& dir) {
  Descriptor lock(::open(dir.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!lock) throw IoErrorFromErrno("read folder", dir);
  if (::flock(lock.value(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return lock;
  return std::nullopt;
}

Descriptor LockResults(const fs::path& dir) {
  constexpr int kTries = 1200;  // of 50 ms
  for (int tries = 0; tries < kTries; ++tries) {
    if (auto lock = TryLockResults(dir)) return std::move(*lock);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  throw FolderTaken("another program is merging " + dir.string() + "; try again when it has ended");
}

// campaign.yaml comes last: a folder that has it is whole.
void ClaimFolder(const fs::path& dir, const CampaignIdentity& identity, const Json& facts) {
  const std::string other = "; choose another folder with --out, or remove it";
  MakeFolder(dir);
  const Json manifest = MakeManifest(identity, facts);
  // In this order: another program may be making the same folder.
  const bool only_scraps = HoldsOnlyScraps(dir);
  if (HoldsCampaign(dir)) {
    const std::string difference = ManifestDifference(ReadManifest(dir), manifest);
    if (!difference.empty()) throw FolderTaken(dir.string() + ": " + difference + other);
    return;
  }
  for (const char* part : kOwnFolders) Folder(dir).HasFolder(part);
  if (!only_scraps) {
    throw FolderTaken(dir.string() + " is not empty and holds no campaign" + other);
  }
  WriteWhole(dir / "manifest.json", manifest.dump(2) + "\n");
  Folder(dir).Make("files");
  for (const auto& [copy, original] : identity.files) Copy(original, dir, copy);
  WriteWhole(dir / "campaign.yaml", identity.campaign_yaml);
}

}  // namespace dockyard
