#include "sim/plan/check_campaign.h"

#include <string_view>

#include "models/read/config_error.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

constexpr std::int64_t kMostPoints = 1000000;
constexpr std::int64_t kMostRuns = 2000000000;  // a run's number has 31 bits
// Every run copies the base: 90 000 values take 20 ms. A script has four a step.
constexpr std::int64_t kMostBaseValues = 10000;

std::int64_t CountValues(const YamlNode& node) {
  std::int64_t count = 1;
  for (const YamlNode& item : node.items) count += CountValues(item);
  return count;
}

[[noreturn]] void RefuseKey(const YamlNode::Key& key, const std::string& path,
                            const std::string& expected) {
  throw ConfigError(key.place.Text() + ": " + path + ": expected " + expected);
}

/// Finds the place of the innermost key of a dotted path that is there.
const YamlNode::Key* FindKey(const YamlNode& tree, std::string_view path) {
  const std::string_view first = path.substr(0, path.find('.'));
  for (std::size_t i = 0; i < tree.keys.size(); ++i) {
    if (tree.keys[i].name != first) continue;
    if (first.size() == path.size()) return &tree.keys[i];
    return FindKey(tree.items[i], path.substr(first.size() + 1));
  }
  return nullptr;
}

/// Each key of a run comes from one place, or the file would say less than it seems to.
void CheckOverlaps(const Campaign& campaign, const YamlReader& root) {
  const std::vector<YamlNode::Key> keys = KeysOfRuns(campaign);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (!PathsOverlap(keys[k].name, keys[i].name)) continue;
      RefuseKey(keys[i], keys[i].name, "a key that is not set by '" + keys[k].name + "' as well");
    }
    for (const Arm& arm : campaign.arms) {
      for (const KeyValue& set : arm.sets) {
        if (!PathsOverlap(set.key.name, keys[i].name)) continue;
        RefuseKey(set.key, "arms." + arm.name + "." + set.key.name,
                  "a key that is not set by '" + keys[i].name + "' as well");
      }
    }
  }
  for (const Dispersion& dispersion : campaign.dispersions) {
    for (const Factor& changed : campaign.one_at_a_time) {
      if (!PathsOverlap(changed.key.name, dispersion.key.name)) continue;
      RefuseKey(changed.key, "one_at_a_time." + changed.key.name,
                "a key that is not drawn as well");
    }
  }
  if (!root.Has("scenario")) return;
  std::vector<std::string> of_runs{"name", "seed"};
  for (const YamlNode::Key& key : keys) of_runs.push_back(key.name);
  for (const std::string& name : of_runs) {
    const YamlNode::Key* key = FindKey(root.Child("scenario"), name);
    if (key == nullptr) continue;
    // Runs put their mappings key by key on top of the base's.
    if (FindPath(root.Child("scenario"), name)->kind == YamlNode::Kind::kMapping) continue;
    RefuseKey(*key, "scenario." + name,
              "only keys that all runs share; each run has its own " + name);
  }
}

void CheckColumns(const Campaign& campaign, const std::vector<KnownSystem>& systems) {
  Scenario none;
  const std::vector<std::string> keys =
      KeyNames([&](Keys& in) { VisitScenario(in, none, systems); });
  for (const YamlNode::Key& column : campaign.table.columns) {
    CheckColumn(column, IsTag(campaign, column.name), keys);
  }
  if (campaign.table.Find("arm") && campaign.arms.empty()) {
    RefuseKey(campaign.table.columns[*campaign.table.Find("arm")], "arm",
              "a campaign's file with arms");
  }
  if (!campaign.table.Find("changed") != !campaign.table.Find("changed_to")) {
    throw ConfigError(campaign.table.columns.front().place.Text() +
                      ": expected both columns 'changed' and 'changed_to', or neither");
  }
}

void CheckSize(const Campaign& campaign, const YamlReader& in) {
  if (CountValues(campaign.base) > kMostBaseValues) {
    throw ConfigError(campaign.tree.place.Text() + ": expected a base scenario of at most " +
                      std::to_string(kMostBaseValues) + " values, found " +
                      std::to_string(CountValues(campaign.base)));
  }
  double points = static_cast<double>(campaign.row_count());
  for (const Factor& factor : campaign.grid) points *= static_cast<double>(factor.values.size());
  if (points > static_cast<double>(kMostPoints) || campaign.point_count() > kMostPoints) {
    throw ConfigError(campaign.tree.place.Text() + ": expected at most " +
                      std::to_string(kMostPoints) + " points (rows x grid x changed values)");
  }
  if (static_cast<double>(campaign.point_count()) * campaign.repeats *
          static_cast<double>(campaign.arm_count()) >
      static_cast<double>(kMostRuns)) {
    in.Refuse("design", "at most 2e9 runs in all");
  }
}

}  // namespace

void CheckWhole(const Campaign& campaign, const YamlReader& root,
                const std::vector<KnownSystem>& systems) {
  CheckColumns(campaign, systems);
  CheckOverlaps(campaign, root);
  CheckSize(campaign, root);
}

}  // namespace dockyard
