#include "sim/app/identity.h"

#include <cstdio>
#include <filesystem>
#include <set>

#include "sim/base/hash.h"
#include "sim/log/files.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

std::string Fingerprint(const fs::path& path) {
  const auto bytes = ReadWhole(path);
  if (!bytes) throw IoError("cannot read " + path.string() + ": it is not there");
  std::uint64_t hash = kHashSeed;
  for (const char c : *bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  char text[32];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// The file itself, and for a rover or station what lies in its folder: URDF and meshes.
void AddWithNeighbours(const fs::path& file, std::set<fs::path>& files) {
  files.insert(file);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    if (entry.is_regular_file()) files.insert(entry.path());
  }
  if (error) throw IoError("cannot read folder " + folder.string() + ": " + error.message());
}

}  // namespace

std::string IdentityText(const Campaign& campaign) {
  std::set<fs::path> models, files;
  for (const CampaignRun& run : campaign.runs) {
    for (const std::string* file :
         {&run.scenario.rover_file, &run.scenario.station_file, &run.scenario.soil_file}) {
      // One spelling for each file: resolved.yaml spells them otherwise than the campaign's file.
      models.insert(fs::weakly_canonical(*file));
    }
  }
  for (const fs::path& model : models) AddWithNeighbours(model, files);
  std::string text = "dockyard " DOCKYARD_VERSION " " + Fingerprint("/proc/self/exe") + "\n";
  for (const fs::path& file : files) text += file.string() + " " + Fingerprint(file) + "\n";
  return text;
}

}  // namespace dockyard
