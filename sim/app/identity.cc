#include "sim/app/identity.h"

#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include "models/read/config_error.h"
#include "models/read/mesh_address.h"
#include "models/read/text_file.h"
#include "models/read/yaml_tree.h"
#include "sim/base/environment.h"
#include "sim/base/files.h"
#include "sim/base/hash.h"
#include "sim/base/math_pin.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/plan/file_keys.h"
#include "sim/plant/renderer.h"
#include "sim/scenario/key_path.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

std::string Fingerprint(const fs::path& path) {
  const auto bytes = ReadWhole(path);
  if (!bytes) throw IoError("cannot read " + path.string() + ": it is not there");
  return HexText(HashText(kHashSeed, *bytes));
}

/// Files of models, each by its absolute path without "." and "..".
class ModelFiles {
 public:
  void AddModel(const fs::path& yaml) {
    if (files.insert(yaml).second) AddNamed(LoadYaml(yaml));
  }
  /// A URDF with its meshes, and with the files by which it finds those of packages.
  void AddUrdf(const fs::path& urdf) {
    if (!files.insert(urdf).second) return;
    const std::string text = ReadWhole(urdf).value_or("");
    static const std::regex mesh(R"(filename\s*=\s*["']([^"']+)["'])");
    MeshAddresses addresses(urdf.string(), {});
    for (std::sregex_iterator at(text.begin(), text.end(), mesh), end; at != end; ++at) {
      try {
        const fs::path file = addresses.Resolve((*at)[1].str(), urdf.string());
        AddMesh(file);
        if (!file.lexically_relative(urdf.parent_path()).string().starts_with("..")) continue;
        AddPackageOf(urdf);
        AddPackageOf(file);
      } catch (const ConfigError&) {
        // Another program's file, or one that the model's reader refuses with its line.
      }
    }
  }
  void AddFile(const fs::path& file) { files.insert(file); }
  void AddMesh(const fs::path& mesh) {
    files.insert(mesh);
    if (mesh.extension() != ".gltf") return;
    // The numbers of a glTF document may lie in .bin files beside it.
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(mesh.parent_path(), error)) {
      if (entry.is_regular_file(error) && entry.path().extension() == ".bin") {
        files.insert(entry.path());
      }
    }
  }

  std::set<fs::path> files;

 private:
  void AddPackageOf(const fs::path& file) {
    const fs::path package = PackageFileAbove(file.parent_path());
    if (!package.empty()) files.insert(package);
  }
  /// The files that a model's YAML names by the keys `base`, `urdf` and `file`.
  void AddNamed(const YamlNode& node) {
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const YamlNode& item = node.items[i];
      const std::string key = node.keys.empty() ? "" : node.keys[i].name;
      AddNamed(item);
      if (item.kind != YamlNode::Kind::kScalar ||
          (key != "base" && key != "urdf" && key != "file")) {
        continue;
      }
      const fs::path file = AbsolutePath(ResolveBeside(*item.place.source, item.scalar).string());
      std::error_code error;
      if (!fs::is_regular_file(file, error)) continue;
      if (key == "base") {
        AddModel(file);
      } else if (key == "urdf") {
        AddUrdf(file);
      } else {
        AddFile(file);
      }
    }
  }
};

/// Whether a file below the folder is a link to one that is not: somebody else's file, which must
/// not go out with the results.
bool LeadsOut(const fs::path& file, const fs::path& folder) {
  const auto below = [](const fs::path& path, const fs::path& top) {
    const fs::path inside = path.lexically_relative(top);
    return !inside.empty() && *inside.begin() != "..";
  };
  std::error_code error;
  return below(file, folder) && !below(fs::canonical(file, error), fs::canonical(folder, error));
}

/// A controller's program: the words of its command that are files, and its `files`.
void AddProgram(const NamedCommand& command, ModelFiles& models) {
  for (const std::string& word : command.words) {
    std::error_code error;
    const fs::path file = AbsolutePath((fs::path(command.folder) / word).string());
    if (fs::is_regular_file(file, error) && !LeadsOut(file, command.folder)) models.AddFile(file);
  }
}

/// The longest folder that holds all of them and the programs' folders. A model of Gazebo has the
/// name of its folder, so it lies in a folder below.
fs::path CommonFolder(const std::set<fs::path>& files, const std::vector<NamedCommand>& commands) {
  std::vector<fs::path> folders;
  for (const fs::path& file : files) {
    const fs::path folder = file.parent_path();
    folders.push_back(file.filename() == "model.config" ? folder.parent_path() : folder);
  }
  for (const NamedCommand& command : commands) folders.emplace_back(command.folder);
  fs::path common = folders.empty() ? fs::path() : folders.front();
  for (const fs::path& folder : folders) {
    fs::path shared;
    for (auto a = common.begin(), b = folder.begin();
         a != common.end() && b != folder.end() && *a == *b; ++a, ++b) {
      shared /= *a;
    }
    common = shared;
  }
  return common;
}

