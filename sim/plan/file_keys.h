// The values of a campaign that name files and programs.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "models/read/yaml_tree.h"
#include "sim/plan/campaign.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// Dotted keys of any scenario of these systems whose values are files: "robot", "axel.station".
std::vector<std::string> FileKeys(const std::vector<KnownSystem>& systems);

/// Makes the files of the tree absolute, and names the folder in which a controller's program runs:
/// the tree then means the same from any folder. `path`: the tree's own dotted path, empty for a
/// scenario's root. Keys of mappings may be dotted themselves.
void MakeAbsolute(YamlNode& tree, const std::string& path,
                  const std::vector<std::string>& file_keys);

/// What a campaign reads beside its own file, as absolute paths.
struct NamedFile {
  std::string key, path;
};
struct NamedCommand {
  std::vector<std::string> words;
  std::string folder;
};
struct CampaignFiles {
  std::vector<NamedFile> files;  // each pair of key and path once
  std::vector<NamedCommand> commands;
};
CampaignFiles FilesOf(const Campaign& campaign, const std::vector<KnownSystem>& systems);

}  // namespace dockyard
