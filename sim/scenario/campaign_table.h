// The table of a campaign as written, from a CSV file or a list.
#pragma once

#include <string>
#include <vector>

#include "models/read/yaml_tree.h"

namespace dockyard {

struct CampaignTable {
  struct Row {
    int run = 0;
    std::vector<YamlNode> cells;  // by column; none is kNull
  };
  std::vector<YamlNode::Key> columns;  // `run` left out
  std::vector<Row> rows;

  std::vector<std::string> Names() const;
};

/// Rows with the same columns, each with a run's number of its own. `path` is the list's dotted
/// path for messages, empty for a file of its own. Throws ConfigError.
CampaignTable ReadTable(const YamlNode& list, const std::string& path);

/// Throws ConfigError unless the column is a tag (one of `tags`) or may be a key of a scenario that
/// a table sets.
void CheckColumn(const YamlNode::Key& column, bool is_tag,
                 const std::vector<std::string>& scenario_keys);

/// The cell's text, as in a row of results.
std::string CellText(const YamlNode& cell);

}  // namespace dockyard
