// One YAML mapping read into one struct, strictly: unknown keys, missing keys, wrong kinds and
// numbers out of range throw ConfigError with file, line, column and path of keys.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "controller/base/number_text.h"
#include "models/read/yaml_tree.h"

namespace dockyard {

/// The allowed values of a number.
struct Range {
  double low = 0.0, high = 0.0;
  bool open_low = false;  // low itself is out
};
constexpr Range Positive(double high) { return {0.0, high, true}; }
constexpr Range NonNegative(double high) { return {0.0, high, false}; }
constexpr Range Between(double low, double high) { return {low, high, false}; }

/// "a number > 0" (with "and <= 5" when the value is beyond it), "a number from -1 to 1".
std::string Describe(const Range& range, bool too_high, std::string_view noun = "a number");

class YamlReader {
 public:
  /// Checks that the node is a mapping with none but these keys. `path` is the dotted path of the
  /// mapping itself, empty for the root. The node must outlive the reader.
  YamlReader(const YamlNode& node, std::string path, std::vector<std::string> keys);

  bool Has(std::string_view key) const;
  double Number(std::string_view key, const Range& range) const;
  double NumberOr(std::string_view key, double fallback, const Range& range) const;
  /// Written in degrees, given in radians; the range is in degrees.
  double Degrees(std::string_view key, const Range& range_deg) const;
  double DegreesOr(std::string_view key, double fallback_rad, const Range& range_deg) const;
  int Integer(std::string_view key, int low, int high) const;
  int IntegerOr(std::string_view key, int fallback, int low, int high) const;
  std::uint64_t SeedOr(std::string_view key, std::uint64_t fallback) const;
  bool BoolOr(std::string_view key, bool fallback) const;
  /// A name or sentence, not empty, at most 400 bytes, one line.
  std::string Text(std::string_view key) const;
  std::string TextOr(std::string_view key, const std::string& fallback) const;
  /// One of the given words; its index.
  int Choice(std::string_view key, const std::vector<std::string>& words) const;
  int ChoiceOr(std::string_view key, int fallback, const std::vector<std::string>& words) const;
  Eigen::Vector3d Vector3(std::string_view key, const Range& range) const;
  /// Red, green, blue, each 0 to 1.
  Eigen::Vector3d Rgb(std::string_view key) const { return Vector3(key, Between(0.0, 1.0)); }
  /// A file that exists, relative to the file in which the value is written.
  std::string File(std::string_view key) const;
  /// The mapping or list under a key.
  const YamlNode& Child(std::string_view key) const;
  const YamlNode& List(std::string_view key, std::size_t least, std::size_t most) const;

  /// Dotted path of a key of this mapping, and of an item of a list.
  std::string PathOf(std::string_view key) const;
  static std::string PathOf(const std::string& list, std::size_t index);
  /// Throws ConfigError about the value of a key that is there.
  [[noreturn]] void Refuse(std::string_view key, const std::string& expected) const;
  /// The same where the value alone does not tell what is wrong with it.
  [[noreturn]] void Refuse(std::string_view key, const std::string& expected,
                           const std::string& found) const;

 private:
  const YamlNode& Need(std::string_view key) const;
  void CheckKnown(const YamlNode& node) const;

  const YamlNode& node_;
  std::string path_;
  std::vector<std::string> keys_;
};

}  // namespace dockyard
