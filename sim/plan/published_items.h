// Names, filters and counts of the file of a publication.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "models/read/yaml_reader.h"
#include "sim/plan/published.h"

namespace dockyard {

inline constexpr int kMostPublishedRuns = 1000000;
inline constexpr std::size_t kMostPublishedItems = 100;

/// All throw ConfigError with file, line and column.
PublishedName NameOf(const YamlReader& in, const char* key);
/// A list of names; none without the key.
std::vector<PublishedName> NamesOf(const YamlReader& in, const char* key);
std::vector<std::string> TextsOf(const YamlReader& in, const char* key);
/// `where` as {label: text} or {label: [texts]}.
std::vector<LabelFilter> FiltersOf(const YamlReader& in);
/// `where` as {column: number} or {column: [numbers]}.
std::vector<ColumnFilter> ColumnFiltersOf(const YamlReader& in);
/// [count, runs]
std::optional<PublishedCount> CountOf(const YamlReader& in, const char* key);

}  // namespace dockyard
