// The keys of a mapping (models/read/keys.h) written, compared and documented.
#pragma once

#include <string>
#include <vector>

#include "models/read/keys.h"

namespace dockyard {

/// The mapping that reads back to the same values, bit for bit when angles came from degrees in a
/// file; with every default, and absolute paths.
YamlNode WriteKeys(const Keys::Visit& visit);

/// Dotted keys whose values differ between two written mappings, in the order of the first.
std::vector<std::string> DifferingKeys(const YamlNode& a, const YamlNode& b);

/// A key as a reference page has it. Keys within a mapping are dotted.
struct KeyRow {
  enum class Kind { kNumber, kInteger, kBool, kText, kWord, kTexts, kFile, kMapping, kList };
  std::string key;
  Kind kind = Kind::kNumber;
  std::string range, unit, default_text, meaning;
};
/// Defaults are what the visitor's variables hold.
std::vector<KeyRow> DocumentKeys(const Keys::Visit& visit);
/// The rows as a table of Markdown.
std::string KeyTable(const std::vector<KeyRow>& rows);

}  // namespace dockyard
