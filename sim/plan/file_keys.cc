#include "sim/plan/file_keys.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "models/read/text_file.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

using Visit = std::function<void(YamlNode&)>;

/// Visits the nodes under the dotted path `wanted`, however the tree's keys split it.
void VisitPath(YamlNode& tree, const std::string& at, const std::string& wanted,
               const Visit& visit) {
  if (at == wanted) return visit(tree);
  if (tree.kind == YamlNode::Kind::kSequence && wanted.starts_with(at + "[].")) {
    for (YamlNode& item : tree.items) VisitPath(item, at + "[]", wanted, visit);
    return;
  }
  if (tree.kind != YamlNode::Kind::kMapping || !(at.empty() || PathsOverlap(at, wanted))) return;
  for (std::size_t i = 0; i < tree.keys.size(); ++i) {
    const std::string inner = at.empty() ? tree.keys[i].name : at + "." + tree.keys[i].name;
    VisitPath(tree.items[i], inner, wanted, visit);
  }
}

std::string Resolved(const YamlNode& node, const std::string& name) {
  const bool beside = !node.place.from_option() && node.place.source;
  return AbsolutePath(beside ? ResolveBeside(*node.place.source, name).string() : name);
}

void Resolve(YamlNode& node) {
  if (node.kind != YamlNode::Kind::kScalar) return;
  node.scalar = Resolved(node, node.scalar);
  node.quoted = true;
}

/// A program without a folder runs in its file's own.
void NameFolder(YamlNode& controller) {
  const YamlNode* command = controller.Find("command");
  if (command == nullptr || controller.Find("folder") != nullptr) return;
  YamlNode folder = ScalarNode(Resolved(*command, "."), true);
  controller.keys.push_back({"folder", controller.keys[0].place});
  controller.items.push_back(std::move(folder));
}

/// Visits every tree of the campaign that can hold keys of a scenario, with its own dotted path.
void VisitTrees(Campaign& campaign,
                const std::function<void(YamlNode& tree, const std::string& path)>& visit) {
  visit(campaign.base, "");
  for (Arm& arm : campaign.arms) {
    for (KeyValue& set : arm.sets) visit(set.value, set.key.name);
  }
  const auto visit_values = [&](Factor& factor) {
    for (YamlNode& value : factor.values) visit(value, factor.key.name);
  };
  for (auto* factors : {&campaign.grid, &campaign.named, &campaign.one_at_a_time}) {
    for (Factor& factor : *factors) visit_values(factor);
  }
  for (Dispersion& dispersion : campaign.dispersions) visit_values(dispersion.values);
  for (std::size_t i = 0; i < campaign.table.columns.size(); ++i) {
    const std::string& column = campaign.table.columns[i].name;
    const bool named = std::any_of(campaign.named.begin(), campaign.named.end(),
                                   [&](const Factor& each) { return each.key.name == column; });
    if (named || IsTag(campaign, column)) continue;
    for (RunTable::Row& row : campaign.table.rows) visit(row.cells[i], column);
  }
}

void VisitFiles(Campaign& campaign, const std::vector<std::string>& file_keys,
                const std::function<void(const std::string& key, YamlNode& file)>& visit) {
  VisitTrees(campaign, [&](YamlNode& tree, const std::string& path) {
    for (const std::string& key : file_keys) {
      VisitPath(tree, path, key, [&](YamlNode& file) {
        if (file.kind == YamlNode::Kind::kScalar) visit(key, file);
      });
    }
  });
}

/// Visits the values of `controller` that start a program.
void VisitPrograms(Campaign& campaign, const Visit& visit) {
  VisitTrees(campaign, [&](YamlNode& tree, const std::string& path) {
    VisitPath(tree, path, "controller", [&](YamlNode& controller) {
      if (controller.Find("command") != nullptr) visit(controller);
    });
  });
}

/// Visits what may be files of a program.
void VisitWords(YamlNode& controller, const Visit& visit) {
  for (const char* key : {"command", "files"}) {
    YamlNode* words = FindPath(controller, key);
    if (words == nullptr) continue;
    for (YamlNode& word : words->items) visit(word);
  }
}

