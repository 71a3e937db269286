#include "sim/plan/campaign.h"

#include <algorithm>

namespace dockyard {

std::int64_t Campaign::row_count() const {
  return static_cast<std::int64_t>(std::max<std::size_t>(1, table.rows.size()));
}

std::int64_t Campaign::grid_size() const {
  std::int64_t size = 1;
  for (const Factor& factor : grid) size *= static_cast<std::int64_t>(factor.values.size());
  return size;
}

std::int64_t Campaign::point_count() const {
  std::int64_t changes = 1;
  if (!table.Find("changed")) {
    for (const Factor& factor : one_at_a_time) {
      changes += static_cast<std::int64_t>(factor.values.size());
    }
  }
  return row_count() * grid_size() * changes;
}

std::int64_t Campaign::arm_count() const {
  if (arms.empty() || table.Find("arm")) return 1;
  return static_cast<std::int64_t>(arms.size());
}

std::int64_t Campaign::run_count() const { return point_count() * repeats * arm_count(); }

bool Campaign::numbered_by_table() const {
  return !table.rows.empty() && run_count() == row_count();
}

std::vector<std::string> Campaign::settings() const {
  std::vector<std::string> names;
  if (!arms.empty()) names.push_back("arm");
  for (const Factor& factor : grid) names.push_back(factor.key.name);
  if (!one_at_a_time.empty()) names.insert(names.end(), {"changed", "changed_to"});
  return names;
}

bool Campaign::has_points() const {
  return table.Find("point") || !grid.empty() || !one_at_a_time.empty() ||
         (!table.rows.empty() && !numbered_by_table());
}

bool Campaign::has_repeats() const { return table.Find("repeat") || repeats > 1; }

bool IsTag(const Campaign& campaign, const std::string& column) {
  return std::find(campaign.tags.begin(), campaign.tags.end(), column) != campaign.tags.end();
}

std::vector<YamlNode::Key> KeysOfRuns(const Campaign& campaign) {
  std::vector<YamlNode::Key> keys;
  for (const YamlNode::Key& column : campaign.table.columns) {
    if (!IsTag(campaign, column.name) && !IsPlanColumn(column.name)) keys.push_back(column);
  }
  for (const Factor& factor : campaign.grid) keys.push_back(factor.key);
  for (const Dispersion& dispersion : campaign.dispersions) keys.push_back(dispersion.key);
  return keys;
}

bool TellsController(const std::string& key, const Factor* named) {
  if (key != "controller") return false;
  return named == nullptr ||
         std::all_of(named->values.begin(), named->values.end(),
                     [](const YamlNode& value) { return value.kind == YamlNode::Kind::kScalar; });
}

}  // namespace dockyard
