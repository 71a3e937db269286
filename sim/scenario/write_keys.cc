#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <utility>

#include "controller/geometry/pose.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/keys.h"

namespace dockyard {
namespace {

/// The number of degrees, as short as can be, that Radians turns into exactly this angle.
double ExactDegrees(double angle_rad) {
  const double nearest = Degrees(angle_rad);
  for (const double scale : {1.0, 10.0, 1e3, 1e6, 1e9}) {
    const double rounded = std::round(nearest * scale) / scale;
    if (Radians(rounded) == angle_rad) return rounded == 0.0 ? 0.0 : rounded;
  }
  double below = nearest, above = nearest;
  for (int i = 0; i < 8; ++i) {
    if (Radians(below) == angle_rad) return below;
    if (Radians(above) == angle_rad) return above;
    below = std::nextafter(below, -std::numeric_limits<double>::infinity());
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
  }
  return nearest;
}

bool Inside(double value, const Range& range) {
  return (range.open_low ? value > range.low : value >= range.low) && value <= range.high;
}

YamlNode Scalar(std::string text, bool quoted = false) {
  YamlNode node;
  node.kind = YamlNode::Kind::kScalar;
  node.scalar = std::move(text);
  node.quoted = quoted;
  return node;
}

class WriteArchive : public Keys {
 public:
  WriteArchive() { tree.kind = YamlNode::Kind::kMapping; }

  void Number(const Key& key, double& value, const Range& range) override {
    if (key.presence == Presence::kUnset && !Inside(value, range)) return;
    Add(key, Scalar(NumberText(value)));
  }
  void Degrees(const Key& key, double& value_rad, const Range& range_deg) override {
    const double value_deg = ExactDegrees(value_rad);
    if (key.presence == Presence::kUnset && !Inside(value_deg, range_deg)) return;
    Add(key, Scalar(NumberText(value_deg)));
  }
  void Integer(const Key& key, int& value, int low, int high) override {
    if (key.presence == Presence::kUnset && (value < low || value > high)) return;
    Add(key, Scalar(std::to_string(value)));
  }
  void Seed(const Key& key, std::uint64_t& value) override {
    Add(key, Scalar(std::to_string(value)));
  }
  void Bool(const Key& key, bool& value) override { Add(key, Scalar(value ? "true" : "false")); }
  void Text(const Key& key, std::string& value) override {
    if (!value.empty()) Add(key, Scalar(value, true));
  }
  void Word(const Key& key, std::string& value, const std::vector<std::string>&) override {
    if (!value.empty()) Add(key, Scalar(value));
  }
  void WordOrMapping(const Key& key, std::string& value, const std::vector<std::string>& words,
                     std::string_view mapped, const Visit& inside) override {
    if (value != mapped) return Word(key, value, words);
    Mapping(key, inside);
  }
  void Texts(const Key& key, std::vector<std::string>& values, std::size_t) override {
    if (values.empty()) return;
    YamlNode list;
    list.kind = YamlNode::Kind::kSequence;
    for (const std::string& value : values) list.items.push_back(Scalar(value, true));
    Add(key, std::move(list));
  }
  void File(const Key& key, std::string& path) override {
    if (!path.empty()) Add(key, Scalar(AbsolutePath(path), true));
  }
  void Tree(const Key& key, YamlNode& kept, YamlNode::Kind) override {
    if (kept.kind != YamlNode::Kind::kNull) Add(key, kept);
  }
  void Mapping(const Key& key, const Visit& inside) override {
    WriteArchive archive;
    inside(archive);
    if (!archive.tree.keys.empty()) Add(key, std::move(archive.tree));
  }
  void List(const Key& key, std::size_t, std::size_t, std::size_t count,
            const std::function<void(std::size_t)>&,
            const std::function<void(Keys&, std::size_t)>& inside) override {
    YamlNode list;
    list.kind = YamlNode::Kind::kSequence;
    for (std::size_t i = 0; i < count; ++i) {
      WriteArchive item;
      inside(item, i);
      list.items.push_back(std::move(item.tree));
    }
    Add(key, std::move(list));
  }
  void Vector3(const Key& key, Eigen::Vector3d& value, const Range&) override {
    YamlNode list;
    list.kind = YamlNode::Kind::kSequence;
    for (const double number : value) list.items.push_back(Scalar(NumberText(number)));
    Add(key, std::move(list));
  }
  bool writes() const override { return true; }
  void Refused(std::string_view, std::string_view) override {}
  void RefusedWord(std::string_view, std::string_view, std::string_view) override {}

  YamlNode tree;

 private:
  void Add(const Key& key, YamlNode value) {
    tree.keys.push_back({std::string(key.name), {}});
    tree.items.push_back(std::move(value));
  }
};

/// The keys of both, each once, those of the first before the others.
std::vector<std::string> KeysOfBoth(const YamlNode& a, const YamlNode& b) {
  std::vector<std::string> names;
  for (const YamlNode::Key& key : a.keys) names.push_back(key.name);
  for (const YamlNode::Key& key : b.keys) {
    if (a.Find(key.name) == nullptr) names.push_back(key.name);
  }
  return names;
}

/// A mapping that is missing differs in every key that the other has.
void AddDiffering(const YamlNode& a, const YamlNode& b, const std::string& path,
                  std::vector<std::string>& differing) {
  using Kind = YamlNode::Kind;
  const bool mappings = (a.kind == Kind::kMapping && b.kind == Kind::kMapping) ||
                        (a.kind == Kind::kMapping && b.kind == Kind::kNull) ||
                        (a.kind == Kind::kNull && b.kind == Kind::kMapping);
  if (!mappings) {
    const bool scalars = a.kind == Kind::kScalar && b.kind == Kind::kScalar;
    if (scalars ? a.scalar != b.scalar : FlowText(a) != FlowText(b)) differing.push_back(path);
    return;
  }
  const YamlNode none;
  for (const std::string& name : KeysOfBoth(a, b)) {
    const YamlNode* in_a = a.Find(name);
    const YamlNode* in_b = b.Find(name);
    AddDiffering(in_a != nullptr ? *in_a : none, in_b != nullptr ? *in_b : none,
                 path.empty() ? name : path + "." + name, differing);
  }
}

}  // namespace

YamlNode WriteKeys(const Keys::Visit& visit) {
  WriteArchive archive;
  visit(archive);
  return std::move(archive.tree);
}

std::vector<std::string> DifferingKeys(const YamlNode& a, const YamlNode& b) {
  std::vector<std::string> differing;
  AddDiffering(a, b, "", differing);
  return differing;
}

}  // namespace dockyard
