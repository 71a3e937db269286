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

/// Gathers what trees name, each tree made absolute first.
class Gatherer {
 public:
  explicit Gatherer(const std::vector<KnownSystem>& systems) : keys_(FileKeys(systems)) {}

  void Add(YamlNode tree, const std::string& path) {
    MakeAbsolute(tree, path, keys_);
    for (const std::string& key : keys_) {
      VisitPath(tree, path, key, [&](YamlNode& file) {
        const bool names = file.kind == YamlNode::Kind::kScalar;
        if (names && seen_.insert({key, file.scalar}).second) {
          found.files.push_back({key, file.scalar});
        }
      });
    }
    VisitPath(tree, path, "controller", [&](YamlNode& controller) {
      const YamlNode *command = controller.Find("command"), *folder = controller.Find("folder");
      if (command == nullptr) return;
      NamedCommand named{{}, folder == nullptr ? "" : folder->scalar};
      for (const YamlNode& word : command->items) named.words.push_back(word.scalar);
      found.commands.push_back(std::move(named));
    });
  }
  void Add(const Factor& factor) {
    for (const YamlNode& value : factor.values) Add(value, factor.key.name);
  }

  CampaignFiles found;

 private:
  std::vector<std::string> keys_;
  std::set<std::pair<std::string, std::string>> seen_;
};

}  // namespace

std::vector<std::string> FileKeys(const std::vector<KnownSystem>& systems) {
  std::vector<std::string> keys;
  for (const KeyRow& row : ScenarioRows()) {
    if (row.kind == KeyRow::Kind::kFile) keys.push_back(row.key);
  }
  for (const KnownSystem& system : systems) {
    for (const std::string& key : system.file_keys) keys.push_back(system.name + "." + key);
    for (const std::string& key : system.changes_file_keys) keys.push_back("changes." + key);
  }
  return keys;
}

void MakeAbsolute(YamlNode& tree, const std::string& path,
                  const std::vector<std::string>& file_keys) {
  for (const std::string& key : file_keys) VisitPath(tree, path, key, Resolve);
  VisitPath(tree, path, "controller.folder", Resolve);
  VisitPath(tree, path, "controller", NameFolder);
}

CampaignFiles FilesOf(const Campaign& campaign, const std::vector<KnownSystem>& systems) {
  Gatherer gatherer(systems);
  gatherer.Add(campaign.base, "");
  for (const Arm& arm : campaign.arms) {
    for (const KeyValue& set : arm.sets) gatherer.Add(set.value, set.key.name);
  }
  for (const auto* factors : {&campaign.grid, &campaign.named, &campaign.one_at_a_time}) {
    for (const Factor& factor : *factors) gatherer.Add(factor);
  }
  for (const Dispersion& dispersion : campaign.dispersions) gatherer.Add(dispersion.values);
  for (std::size_t i = 0; i < campaign.table.columns.size(); ++i) {
    const std::string& column = campaign.table.columns[i].name;
    const bool named = std::any_of(campaign.named.begin(), campaign.named.end(),
                                   [&](const Factor& each) { return each.key.name == column; });
    if (named) continue;
    for (const RunTable::Row& row : campaign.table.rows) gatherer.Add(row.cells[i], column);
  }
  return std::move(gatherer.found);
}

}  // namespace dockyard
