// Dotted keys ("start.r_m") in a tree of YAML, and a tree as text.
#pragma once

#include <string>
#include <string_view>

#include "models/read/yaml_path.h"

namespace dockyard {

/// Puts the value under a dotted key on top of the tree, mappings key by key. Messages about an
/// unknown key give `key_place`.
void PutPath(YamlNode& tree, std::string_view path, const YamlPlace& key_place,
             const YamlNode& value);

/// Removes a dotted key, and the mappings that are then empty.
void RemovePath(YamlNode& tree, std::string_view path);

/// Whether one is the other or holds it: "start" and "start.r_m".
bool PathsOverlap(std::string_view a, std::string_view b);

/// The mapping with a line for each key, which reads back to the same.
std::string BlockText(const YamlNode& mapping, int indent = 0);

/// Absolute, without "." and "..".
std::string AbsolutePath(const std::string& file);

/// The node as a cell of a table: a scalar's text, else flow style.
std::string CellText(const YamlNode& node);

/// A scalar that stands in no file.
YamlNode ScalarNode(const std::string& text, bool quoted);

}  // namespace dockyard
