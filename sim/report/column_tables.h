// The columns of every table that comes out, with units and meanings: docs/reference/columns.md is
// made from it.
#pragma once

#include <string>
#include <vector>

#include "sim/log/column.h"

namespace dockyard {

/// A table and its columns in their order. A name in brackets stands for columns that the campaign
/// or the system names.
struct ColumnTable {
  std::string file, about;
  std::vector<Column> columns;
};

/// Columns that a system states.
struct SystemColumns {
  std::string system;
  std::vector<Column> measures, channels, beliefs;
};

/// The tables of a campaign's folder and of its runs' folders.
std::vector<ColumnTable> ColumnTables();

/// All of it in Markdown.
std::string ColumnsPage(const std::vector<SystemColumns>& systems);

}  // namespace dockyard
