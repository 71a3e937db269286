#include "sim/scenario/key_path.h"

#include <filesystem>
#include <optional>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/text_file.h"

namespace dockyard {
namespace {

struct Split {
  std::string_view first, rest;  // rest is empty for the last part
};
Split SplitPath(std::string_view path) {
  const std::size_t dot = path.find('.');
  if (dot == std::string_view::npos) return {path, {}};
  return {path.substr(0, dot), path.substr(dot + 1)};
}

YamlNode Wrapped(std::string_view path, const YamlPlace& key_place, const YamlNode& value) {
  const auto [first, rest] = SplitPath(path);
  YamlNode mapping;
  mapping.kind = YamlNode::Kind::kMapping;
  mapping.place = value.place;
  mapping.keys.push_back({std::string(first), key_place});
  mapping.items.push_back(rest.empty() ? value : Wrapped(rest, key_place, value));
  return mapping;
}

std::string KeyText(const std::string& name) {
  const bool plain =
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.") ==
          std::string::npos &&
      name != "null";
  YamlNode node;
  node.kind = YamlNode::Kind::kScalar;
  node.scalar = name;
  node.quoted = !plain;
  return FlowText(node);
}

}  // namespace

void PutPath(YamlNode& tree, std::string_view path, const YamlPlace& key_place,
             const YamlNode& value) {
  MergeYaml(tree, Wrapped(path, key_place, value));
}

void RemovePath(YamlNode& tree, std::string_view path) {
  const auto [first, rest] = SplitPath(path);
  for (std::size_t i = 0; i < tree.keys.size(); ++i) {
    if (tree.keys[i].name != first) continue;
    if (!rest.empty()) RemovePath(tree.items[i], rest);
    const bool empty = tree.items[i].kind == YamlNode::Kind::kMapping && tree.items[i].keys.empty();
    if (!rest.empty() && !empty) return;
    tree.keys.erase(tree.keys.begin() + static_cast<std::ptrdiff_t>(i));
    tree.items.erase(tree.items.begin() + static_cast<std::ptrdiff_t>(i));
    return;
  }
}

bool PathsOverlap(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  return b.substr(0, a.size()) == a && (a.size() == b.size() || b[a.size()] == '.');
}

std::string BlockText(const YamlNode& mapping, int indent) {
  const std::string margin(static_cast<std::size_t>(indent), ' ');
  std::string text;
  for (std::size_t i = 0; i < mapping.keys.size(); ++i) {
    const YamlNode& value = mapping.items[i];
    text += margin + KeyText(mapping.keys[i].name) + ":";
    if (value.kind == YamlNode::Kind::kMapping && !value.keys.empty()) {
      text += "\n" + BlockText(value, indent + 2);
    } else {
      text += " " + FlowText(value) + "\n";
    }
  }
  return text;
}

std::string CellText(const YamlNode& node) {
  return node.kind == YamlNode::Kind::kScalar ? node.scalar : FlowText(node);
}

std::string AbsolutePath(const std::string& file) {
  const std::string path = std::filesystem::absolute(file).lexically_normal().string();
  const std::optional<char32_t> control = FirstControl(path);
  if (!control) return path;
  std::string shown = path;
  for (char& c : shown) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7F) c = '?';
  }
  throw ConfigError("'" + shown + "': expected a path in UTF-8 without control characters, found " +
                    CharacterName(*control) + "; results that name it could not be read again");
}

YamlNode ScalarNode(const std::string& text, bool quoted) {
  YamlNode node;
  node.kind = YamlNode::Kind::kScalar;
  node.scalar = text;
  node.quoted = quoted;
  return node;
}

}  // namespace dockyard
