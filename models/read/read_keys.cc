#include <algorithm>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/keys.h"

namespace dockyard {
namespace {

/// The mapping's own keys, before any is read: an unknown key is reported before a missing one.
class NameKeys : public Keys {
 public:
  struct RefusedKey {
    std::string name, hint;
  };

  void Number(const Key& key, double&, const Range&) override { Add(key); }
  void Degrees(const Key& key, double&, const Range&) override { Add(key); }
  void Integer(const Key& key, int&, int, int) override { Add(key); }
  void Seed(const Key& key, std::uint64_t&) override { Add(key); }
  void Bool(const Key& key, bool&) override { Add(key); }
  void Text(const Key& key, std::string&) override { Add(key); }
  void Word(const Key& key, std::string&, const std::vector<std::string>&) override { Add(key); }
  void WordOrMapping(const Key& key, std::string&, const std::vector<std::string>&,
                     std::string_view, const Visit&) override {
    Add(key);
  }
  void Texts(const Key& key, std::vector<std::string>&, std::size_t) override { Add(key); }
  void File(const Key& key, std::string&) override { Add(key); }
  void Tree(const Key& key, YamlNode&, YamlNode::Kind) override { Add(key); }
  void Mapping(const Key& key, const Visit&) override { Add(key); }
  void List(const Key& key, std::size_t, std::size_t, std::size_t,
            const std::function<void(std::size_t)>&,
            const std::function<void(Keys&, std::size_t)>&) override {
    Add(key);
  }
  void Vector3(const Key& key, Eigen::Vector3d&, const Range&) override { Add(key); }
  bool reads() const override { return true; }
  void Refused(std::string_view name, std::string_view hint) override {
    refused.push_back({std::string(name), std::string(hint)});
  }
  void RefusedWord(std::string_view, std::string_view, std::string_view) override {}

  std::vector<std::string> names;
  std::vector<RefusedKey> refused;

 private:
  void Add(const Key& key) { names.emplace_back(key.name); }
};

void RefuseKey(const YamlNode::Key& key, const std::string& path, std::string_view hint) {
  throw ConfigError(key.place.Text() + ": " + (path.empty() ? "" : path + ".") + key.name +
                    ": expected " + std::string(hint));
}

class ReadArchive : public Keys {
 public:
  ReadArchive(const YamlNode& node, const std::string& path, std::vector<std::string> names,
              bool demands)
      : node_(node), path_(path), in_(node, path, std::move(names)), demands_(demands) {}

