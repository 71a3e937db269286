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

/// The campaign with absolute paths, and with the folder in which each controller's program runs:
/// it means the same from any folder. Files in cells of the table get their cells' texts as names,
/// so that results show the same labels.
Campaign WithAbsolutePaths(Campaign campaign, const std::vector<KnownSystem>& systems);

/// What a campaign reads beside its own file, as absolute paths.
struct NamedFile {
  std::string key, path;
};
struct NamedCommand {
  std::vector<std::string> words;  // of the command, then `files`
  std::string folder;
};
struct CampaignFiles {
  std::vector<NamedFile> files;  // each pair of key and path once
  std::vector<NamedCommand> commands;
};
/// Of a campaign with absolute paths.
CampaignFiles FilesOf(const Campaign& campaign, const std::vector<KnownSystem>& systems);

/// Gives the place to which an absolute path has moved; the same path where it has not.
using MovedPath = std::function<std::string(const std::string& path)>;
/// The campaign, which has absolute paths, with its files moved; with those of its controllers'
/// programs too, if asked for.
Campaign WithMovedFiles(Campaign campaign, const std::vector<KnownSystem>& systems,
                        const MovedPath& moved, bool programs_too);

}  // namespace dockyard
