// A key of a scenario and the values that it takes.
#pragma once

#include <string>
#include <vector>

#include "models/read/yaml_reader.h"

namespace dockyard {

/// A dotted key (start.r_m, changes.soil.cohesion_pa, script) with its place in the file.
struct KeyValue {
  YamlNode::Key key;
  YamlNode value;
};

struct Factor {
  YamlNode::Key key;
  std::vector<std::string> labels;  // as shown; for numbers the numbers themselves
  std::vector<YamlNode> values;
};

/// Values from a list, a range {from, to, step}, or a mapping of labels to values. `path` is the
/// node's own dotted path. Throws ConfigError.
Factor ReadFactor(const YamlNode::Key& key, const YamlNode& node, const std::string& path);

/// All factors of the mapping under `name`; none if it is not there. Seeds and systems are no
/// factors. Throws ConfigError.
std::vector<Factor> ReadFactors(const YamlReader& root, const char* name);

/// Throws ConfigError for a key that a campaign cannot set: name, seed, system.
void RequireSettable(const YamlNode::Key& key, const std::string& path);

}  // namespace dockyard
