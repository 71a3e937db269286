// A table in comma-separated values as a list of YAML mappings, so that rows get the same checks as
// other input: one header line, cells with commas in quotation marks (RFC 4180, each on one line),
// lines that begin with #, and rows whose cells are all empty are left out.
#pragma once

#include <string>

#include "models/read/text_file.h"
#include "models/read/yaml_tree.h"

namespace dockyard {

/// Throws ConfigError with file:line:col (columns count bytes from 1).
YamlNode LoadCsv(const std::string& file, std::size_t max_bytes = kMaxTextBytes);

}  // namespace dockyard
