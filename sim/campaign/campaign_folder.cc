#include "sim/campaign/campaign_folder.h"

#include <charconv>
#include <cstdio>

#include "sim/base/files.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

/// Nothing, or what is left of a claim that was cut short.
bool HoldsOnlyScraps(const fs::path& dir) {
  std::error_code error;
  const bool begun = fs::exists(dir / "manifest.json", error);
  for (const auto& entry : fs::directory_iterator(dir, error)) {
    const std::string name = entry.path().filename().string();
    const bool of_claim = begun && (name == "manifest.json" || name == "files");
    if (!of_claim && entry.path().extension() != ".tmp") return false;
  }
  if (error) throw IoError("cannot read folder " + dir.string() + ": " + error.message());
  return true;
}

void Copy(const fs::path& from, const fs::path& to) {
  const auto bytes = ReadWhole(from);
  if (!bytes) throw IoError("cannot read " + from.string() + ": it is not there");
  MakeFolder(to.parent_path());
  WriteWhole(to, *bytes);
}

std::string NumberName(int run) {
  char name[32];
  std::snprintf(name, sizeof name, "%03d", run);
  return name;
}

}  // namespace

fs::path RunFolder(const fs::path& dir, int run) { return dir / "runs" / NumberName(run); }

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
  return fs::exists(dir / "campaign.yaml", ignored) && fs::exists(dir / "manifest.json", ignored);
}

// campaign.yaml comes last: a folder that has it is whole.
void ClaimFolder(const fs::path& dir, const CampaignIdentity& identity, const Json& facts) {
  const std::string other = "; choose another folder with --out, or remove it";
  MakeFolder(dir);
  const Json manifest = MakeManifest(identity, facts);
  // In this order: another program may be making the same folder.
  const bool only_scraps = HoldsOnlyScraps(dir);
  if (HoldsCampaign(dir)) {
    const Json kept = Json::parse(ReadWhole(dir / "manifest.json").value_or(""), nullptr,
                                  /*allow_exceptions=*/false);
    const std::string difference = ManifestDifference(kept, manifest);
    if (!difference.empty()) throw FolderTaken(dir.string() + ": " + difference + other);
    return;
  }
  if (!only_scraps) {
    throw FolderTaken(dir.string() + " is not empty and holds no campaign" + other);
  }
  WriteWhole(dir / "manifest.json", manifest.dump(2) + "\n");
  MakeFolder(dir / "files");
  for (const auto& [copy, original] : identity.files) Copy(original, dir / copy);
  WriteWhole(dir / "campaign.yaml", identity.campaign_yaml);
}

void EmptyFolder(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
  if (error) throw IoError("cannot empty folder " + path.string() + ": " + error.message());
  MakeFolder(path);
}

}  // namespace dockyard
