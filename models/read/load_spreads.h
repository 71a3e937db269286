// The mapping `spreads` of a model's file: how far its numbers are open.
#pragma once

#include <optional>
#include <vector>

#include "models/read/keys.h"

namespace dockyard {

/// Limits between which all values count as equally likely (JCGM 100:2008, 4.3.7).
struct Limits {
  enum class Of {
    kValue,     // of the number itself
    kLogValue,  // of the number, equally likely in every decade
    kTimes,     // of the factor on it
    kPlus,      // of what is added to it
    kOneOf,     // no limits: one of the values
  };
  Of of = Of::kValue;
  double low = 0.0, high = 0.0;
  std::vector<double> values{};  // kOneOf

  bool operator==(const Limits&) const = default;
};

struct NumberSpread {
  YamlNode::Key key;                // dotted, of a number in the same file
  std::optional<Limits> assumed;    // what the number may be, where it is not known
  std::optional<Limits> tolerance;  // what is built against the number
};

/// Reads the optional mapping `spreads` of a file's root. Throws ConfigError.
std::vector<NumberSpread> ReadSpreads(const YamlNode& root);

/// Names the key `spreads`, which CheckSpreads reads.
void NameSpreads(Keys& keys);
/// Throws ConfigError for a spread whose key is no number of `model`: the file's root with all
/// numbers that it may leave out.
void CheckSpreads(const YamlNode& model);

}  // namespace dockyard
