// YAML's text as a tree.
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/text_file.h"
#include "models/read/yaml_tree.h"

namespace dockyard {
namespace {

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
    if (levels_.size() >= kMaxYamlDepth) {
      Refuse(mark, "nested deeper than " + std::to_string(kMaxYamlDepth) + " levels");
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

}  // namespace

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

}  // namespace dockyard
