#include "sim/app/identity.h"

#include <cstdio>
#include <filesystem>
#include <set>

#include "models/read/text_file.h"
#include "models/read/yaml_tree.h"
#include "sim/base/files.h"
#include "sim/base/hash.h"

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

/// The file itself, and for a rover or station the files in its folder: URDF and meshes.
void AddWithNeighbours(const fs::path& file, std::set<fs::path>& files) {
  files.insert(file);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code error;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error)) {
    if (entry.is_regular_file()) files.insert(entry.path());
  }
  if (error) throw IoError("cannot read folder " + folder.string() + ": " + error.message());
}

/// The files that a model's YAML names by the keys `urdf` and `file`, which may lie elsewhere.
/// Missing files are left out: the model's reader refuses them with their line.
void AddNamed(const YamlNode& node, std::set<fs::path>& files) {
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const YamlNode& item = node.items[i];
    const std::string key = node.keys.empty() ? "" : node.keys[i].name;
    AddNamed(item, files);
    if (item.kind != YamlNode::Kind::kScalar || (key != "urdf" && key != "file")) continue;
    const fs::path named = item.place.from_option()
                               ? fs::path(item.scalar)
                               : ResolveBeside(*item.place.source, item.scalar);
    std::error_code error;
    if (!fs::is_regular_file(named, error)) continue;
    const fs::path file = fs::weakly_canonical(named);
    key == "urdf" ? AddWithNeighbours(file, files) : void(files.insert(file));
  }
}

}  // namespace

std::string IdentityText(const Campaign& campaign, const System& system) {
  std::set<fs::path> models, files;
  for (const CampaignRun& run : campaign.runs) {
    const Scenario& scenario = run.scenario;
    // One spelling for each file: resolved.yaml spells them otherwise than the campaign's file.
    for (const std::string* file : {&scenario.robot_file, &scenario.soil_file}) {
      if (!file->empty()) models.insert(fs::weakly_canonical(*file));
    }
    for (const std::string& key : system.file_keys) {
      const YamlNode* file = scenario.of_system.Find(key);
      if (file != nullptr) models.insert(fs::weakly_canonical(file->scalar));
    }
    if (!scenario.camera_file.empty()) files.insert(fs::weakly_canonical(scenario.camera_file));
    AddNamed(scenario.changes, files);
  }
  for (const fs::path& model : models) {
    AddWithNeighbours(model, files);
    AddNamed(LoadYaml(model), files);
  }
  std::string text = "dockyard " DOCKYARD_VERSION " " + Fingerprint("/proc/self/exe") + "\n";
  for (const fs::path& file : files) text += file.string() + " " + Fingerprint(file) + "\n";
  return text;
}

}  // namespace dockyard
