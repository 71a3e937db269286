#include "models/read/yaml_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/text_file.h"

namespace dockyard {
namespace {

constexpr std::size_t kMaxDepth = 32;
constexpr int kMaxNodes = 200000;

/// Builds the tree from the parser's events, so that keys keep their places; yaml-cpp's own nodes
/// lose them for repeated keys.
class TreeBuilder : public YAML::EventHandler {
 public:
  explicit TreeBuilder(std::shared_ptr<const std::string> source) : source_(std::move(source)) {}

  YamlNode TakeRoot() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    RefuseAnchor(mark, anchor);
    Add(Make(YamlNode::Kind::kNull, mark));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    Refuse(mark, "aliases (*name) are not read");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    RefuseAnchor(mark, anchor);
    RefuseTag(mark, tag);
    YamlNode node = Make(YamlNode::Kind::kScalar, mark);
    node.scalar = value;
    RefuseControls(node, "\t\n");
    node.quoted = tag == "!";
    if (!node.quoted && (value == "null" || value == "~")) node.kind = YamlNode::Kind::kNull;
    Add(std::move(node));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    Open(YamlNode::Kind::kSequence, mark, tag, anchor);
  }
  void OnSequenceEnd() override { Close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    Open(YamlNode::Kind::kMapping, mark, tag, anchor);
  }
  void OnMapEnd() override { Close(); }

 private:
  struct Level {
    YamlNode node;
    bool has_key = false;  // a key has been read and its value has not
    std::map<std::string, int> line_of_key;
  };

  YamlPlace PlaceOf(const YAML::Mark& mark) const {
    return {source_, mark.line + 1, mark.column + 1};
  }
  [[noreturn]] void Refuse(const YAML::Mark& mark, const std::string& why) const {
    throw ConfigError(PlaceOf(mark).Text() + ": " + why);
  }
  void RefuseAnchor(const YAML::Mark& mark, YAML::anchor_t anchor) const {
    if (anchor != YAML::NullAnchor) Refuse(mark, "anchors (&name) are not read");
  }
  void RefuseTag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!") Refuse(mark, "tags (!name) are not read");
  }
  /// An escape such as \x1b puts any character into a quoted text. Results hold the texts of their
  /// files, and a control character in them would keep them from being read again.
  void RefuseControls(const YamlNode& node, std::string_view allowed) const {
    std::string text = node.scalar;
    std::erase_if(text, [&](char c) { return allowed.find(c) != std::string_view::npos; });
    const std::optional<char32_t> found = FirstControl(text);
    if (!found) return;
    throw ConfigError(node.place.Text() + ": expected text without control characters, found " +
                      CharacterName(*found));
  }
  YamlNode Make(YamlNode::Kind kind, const YAML::Mark& mark) {
    if (++nodes_ > kMaxNodes) {
      Refuse(mark, "more than " + std::to_string(kMaxNodes) + " values in one file");
    }
    YamlNode node;
    node.kind = kind;
    node.place = PlaceOf(mark);
    return node;
  }
  void Open(YamlNode::Kind kind, const YAML::Mark& mark, const std::string& tag,
            YAML::anchor_t anchor) {
    RefuseAnchor(mark, anchor);
    RefuseTag(mark, tag);
    if (levels_.size() >= kMaxDepth) {
      Refuse(mark, "nested deeper than " + std::to_string(kMaxDepth) + " levels");
    }
    if (ExpectsKey()) Refuse(mark, "expected a key, found a list or mapping");
    levels_.push_back({Make(kind, mark), false, {}});
  }
  void Close() {
    YamlNode node = std::move(levels_.back().node);
    levels_.pop_back();
    Add(std::move(node));
  }
  bool ExpectsKey() const {
    return !levels_.empty() && levels_.back().node.kind == YamlNode::Kind::kMapping &&
           !levels_.back().has_key;
  }
  std::string PathTo(const std::string& key) const {
    std::string path;
    for (const Level& level : levels_) {
      if (level.has_key) path += level.node.keys.back().name + ".";
    }
    return path + key;
  }
  void AddKey(YamlNode node) {
    if (node.kind != YamlNode::Kind::kScalar || node.scalar.empty()) {
      throw ConfigError(node.place.Text() + ": expected a key, found " + node.Found());
    }
    RefuseControls(node, "");
    Level& level = levels_.back();
    const auto [first, fresh] = level.line_of_key.emplace(node.scalar, node.place.line);
    if (!fresh) {
      throw ConfigError(node.place.Text() + ": " + PathTo(node.scalar) +
                        ": given twice, first in line " + std::to_string(first->second));
    }
    level.node.keys.push_back({std::move(node.scalar), std::move(node.place)});
    level.has_key = true;
  }
  void Add(YamlNode node) {
    if (levels_.empty()) {
      root_ = std::move(node);
    } else if (ExpectsKey()) {
      AddKey(std::move(node));
    } else {
      levels_.back().node.items.push_back(std::move(node));
      levels_.back().has_key = false;
    }
  }

  std::shared_ptr<const std::string> source_;
  std::vector<Level> levels_;
  YamlNode root_;
  int nodes_ = 0;
};

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

YamlNode ParseYaml(const std::string& text, const std::string& file) {
  const auto source = std::make_shared<const std::string>(file);
  CheckIsText(text, file);
  try {
    std::istringstream in{std::string(WithoutByteOrderMark(text))};
    YAML::Parser parser(in);
    TreeBuilder builder(source);
    if (!parser.HandleNextDocument(builder)) throw ConfigError(file + ":1:1: the file is empty");
    YamlNode root = builder.TakeRoot();
    TreeBuilder rest(source);
    if (parser.HandleNextDocument(rest)) {
      throw ConfigError(rest.TakeRoot().place.Text() + ": expected one document, found another");
    }
    if (!root.place.source) root.place = {source, 1, 1};
    return root;
  } catch (const YAML::Exception& error) {
    const bool placed = !error.mark.is_null();
    const YamlPlace place{source, placed ? error.mark.line + 1 : 1,
                          placed ? error.mark.column + 1 : 1};
    throw ConfigError(place.Text() + ": not valid YAML: " + error.msg);
  }
}

YamlNode LoadYaml(const std::filesystem::path& file) {
  return ParseYaml(ReadText(file), file.string());
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
    if (++depth > kMaxDepth) throw ConfigError(*option + ": nested too deep");
  }
  MergeYaml(root, value);
}

}  // namespace dockyard
