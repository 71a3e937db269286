#include "sim/scenario/key_schema.h"

#include <cmath>
#include <limits>

namespace dockyard {
namespace {

constexpr int kLongestText = 400;  // YamlReader::Text

Json NumberSchema(const Range& range) {
  return {{"type", "number"},
          {range.open_low ? "exclusiveMinimum" : "minimum", range.low},
          {"maximum", range.high}};
}

Json WordSchema(const std::vector<std::string>& words) {
  if (words.empty()) return {{"type", "string"}};
  return {{"enum", words}};
}

class SchemaArchive : public Keys {
 public:
  explicit SchemaArchive(bool whole) : whole_(whole) {}

  void Number(const Key& key, double& value, const Range& range) override {
    Add(key, NumberSchema(range), Default([&](Keys& k) { k.Number(key, value, range); }));
  }
  void Degrees(const Key& key, double& value_rad, const Range& range_deg) override {
    Add(key, NumberSchema(range_deg),
        Default([&](Keys& k) { k.Degrees(key, value_rad, range_deg); }));
  }
  void Integer(const Key& key, int& value, int low, int high) override {
    Add(key, {{"type", "integer"}, {"minimum", low}, {"maximum", high}},
        Default([&](Keys& k) { k.Integer(key, value, low, high); }));
  }
  void Seed(const Key& key, std::uint64_t& value) override { Add(key, SeedSchema(), value); }
  void Bool(const Key& key, bool& value) override { Add(key, {{"type", "boolean"}}, value); }
  void Text(const Key& key, std::string& value) override {
    Add(key, {{"type", "string"}, {"minLength", 1}, {"maxLength", kLongestText}}, OrNone(value));
  }
  void Word(const Key& key, std::string& value, const std::vector<std::string>& words) override {
    Add(key, WordSchema(words), OrNone(value));
  }
  void WordOrMapping(const Key& key, std::string& value, const std::vector<std::string>& words,
                     std::string_view, const Visit& inside) override {
    Add(key, {{"anyOf", {WordSchema(words), SchemaOfKeys(inside, whole_)}}}, OrNone(value));
  }
  void Texts(const Key& key, std::vector<std::string>&, std::size_t most) override {
    Add(key,
        {{"type", "array"},
         {"items", {{"type", {"string", "number"}}}},
         {"minItems", 1},
         {"maxItems", most}},
        nullptr);
  }
  void File(const Key& key, std::string&) override {
    Add(key, {{"type", "string"}, {"minLength", 1}}, nullptr);
  }
  void Tree(const Key& key, YamlNode&, YamlNode::Kind kind) override {
    Json schema = Json::object();
    if (kind != YamlNode::Kind::kNull) {
      schema["type"] = kind == YamlNode::Kind::kMapping ? "object" : "array";
    }
    Add(key, std::move(schema), nullptr);
  }
  void Mapping(const Key& key, const Visit& inside) override {
    Add(key, SchemaOfKeys(inside, whole_), nullptr);
  }
  void List(const Key& key, std::size_t least, std::size_t most, std::size_t,
            const std::function<void(std::size_t)>& resize,
            const std::function<void(Keys&, std::size_t)>& inside) override {
    resize(1);
    Add(key,
        {{"type", "array"},
         {"items", SchemaOfKeys([&](Keys& keys) { inside(keys, 0); }, whole_)},
         {"minItems", least},
         {"maxItems", most}},
        nullptr);
  }
  void Vector3(const Key& key, Eigen::Vector3d&, const Range& range) override {
    Add(key, {{"type", "array"}, {"items", NumberSchema(range)}, {"minItems", 3}, {"maxItems", 3}},
        nullptr);
  }
  void Refused(std::string_view, std::string_view) override {}
  void RefusedWord(std::string_view, std::string_view, std::string_view) override {}

  Json schema() const {
    Json object{{"type", "object"}, {"properties", properties_}};
    if (!required_.empty()) object["required"] = required_;
    object["additionalProperties"] = false;
    return object;
  }

 private:
  /// The number as a file would say it; null for none.
  static Json Default(const Visit& visit) {
    const YamlNode tree = WriteKeys(visit);
    double value = 0.0;
    if (tree.items.empty() || !ParseNumber(tree.items[0].scalar, value)) return nullptr;
    return value;
  }
  static Json OrNone(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

  void Add(const Key& key, Json schema, Json default_value) {
    std::string meaning(key.meaning);
    if (!key.unit.empty()) meaning += " [" + std::string(key.unit) + "]";
    if (!meaning.empty()) schema["description"] = meaning;
    const bool required = key.presence == Presence::kRequired;
    if (!required && !default_value.is_null()) schema["default"] = std::move(default_value);
    if (required && whole_) required_.push_back(key.name);
    properties_[std::string(key.name)] = std::move(schema);
  }

  bool whole_;
  Json properties_ = Json::object(), required_ = Json::array();
};

}  // namespace

Json SchemaOfKeys(const Keys::Visit& visit, bool whole) {
  SchemaArchive archive(whole);
  visit(archive);
  return archive.schema();
}

Json SchemaOfModel(const Keys::Visit& visit) {
  Json changed = SchemaOfKeys(visit, false);
  changed["properties"]["base"] = {{"type", "string"}, {"minLength", 1}};
  return {{"if", {{"required", {"base"}}}}, {"then", changed}, {"else", SchemaOfKeys(visit, true)}};
}

Json SeedSchema() {
  return {
      {"type", "integer"}, {"minimum", 0}, {"maximum", std::numeric_limits<std::uint64_t>::max()}};
}

}  // namespace dockyard
