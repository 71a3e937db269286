// A YAML document as a plain tree that keeps the place of each part in the file. A strict subset:
// one document, no anchors, aliases or tags, no repeated keys, bounded depth and size.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace dockyard {

inline constexpr std::size_t kMaxYamlDepth = 32;

/// Where something was written: a file with line and column, both from 1; or a --set option, whose
/// line is 0.
struct YamlPlace {
  std::shared_ptr<const std::string> source;
  int line = 0, column = 0;

  bool from_option() const { return line == 0; }
  std::string Text() const;  // "file:line:col" or "--set key=value"
};

struct YamlNode {
  enum class Kind { kNull, kScalar, kSequence, kMapping };
  struct Key {
    std::string name;
    YamlPlace place;
  };

  Kind kind = Kind::kNull;
  YamlPlace place;
  std::string scalar;           // kScalar
  bool quoted = false;          // kScalar
  std::vector<Key> keys;        // kMapping, one for each item
  std::vector<YamlNode> items;  // kSequence, kMapping

  const YamlNode* Find(std::string_view key) const;
  std::string Found() const;  // for messages: "'ten'", "a list", "nothing"
};

/// All throw ConfigError.
YamlNode ParseYaml(const std::string& text, const std::string& file);
YamlNode LoadYaml(const std::filesystem::path& file);

/// The node in flow style, which reads back to the same: "{a: 1, b: [x, y]}".
std::string FlowText(const YamlNode& node);

/// Puts `over` on top of `into`: mappings key by key, everything else replaced.
void MergeYaml(YamlNode& into, const YamlNode& over);

/// Applies "key.path=value" as the option --set does; the value is YAML.
void SetYaml(YamlNode& root, const std::string& assignment);

}  // namespace dockyard
