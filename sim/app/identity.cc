#include "sim/app/identity.h"

#include <filesystem>
#include <set>

#include "models/read/text_file.h"
#include "models/read/yaml_tree.h"
#include "sim/base/files.h"
#include "sim/base/hash.h"
#include "sim/base/math_pin.h"
#include "sim/plan/file_keys.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

std::string Fingerprint(const fs::path& path) {
  const auto bytes = ReadWhole(path);
  if (!bytes) throw IoError("cannot read " + path.string() + ": it is not there");
  return HexText(HashText(kHashSeed, *bytes));
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

/// A controller's program: the words of its command that are files, and the files beside each with
/// the same ending, which it may import.
void AddProgram(const NamedCommand& command, std::set<fs::path>& files) {
  const fs::path folder = command.folder.empty() ? "." : command.folder;
  for (const std::string& word : command.words) {
    std::error_code error;
    const fs::path file = fs::weakly_canonical(folder / word, error);
    if (error || !fs::is_regular_file(file, error)) continue;
    files.insert(file);
    if (!file.has_extension()) continue;
    for (const auto& entry : fs::directory_iterator(file.parent_path(), error)) {
      if (entry.is_regular_file(error) && entry.path().extension() == file.extension()) {
        files.insert(entry.path());
      }
    }
  }
}

}  // namespace

std::string IdentityText(const Campaign& campaign, const std::vector<KnownSystem>& systems) {
  std::set<fs::path> models, files;
  const CampaignFiles named = FilesOf(campaign, systems);
  for (const NamedFile& file : named.files) {
    // One spelling for each file: resolved.yaml spells them otherwise than the campaign's file.
    const fs::path path = fs::weakly_canonical(file.path);
    const bool alone = file.key.ends_with(".file");
    if (file.key.ends_with(".urdf")) {
      AddWithNeighbours(path, files);
    } else {
      (alone ? files : models).insert(path);
    }
  }
  for (const NamedCommand& command : named.commands) AddProgram(command, files);
  for (const fs::path& model : models) {
    AddWithNeighbours(model, files);
    AddNamed(LoadYaml(model), files);
  }
  std::string text = "dockyard " DOCKYARD_VERSION " " + Fingerprint("/proc/self/exe") + "\n";
  text += "mathematics " + HexText(MathFingerprint()) + "\n";
  for (const fs::path& file : files) text += file.string() + " " + Fingerprint(file) + "\n";
  return text;
}

}  // namespace dockyard