/// The values in a column of the table that can hold files, by their cells' texts.
void NameFileColumns(Campaign& campaign, const std::vector<std::string>& file_keys) {
  for (std::size_t i = 0; i < campaign.table.columns.size(); ++i) {
    Factor factor{campaign.table.columns[i], {}, {}};
    const auto same = [&](const Factor& each) { return each.key.name == factor.key.name; };
    const auto holds = [&](const std::string& key) { return PathsOverlap(factor.key.name, key); };
    if (std::none_of(file_keys.begin(), file_keys.end(), holds) ||
        std::any_of(campaign.named.begin(), campaign.named.end(), same)) {
      continue;
    }
    std::set<std::string> known;
    for (const RunTable::Row& row : campaign.table.rows) {
      if (!known.insert(CellText(row.cells[i])).second) continue;
      factor.labels.push_back(CellText(row.cells[i]));
      factor.values.push_back(row.cells[i]);
    }
    campaign.named.push_back(std::move(factor));
  }
}

}  // namespace

std::vector<std::string> FileKeys(const std::vector<KnownSystem>& systems) {
  std::vector<std::string> keys;
  for (const KeyRow& row : ScenarioRows()) {
    if (row.kind == KeyRow::Kind::kFile) keys.push_back(row.key);
  }
  keys.insert(keys.end(), {"robot.file", "robot.urdf", "yard.patches[].soil", "scenery[].file"});
  for (const KnownSystem& system : systems) {
    for (const std::string& key : system.file_keys) {
      keys.push_back(system.name + "." + key);
      // As short forms have them.
      if (std::find(system.root_keys.begin(), system.root_keys.end(), key) !=
          system.root_keys.end()) {
        keys.insert(keys.end(), {key, key + ".file", key + ".urdf"});
      }
    }
    for (const std::string& key : system.changes_file_keys) {
      keys.insert(keys.end(), {"changes." + key, "as_built." + key});
    }
  }
  return keys;
}

Campaign WithAbsolutePaths(Campaign campaign, const std::vector<KnownSystem>& systems) {
  const std::vector<std::string> keys = FileKeys(systems);
  NameFileColumns(campaign, keys);
  VisitFiles(campaign, keys, [](const std::string&, YamlNode& file) { Resolve(file); });
  VisitTrees(campaign, [](YamlNode& tree, const std::string& path) {
    VisitPath(tree, path, "controller.folder", Resolve);
    VisitPath(tree, path, "controller", NameFolder);
  });
  return campaign;
}

CampaignFiles FilesOf(const Campaign& campaign, const std::vector<KnownSystem>& systems) {
  Campaign visited = campaign;
  CampaignFiles found;
  std::set<std::pair<std::string, std::string>> seen;
  VisitFiles(visited, FileKeys(systems), [&](const std::string& key, YamlNode& file) {
    if (seen.insert({key, file.scalar}).second) found.files.push_back({key, file.scalar});
  });
  VisitPrograms(visited, [&](YamlNode& controller) {
    NamedCommand named{{}, controller.Find("folder")->scalar};
    VisitWords(controller, [&](YamlNode& word) { named.words.push_back(word.scalar); });
    found.commands.push_back(std::move(named));
  });
  return found;
}

Campaign WithMovedFiles(Campaign campaign, const std::vector<KnownSystem>& systems,
                        const MovedPath& moved, bool programs_too) {
  VisitFiles(campaign, FileKeys(systems),
             [&](const std::string&, YamlNode& file) { file.scalar = moved(file.scalar); });
  if (!programs_too) return campaign;
  VisitPrograms(campaign, [&](YamlNode& controller) {
    YamlNode& folder = *FindPath(controller, "folder");
    VisitWords(controller, [&](YamlNode& word) {
      const std::string place = moved(word.scalar);
      if (place == word.scalar) return;
      word.scalar = std::filesystem::path(place).lexically_relative(moved(folder.scalar)).string();
    });
    folder.scalar = moved(folder.scalar);
  });
  return campaign;
}

}  // namespace dockyard
