// The table of a campaign as written, from a CSV file or a list.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/read/yaml_tree.h"

namespace dockyard {

struct RunTable {
  struct Row {
    int run = 0;
    std::vector<YamlNode> cells;  // by column
  };
  std::vector<YamlNode::Key> columns;  // `run` left out
  std::vector<Row> rows;

  /// The place of the column in a row; none if there is no such column.
  std::optional<std::size_t> Find(const std::string& column) const;
};

/// Columns that a campaign's --dry-run writes beside its keys and tags. A table that has them makes
/// the same runs again.
bool IsPlanColumn(const std::string& name);

/// Rows with the same columns, each with a run's number of its own. `path` is the list's dotted
/// path for messages, empty for a file of its own. Throws ConfigError.
RunTable ReadTable(const YamlNode& list, const std::string& path);

/// Throws ConfigError unless the column is a tag or may be a key of a scenario that a table sets.
void CheckColumn(const YamlNode::Key& column, bool is_tag,
                 const std::vector<std::string>& scenario_keys);

/// The check of a campaign's table without the campaign's file.
struct TableCheck {
  int runs = 0;
  std::vector<std::string> checked;  // columns that are keys, every cell within its range
  // The rest: tags, files, keys of a system, names that the campaign's file gives a value.
  std::vector<std::string> left_to_campaign;
};
/// Throws ConfigError with the place of the first bad cell.
TableCheck CheckRunTable(const std::string& file);

}  // namespace dockyard
