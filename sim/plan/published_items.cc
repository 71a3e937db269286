#include "sim/plan/published_items.h"

#include <cmath>
#include <utility>

#include "models/read/config_error.h"

namespace dockyard {
namespace {

[[noreturn]] void Fail(const YamlNode& node, const std::string& path, const std::string& expected) {
  throw ConfigError(node.place.Text() + ": " + path + ": expected " + expected + ", found " +
                    node.Found());
}

PublishedName NameAt(const YamlNode& node, const std::string& path) {
  if (node.kind != YamlNode::Kind::kScalar || node.scalar.empty()) Fail(node, path, "a name");
  return {node.scalar, node.place, path};
}

}  // namespace

PublishedName NameOf(const YamlReader& in, const char* key) {
  return NameAt(in.Child(key), in.PathOf(key));
}

std::vector<PublishedName> NamesOf(const YamlReader& in, const char* key) {
  std::vector<PublishedName> names;
  if (!in.Has(key)) return names;
  const YamlNode& list = in.List(key, 1, kMostPublishedItems);
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    names.push_back(NameAt(list.items[i], YamlReader::PathOf(in.PathOf(key), i)));
  }
  return names;
}

std::vector<std::string> TextsOf(const YamlReader& in, const char* key) {
  std::vector<std::string> texts;
  for (const PublishedName& name : NamesOf(in, key)) texts.push_back(name.text);
  return texts;
}

std::vector<LabelFilter> FiltersOf(const YamlReader& in) {
  std::vector<LabelFilter> filters;
  if (!in.Has("where")) return filters;
  const YamlNode& where = in.Child("where");
  if (where.kind != YamlNode::Kind::kMapping) {
    in.Refuse("where", "labels of the campaign, each with its texts");
  }
  for (std::size_t i = 0; i < where.keys.size(); ++i) {
    const std::string path = in.PathOf("where") + "." + where.keys[i].name;
    LabelFilter filter{{where.keys[i].name, where.keys[i].place, path}, {}};
    const YamlNode& value = where.items[i];
    if (value.kind == YamlNode::Kind::kSequence) {
      for (const YamlNode& item : value.items) filter.texts.push_back(NameAt(item, path).text);
    } else {
      filter.texts.push_back(NameAt(value, path).text);
    }
    filters.push_back(std::move(filter));
  }
  return filters;
}

std::vector<ColumnFilter> ColumnFiltersOf(const YamlReader& in) {
  std::vector<ColumnFilter> filters;
  for (LabelFilter& filter : FiltersOf(in)) {
    ColumnFilter found{std::move(filter.label), {}};
    for (const std::string& text : filter.texts) {
      const auto value = NumberFromText(text);
      if (!value) {
        throw ConfigError(found.column.place.Text() + ": " + found.column.path +
                          ": expected numbers of the column, found '" + text + "'");
      }
      found.values.push_back(*value);
    }
    filters.push_back(std::move(found));
  }
  return filters;
}

std::optional<PublishedCount> CountOf(const YamlReader& in, const char* key) {
  if (!in.Has(key)) return std::nullopt;
  const YamlNode& list = in.Child(key);
  const auto whole = [](const YamlNode& node, int& value) {
    const auto number = node.kind == YamlNode::Kind::kScalar && !node.quoted
                            ? NumberFromText(node.scalar)
                            : std::nullopt;
    if (!number || *number != std::floor(*number) || *number < 0 || *number > kMostPublishedRuns) {
      return false;
    }
    value = static_cast<int>(*number);
    return true;
  };
  PublishedCount count;
  const bool good = list.kind == YamlNode::Kind::kSequence && list.items.size() == 2 &&
                    whole(list.items[0], count.count) && whole(list.items[1], count.runs) &&
                    count.count <= count.runs && count.runs > 0;
  if (!good) Fail(list, in.PathOf(key), "[count, runs], whole numbers with count <= runs");
  return count;
}

}  // namespace dockyard
