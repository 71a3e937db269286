#include "models/read/yaml_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "controller/base/check.h"
#include "controller/geometry/pose.h"
#include "models/read/config_error.h"
#include "models/read/near_names.h"
#include "models/read/text_file.h"

namespace dockyard {
namespace {

[[noreturn]] void Fail(const YamlNode& node, const std::string& path, const std::string& expected) {
  throw ConfigError(node.place.Text() + ": " + path + ": expected " + expected + ", found " +
                    node.Found());
}

double NumberAt(const YamlNode& node, const std::string& path, const Range& range) {
  double value = 0.0;
  const bool number =
      node.kind == YamlNode::Kind::kScalar && !node.quoted && ParseNumber(node.scalar, value);
  if (!number) Fail(node, path, Describe(range, false));
  const bool too_low = range.open_low ? !(value > range.low) : !(value >= range.low);
  if (too_low || !(value <= range.high)) Fail(node, path, Describe(range, !too_low));
  return value;
}

std::string Joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::string Describe(const Range& range, bool too_high, std::string_view noun) {
  const std::string text(noun);
  if (range.low != 0.0) {
    return text + (range.open_low ? " above " : " from ") + NumberText(range.low) + " to " +
           NumberText(range.high);
  }
  const std::string low = text + (range.open_low ? " > 0" : " >= 0");
  return too_high ? low + " and <= " + NumberText(range.high) : low;
}

YamlReader::YamlReader(const YamlNode& node, std::string path, std::vector<std::string> keys)
    : node_(node), path_(std::move(path)), keys_(std::move(keys)) {
  if (node.kind != YamlNode::Kind::kMapping) {
    const std::string place = node.place.Text() + (path_.empty() ? "" : ": " + path_);
    throw ConfigError(place + ": expected a mapping (key: value), found " + node.Found());
  }
  CheckKnown(node);
}

void YamlReader::CheckKnown(const YamlNode& node) const {
  for (const YamlNode::Key& key : node.keys) {
    if (std::find(keys_.begin(), keys_.end(), key.name) != keys_.end()) continue;
    const std::string nearest = NearestName(key.name, keys_);
    const std::string shown =
        YamlNode{YamlNode::Kind::kScalar, {}, key.name, false, {}, {}}.Found();
    const std::string full = PathOf(shown.substr(1, shown.size() - 2));
    if (key.place.from_option()) {
      throw ConfigError(key.place.Text() + ": unknown key '" + full + "'" +
                        (nearest.empty() ? ", known are: " + Joined(keys_)
                                         : ", did you mean '" + PathOf(nearest) + "'?"));
    }
    throw ConfigError(
        key.place.Text() + ": " + full + ": unknown key" +
        (nearest.empty() ? ", known are: " + Joined(keys_) : ", did you mean '" + nearest + "'?"));
  }
}

std::string YamlReader::PathOf(std::string_view key) const {
  return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

std::string YamlReader::PathOf(const std::string& list, std::size_t index) {
  return list + "[" + std::to_string(index) + "]";
}

bool YamlReader::Has(std::string_view key) const {
  DOCKYARD_CHECK(std::find(keys_.begin(), keys_.end(), key) != keys_.end());
  return node_.Find(key) != nullptr;
}

const YamlNode& YamlReader::Need(std::string_view key) const {
  if (!Has(key)) {
    throw ConfigError(node_.place.Text() + (path_.empty() ? "" : ": " + path_) + ": missing key '" +
                      std::string(key) + "'");
  }
  return *node_.Find(key);
}

void YamlReader::Refuse(std::string_view key, const std::string& expected) const {
  Fail(Need(key), PathOf(key), expected);
}

void YamlReader::Refuse(std::string_view key, const std::string& expected,
                        const std::string& found) const {
  throw ConfigError(Need(key).place.Text() + ": " + PathOf(key) + ": expected " + expected +
                    ", found " + found);
}

double YamlReader::Number(std::string_view key, const Range& range) const {
  return NumberAt(Need(key), PathOf(key), range);
}

double YamlReader::NumberOr(std::string_view key, double fallback, const Range& range) const {
  return Has(key) ? Number(key, range) : fallback;
}

double YamlReader::Degrees(std::string_view key, const Range& range_deg) const {
  return Radians(Number(key, range_deg));
}

double YamlReader::DegreesOr(std::string_view key, double fallback_rad,
                             const Range& range_deg) const {
  return Has(key) ? Degrees(key, range_deg) : fallback_rad;
}

int YamlReader::Integer(std::string_view key, int low, int high) const {
  const YamlNode& node = Need(key);
  int value = 0;
  const std::string& text = node.scalar;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = node.kind == YamlNode::Kind::kScalar && !node.quoted && error == std::errc() &&
                     end == text.data() + text.size();
  if (!whole || value < low || value > high) {
    Fail(node, PathOf(key),
         "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  }
  return value;
}

int YamlReader::IntegerOr(std::string_view key, int fallback, int low, int high) const {
  return Has(key) ? Integer(key, low, high) : fallback;
}

std::uint64_t YamlReader::SeedOr(std::string_view key, std::uint64_t fallback) const {
  if (!Has(key)) return fallback;
  const YamlNode& node = Need(key);
  std::uint64_t value = 0;
  const std::string& text = node.scalar;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = node.kind == YamlNode::Kind::kScalar && !node.quoted && error == std::errc() &&
                     end == text.data() + text.size();
  if (!whole) Fail(node, PathOf(key), "a whole number from 0 to 18446744073709551615");
  return value;
}

bool YamlReader::BoolOr(std::string_view key, bool fallback) const {
  if (!Has(key)) return fallback;
  const YamlNode& node = Need(key);
  const bool plain = node.kind == YamlNode::Kind::kScalar && !node.quoted;
  if (plain && node.scalar == "true") return true;
  if (plain && node.scalar == "false") return false;
  Fail(node, PathOf(key), "true or false");
}

std::string YamlReader::Text(std::string_view key) const {
  const YamlNode& node = Need(key);
  constexpr std::size_t kMaxLength = 400;
  const bool fits = node.kind == YamlNode::Kind::kScalar && !node.scalar.empty() &&
                    node.scalar.size() <= kMaxLength &&
                    node.scalar.find_first_of("\r\n\t") == std::string::npos;
  if (!fits) Fail(node, PathOf(key), "one line of text, at most 400 bytes");
  return node.scalar;
}

std::string YamlReader::TextOr(std::string_view key, const std::string& fallback) const {
  return Has(key) ? Text(key) : fallback;
}

int YamlReader::Choice(std::string_view key, const std::vector<std::string>& words) const {
  const YamlNode& node = Need(key);
  const auto at = std::find(words.begin(), words.end(), node.scalar);
  if (node.kind == YamlNode::Kind::kScalar && at != words.end()) {
    return static_cast<int>(at - words.begin());
  }
  Fail(node, PathOf(key), "one of " + Joined(words));
}

int YamlReader::ChoiceOr(std::string_view key, int fallback,
                         const std::vector<std::string>& words) const {
  return Has(key) ? Choice(key, words) : fallback;
}

Eigen::Vector3d YamlReader::Vector3(std::string_view key, const Range& range) const {
  const YamlNode& list = List(key, 3, 3);
  Eigen::Vector3d v;
  for (int i = 0; i < 3; ++i) {
    const auto index = static_cast<std::size_t>(i);
    v[i] = NumberAt(list.items[index], PathOf(PathOf(key), index), range);
  }
  return v;
}

std::string YamlReader::File(std::string_view key) const {
  const YamlNode& node = Need(key);
  const std::string written = Text(key);
  const bool option = node.place.from_option();  // given on the command line: as it stands
  const std::filesystem::path file =
      option ? std::filesystem::path(written) : ResolveBeside(*node.place.source, written);
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) {
    throw ConfigError(node.place.Text() + ": " + PathOf(key) +
                      ": expected a file, found none at '" + file.string() + "'" +
                      DidYouMeanFile(file));
  }
  return file.string();
}

const YamlNode& YamlReader::Child(std::string_view key) const { return Need(key); }

const YamlNode& YamlReader::List(std::string_view key, std::size_t least, std::size_t most) const {
  const YamlNode& node = Need(key);
  const bool fits = node.kind == YamlNode::Kind::kSequence && node.items.size() >= least &&
                    node.items.size() <= most;
  if (fits) return node;
  const std::string count =
      least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
  std::string found = node.Found();
  if (node.kind == YamlNode::Kind::kSequence) found += " of " + std::to_string(node.items.size());
  throw ConfigError(node.place.Text() + ": " + PathOf(key) + ": expected a list of " + count +
                    ", found " + found);
}

}  // namespace dockyard
