#include <cmath>
#include <optional>
#include <utility>

#include "sim/scenario/keys.h"

namespace dockyard {
namespace {

using Kind = KeyRow::Kind;

std::string KindName(Kind kind) {
  switch (kind) {
    case Kind::kNumber:
      return "number";
    case Kind::kInteger:
      return "whole number";
    case Kind::kBool:
      return "true or false";
    case Kind::kText:
      return "text";
    case Kind::kWord:
      return "word";
    case Kind::kTexts:
      return "list of texts";
    case Kind::kFile:
      return "file";
    case Kind::kMapping:
      return "mapping";
    case Kind::kList:
      return "list";
  }
  return "";
}

std::string RangeText(const Range& range) {
  return (range.open_low ? "above " : "") + NumberText(range.low) + " to " + NumberText(range.high);
}

/// A number of a file, to a thousandth: the code has some angles in round radians.
std::string Brief(const std::string& number) {
  const std::optional<double> value = NumberFromText(number);
  return value && std::abs(*value) >= 0.1 ? NumberText(std::round(1e3 * *value) / 1e3) : number;
}

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

class DocumentArchive : public Keys {
 public:
  DocumentArchive(std::vector<KeyRow>& rows, std::string prefix)
      : rows_(rows), prefix_(std::move(prefix)) {}

  void Number(const Key& key, double& value, const Range& range) override {
    Add(key, Kind::kNumber, RangeText(range),
        Written([&](Keys& k) { k.Number(key, value, range); }));
  }
  void Degrees(const Key& key, double& value_rad, const Range& range_deg) override {
    Add(key, Kind::kNumber, RangeText(range_deg),
        Brief(Written([&](Keys& k) { k.Degrees(key, value_rad, range_deg); })));
  }
  void Integer(const Key& key, int& value, int low, int high) override {
    Add(key, Kind::kInteger, std::to_string(low) + " to " + std::to_string(high),
        Written([&](Keys& k) { k.Integer(key, value, low, high); }));
  }
  void Seed(const Key& key, std::uint64_t& value) override {
    Add(key, Kind::kInteger, "0 to 18446744073709551615", std::to_string(value));
  }
  void Bool(const Key& key, bool& value) override {
    Add(key, Kind::kBool, "", value ? "true" : "false");
  }
  void Text(const Key& key, std::string& value) override { Add(key, Kind::kText, "", value); }
  void Word(const Key& key, std::string& value, const std::vector<std::string>& words) override {
    Add(key, Kind::kWord, Joined(words), value);
  }
  void WordOrMapping(const Key& key, std::string& value, const std::vector<std::string>& words,
                     std::string_view, const Visit& inside) override {
    Add(key, Kind::kWord, Joined(words) + ", or a mapping", value);
    Descend(key, inside);
  }
  void Texts(const Key& key, std::vector<std::string>& values, std::size_t most) override {
    Add(key, Kind::kTexts, "1 to " + std::to_string(most), Joined(values));
  }
  void File(const Key& key, std::string& path) override { Add(key, Kind::kFile, "", path); }
  void Tree(const Key& key, YamlNode&, YamlNode::Kind kind) override {
    Add(key, kind == YamlNode::Kind::kMapping ? Kind::kMapping : Kind::kList, "", "");
  }
  void Mapping(const Key& key, const Visit& inside) override { Descend(key, inside); }
  void List(const Key& key, std::size_t least, std::size_t most, std::size_t,
            const std::function<void(std::size_t)>& resize,
            const std::function<void(Keys&, std::size_t)>& inside) override {
    Add(key, Kind::kList, std::to_string(least) + " to " + std::to_string(most), "");
    resize(1);
    DocumentArchive archive(rows_, prefix_ + std::string(key.name) + "[].");
    inside(archive, 0);
  }
  void Vector3(const Key& key, Eigen::Vector3d&, const Range& range) override {
    Add(key, Kind::kList, "3 numbers, " + RangeText(range), "");
  }
  void Refused(std::string_view, std::string_view) override {}
  void RefusedWord(std::string_view, std::string_view, std::string_view) override {}

 private:
  /// The default as a file would say it; empty for none.
  static std::string Written(const Visit& visit) {
    const YamlNode tree = WriteKeys(visit);
    return tree.items.empty() ? "" : tree.items[0].scalar;
  }
  void Add(const Key& key, Kind kind, std::string range, std::string default_text) {
    if (key.presence == Presence::kRequired) default_text = "required";
    if (default_text.empty()) default_text = "none";
    rows_.push_back({prefix_ + std::string(key.name), kind, std::move(range), std::string(key.unit),
                     std::move(default_text), std::string(key.meaning)});
  }
  void Descend(const Key& key, const Visit& inside) {
    DocumentArchive archive(rows_, prefix_ + std::string(key.name) + ".");
    inside(archive);
  }

  std::vector<KeyRow>& rows_;
  std::string prefix_;
};

}  // namespace

std::vector<KeyRow> DocumentKeys(const Keys::Visit& visit) {
  std::vector<KeyRow> rows;
  DocumentArchive archive(rows, "");
  visit(archive);
  return rows;
}

std::string KeyTable(const std::vector<KeyRow>& rows) {
  std::string text =
      "| key | kind | range | unit | default | meaning |\n|---|---|---|---|---|---|\n";
  for (const KeyRow& row : rows) {
    text += "| `" + row.key + "` | " + KindName(row.kind) + " | " + row.range + " | " + row.unit +
            " | " + row.default_text + " | " + row.meaning + " |\n";
  }
  return text;
}

}  // namespace dockyard