  void Number(const Key& key, double& value, const Range& range) override {
    if (Given(key)) value = in_.Number(key.name, range);
  }
  void Degrees(const Key& key, double& value_rad, const Range& range_deg) override {
    if (Given(key)) value_rad = in_.Degrees(key.name, range_deg);
  }
  void Integer(const Key& key, int& value, int low, int high) override {
    if (Given(key)) value = in_.Integer(key.name, low, high);
  }
  void Seed(const Key& key, std::uint64_t& value) override {
    if (Given(key)) value = in_.SeedOr(key.name, value);
  }
  void Bool(const Key& key, bool& value) override {
    if (Given(key)) value = in_.BoolOr(key.name, value);
  }
  void Text(const Key& key, std::string& value) override {
    if (Given(key)) value = in_.Text(key.name);
  }
  void Word(const Key& key, std::string& value, const std::vector<std::string>& words) override {
    if (Given(key)) value = words[static_cast<std::size_t>(in_.Choice(key.name, words))];
  }
  void WordOrMapping(const Key& key, std::string& value, const std::vector<std::string>& words,
                     std::string_view mapped, const Visit& inside) override {
    if (!Given(key)) return;
    if (in_.Child(key.name).kind != YamlNode::Kind::kMapping) return Word(key, value, words);
    Descend(key, inside);
    value = mapped;
  }
  void Texts(const Key& key, std::vector<std::string>& values, std::size_t most) override {
    if (!Given(key)) return;
    values.clear();
    for (const YamlNode& item : in_.List(key.name, 1, most).items) {
      if (item.kind != YamlNode::Kind::kScalar || item.scalar.empty()) {
        throw ConfigError(item.place.Text() + ": " + in_.PathOf(key.name) +
                          ": expected a list of texts, found " + item.Found() + " in it");
      }
      values.push_back(item.scalar);
    }
  }
  void File(const Key& key, std::string& path) override {
    if (Given(key)) path = in_.File(key.name);
  }
  void Tree(const Key& key, YamlNode& tree, YamlNode::Kind kind) override {
    if (!Given(key)) return;
    if (kind != YamlNode::Kind::kNull && in_.Child(key.name).kind != kind) {
      in_.Refuse(key.name, kind == YamlNode::Kind::kMapping ? "a mapping (key: value)" : "a list");
    }
    tree = in_.Child(key.name);
  }
  void Mapping(const Key& key, const Visit& inside) override {
    if (Given(key)) Descend(key, inside);
  }
  void List(const Key& key, std::size_t least, std::size_t most, std::size_t /*count*/,
            const std::function<void(std::size_t)>& resize,
            const std::function<void(Keys&, std::size_t)>& inside) override {
    if (!Given(key)) return;
    const std::vector<YamlNode>& items = in_.List(key.name, least, most).items;
    resize(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      Read(
          items[i], YamlReader::PathOf(in_.PathOf(key.name), i),
          [&](Keys& keys) { inside(keys, i); }, demands_);
    }
  }
  void Vector3(const Key& key, Eigen::Vector3d& value, const Range& range) override {
    if (Given(key)) value = in_.Vector3(key.name, range);
  }
  bool reads() const override { return true; }
  void Allow(std::string_view key, bool allowed, const std::string& expected) override {
    if (!allowed && in_.Has(key)) in_.Refuse(key, expected);
  }
  void Check(std::string_view key, bool holds, const std::string& expected,
             const std::string& found) override {
    if (holds) return;
    if (!in_.Has(key)) {
      throw ConfigError(node_.place.Text() + ": " + in_.PathOf(key) + ": expected " + expected);
    }
    found.empty() ? in_.Refuse(key, expected) : in_.Refuse(key, expected, found);
  }
  void Refused(std::string_view name, std::string_view hint) override {
    for (const YamlNode::Key& key : node_.keys) {
      if (key.name == name) RefuseKey(key, path_, hint);
    }
  }
  void RefusedWord(std::string_view name, std::string_view word, std::string_view hint) override {
    const std::string key(name);
    if (!in_.Has(key)) return;
    const YamlNode& value = in_.Child(key);
    if (value.kind == YamlNode::Kind::kScalar && value.scalar == word)
      in_.Refuse(key, std::string(hint));
  }

  static void Read(const YamlNode& node, const std::string& path, const Visit& visit, bool demands);

 private:
  bool Given(const Key& key) const {
    if (in_.Has(key.name)) return true;
    if (demands_ && key.presence == Presence::kRequired) in_.Child(key.name);  // throws: missing
    return false;
  }
  void Descend(const Key& key, const Visit& inside) const {
    Read(in_.Child(key.name), in_.PathOf(key.name), inside, demands_);
  }

  const YamlNode& node_;
  const std::string& path_;
  YamlReader in_;
  bool demands_;
};

void ReadArchive::Read(const YamlNode& node, const std::string& path, const Visit& visit,
                       bool demands) {
  NameKeys known;
  visit(known);
  for (const NameKeys::RefusedKey& refused : known.refused) {
    for (const YamlNode::Key& key : node.keys) {
      if (key.name == refused.name) RefuseKey(key, path, refused.hint);
    }
  }
  ReadArchive archive(node, path, std::move(known.names), demands);
  visit(archive);
}

void Read(const YamlNode& node, const std::string& path, const Keys::Visit& visit, bool demands) {
  if (node.kind != YamlNode::Kind::kNull) return ReadArchive::Read(node, path, visit, demands);
  YamlNode empty;
  empty.kind = YamlNode::Kind::kMapping;
  empty.place = node.place;
  ReadArchive::Read(empty, path, visit, demands);
}

}  // namespace

void ReadKeys(const YamlNode& node, const std::string& path, const Keys::Visit& visit) {
  Read(node, path, visit, true);
}

void ReadSomeKeys(const YamlNode& node, const std::string& path, const Keys::Visit& visit) {
  Read(node, path, visit, false);
}

std::vector<std::string> KeyNames(const Keys::Visit& visit) {
  NameKeys known;
  visit(known);
  return known.names;
}

}  // namespace dockyard