void RequireReadableSizes(const std::set<fs::path>& files) {
  for (const fs::path& file : files) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(file, error);
    if (error || bytes <= kMostFileBytes) continue;
    throw ConfigError(file.string() + ": expected at most " + std::to_string(kMostFileBytes >> 20) +
                      " MiB, as the results keep a copy; found " + std::to_string(bytes >> 20));
  }
}

/// A folder of results is read by its own campaign.yaml ever after.
void RequireReadable(const std::string& campaign_yaml) {
  const std::string file = "campaign.yaml of the results";
  if (campaign_yaml.size() > kMaxTextBytes) {
    throw ConfigError(file + ": would be larger than " + std::to_string(kMaxTextBytes >> 20) +
                      " MiB, which no command reads again; make a campaign of each part of the "
                      "table");
  }
  try {
    ParseYaml(campaign_yaml, file);
  } catch (const ConfigError& error) {
    throw ConfigError(std::string(error.what()) + "; no command could read the results again");
  }
}

}  // namespace

CampaignIdentity IdentityOf(const Campaign& campaign, const std::vector<KnownSystem>& systems) {
  ModelFiles models;
  const CampaignFiles named = FilesOf(campaign, systems);
  for (const NamedFile& file : named.files) {
    if (file.key.ends_with(".urdf")) {
      models.AddUrdf(file.path);
    } else if (file.key == "scenery[].file") {
      models.AddMesh(file.path);
    } else if (file.key.ends_with(".file")) {
      models.AddFile(file.path);
    } else {
      models.AddModel(file.path);
    }
  }
  for (const NamedCommand& command : named.commands) AddProgram(command, models);
  RequireReadableSizes(models.files);
  CampaignIdentity identity;
  identity.sealed_sha256 = campaign.sealed_sha256;
  const fs::path common = CommonFolder(models.files, named.commands);
  std::map<std::string, std::string> moved;
  for (const fs::path& file : models.files) {
    const std::string copy = "files/" + file.lexically_relative(common).generic_string();
    identity.files[copy] = file;
    moved[file.string()] = copy;
  }
  const auto place_of = [&](const std::string& path) {
    const auto copy = moved.find(path);
    if (copy != moved.end()) return copy->second;
    if (!fs::path(path).is_absolute()) return path;
    // A controller's folder: it keeps its place among the copies, where it has one.
    const std::string inside = fs::path(path).lexically_relative(common).generic_string();
    return inside.empty() || inside.starts_with("..") || inside == "." ? std::string("files")
                                                                       : "files/" + inside;
  };
  identity.campaign_yaml = CampaignYaml(WithMovedFiles(campaign, systems, place_of, true));
  RequireReadable(identity.campaign_yaml);
  identity.program = {{"version", DOCKYARD_VERSION},
                      {"fingerprint", Fingerprint("/proc/self/exe")},
                      {"mathematics", HexText(MathFingerprint())},
                      {"gl", GlWord()}};
  return identity;
}

std::vector<std::string> UnnamedFilesOf(const Campaign& campaign,
                                        const std::vector<KnownSystem>& systems) {
  std::vector<std::string> sentences;
  for (const NamedCommand& command : FilesOf(campaign, systems).commands) {
    ModelFiles named;
    AddProgram(command, named);
    std::set<std::string> unnamed;
    for (const fs::path& file : named.files) {
      std::error_code error;
      for (const auto& entry : fs::directory_iterator(file.parent_path(), error)) {
        const bool same_kind = file.has_extension() && entry.path().extension() == file.extension();
        if (!same_kind || named.files.count(entry.path()) > 0) continue;
        if (entry.is_regular_file(error)) unnamed.insert(entry.path().filename().string());
      }
    }
    if (unnamed.empty()) continue;
    sentences.push_back("controller.files: " + *unnamed.begin() +
                        (unnamed.size() > 1 ? " and others lie" : " lies") +
                        " next to the program and " + (unnamed.size() > 1 ? "are" : "is") +
                        " not named: the results hold no copy, and a replay from them fails where "
                        "the program needs it");
  }
  return sentences;
}

Json EnvironmentJson() {
  Json json = Json::object();
  for (const Fact& fact : Environment()) json[fact.name] = fact.value;
  return json;
}

Campaign OnCopies(const Campaign& campaign, const std::vector<KnownSystem>& systems,
                  const CampaignIdentity& identity, const fs::path& dir) {
  std::map<std::string, std::string> moved;
  for (const auto& [copy, original] : identity.files) {
    moved[original.string()] = AbsolutePath((dir / copy).string());
  }
  const auto place_of = [&](const std::string& path) {
    const auto copy = moved.find(path);
    return copy == moved.end() ? path : copy->second;
  };
  return WithMovedFiles(campaign, systems, place_of, false);
}

}  // namespace dockyard
