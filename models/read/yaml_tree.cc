#include "models/read/yaml_tree.h"

#include <map>
#include <optional>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/text_file.h"

namespace dockyard {
namespace {

void StampOption(YamlNode& node, const std::shared_ptr<const std::string>& option) {
  node.place = {option, 0, 0};
  for (YamlNode::Key& key : node.keys) key.place = {option, 0, 0};
  for (YamlNode& item : node.items) StampOption(item, option);
}

}  // namespace

std::string YamlPlace::Text() const {
  const std::string name = source ? *source : std::string();
  if (from_option()) return name;
  return name + ":" + std::to_string(line) + ":" + std::to_string(column);
}

const YamlNode* YamlNode::Find(std::string_view key) const {
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (keys[i].name == key) return &items[i];
  }
  return nullptr;
}

std::string YamlNode::Found() const {
  switch (kind) {
    case Kind::kNull:
      return "nothing";
    case Kind::kSequence:
      return "a list";
    case Kind::kMapping:
      return "a mapping";
    case Kind::kScalar:
      break;
  }
  constexpr std::size_t kShown = 40;
  if (scalar.size() <= kShown) return "'" + scalar + "'";
  std::size_t end = kShown;  // not through the middle of a UTF-8 sequence
  while (end > 0 && (static_cast<unsigned char>(scalar[end]) & 0xC0) == 0x80) --end;
  return "'" + scalar.substr(0, end) + "...'";
}

std::string FlowText(const YamlNode& node) {
  const auto quoted = [](const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
      if (c == '"' || c == '\\') out += '\\';
      if (c == '\n') {
        out += "\\n";  // a line's end in a quotation is read back as a space
      } else if (c == '\t') {
        out += "\\t";
      } else {
        out += c;
      }
    }
    return out + '"';
  };
  switch (node.kind) {
    case YamlNode::Kind::kNull:
      return "~";
    case YamlNode::Kind::kScalar: {
      const bool plain = !node.quoted && !node.scalar.empty() &&
                         node.scalar.find_first_not_of(
                             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                             "_.+-/") == std::string::npos &&
                         node.scalar != "-";
      return plain ? node.scalar : quoted(node.scalar);
    }
    case YamlNode::Kind::kSequence:
    case YamlNode::Kind::kMapping:
      break;
  }
  const bool mapping = node.kind == YamlNode::Kind::kMapping;
  std::string text = mapping ? "{" : "[";
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    if (i > 0) text += ", ";
    if (mapping) text += quoted(node.keys[i].name) + ": ";
    text += FlowText(node.items[i]);
  }
  return text + (mapping ? "}" : "]");
}

void MergeYaml(YamlNode& into, const YamlNode& over) {
  if (into.kind != YamlNode::Kind::kMapping || over.kind != YamlNode::Kind::kMapping) {
    into = over;
    return;
  }
  std::map<std::string, std::size_t> index;
  for (std::size_t k = 0; k < into.keys.size(); ++k) index.emplace(into.keys[k].name, k);
  for (std::size_t i = 0; i < over.keys.size(); ++i) {
    const auto known = index.find(over.keys[i].name);
    if (known != index.end()) {
      MergeYaml(into.items[known->second], over.items[i]);
      into.keys[known->second].place = over.keys[i].place;
      continue;
    }
    into.keys.push_back(over.keys[i]);
    into.items.push_back(over.items[i]);
  }
}

void SetYaml(YamlNode& root, const std::string& assignment) {
  const auto option = std::make_shared<const std::string>("--set " + assignment);
  CheckIsText(assignment, "--set");
  const std::size_t equals = assignment.find('=');
  const std::string path = assignment.substr(0, equals);
  if (const auto control = FirstControl(path)) {
    throw ConfigError("--set: expected a key without control characters, found " +
                      CharacterName(*control));
  }
  const bool dots = path.empty() || path.front() == '.' || path.back() == '.' ||
                    path.find("..") != std::string::npos;
  if (equals == std::string::npos || dots) {
    throw ConfigError(*option + ": expected key=value such as start.r_m=5");
  }
  YamlNode value;
  if (equals + 1 < assignment.size()) value = ParseYaml(assignment.substr(equals + 1), *option);
  StampOption(value, option);
  std::size_t end = path.size();
  std::size_t depth = 0;
  while (true) {  // wraps the value in its mappings, innermost first
    const std::size_t dot = end == 0 ? std::string::npos : path.rfind('.', end - 1);
    const std::size_t begin = dot == std::string::npos ? 0 : dot + 1;
    YamlNode mapping;
    mapping.kind = YamlNode::Kind::kMapping;
    mapping.place = {option, 0, 0};
    mapping.keys.push_back({path.substr(begin, end - begin), mapping.place});
    mapping.items.push_back(std::move(value));
    value = std::move(mapping);
    if (dot == std::string::npos) break;
    end = dot;
    if (++depth > kMaxYamlDepth) throw ConfigError(*option + ": nested too deep");
  }
  MergeYaml(root, value);
}

}  // namespace dockyard
