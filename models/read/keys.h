// The keys of a mapping, stated once. A visitor names every key of a struct with its range, unit
// and meaning. ReadKeys reads such a mapping; sim/scenario/keys.h writes, compares and documents
// it. Models are read this way, scenarios, and what a system has under its own name:
//
//   struct Flag { double x_m = 2.0; std::string colour = "red"; };
//   void VisitFlag(Keys& keys, Flag& flag) {
//     keys.Number({"x_m", "m", "how far away it stands"}, flag.x_m, Positive(10.0));
//     keys.Word({"colour", "", "of the cloth"}, flag.colour, {"red", "blue"});
//   }
//   Flag flag;
//   ReadKeys(scenario.of_system, "toy", [&](Keys& keys) { VisitFlag(keys, flag); });
//
// A visitor may run several times for one reading; it only names keys and has no other effect.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "models/read/yaml_reader.h"

namespace dockyard {

enum class Presence {
  kDefault,   // optional: what the variable holds before the reading is the default
  kRequired,  // must be there
  kUnset,     // optional without a default: the variable then holds a value outside of its range
              // (NaN for a number), an empty text or an empty list, which is never written
};

/// The description of a key, beside its range and its variable. A name alone is of a key that must
/// be there.
struct Key {
  Key(const char* needed) : name(needed), presence(Presence::kRequired) {}
  Key(std::string_view key, std::string_view in_unit, std::string_view says,
      Presence there = Presence::kDefault)
      : name(key), unit(in_unit), meaning(says), presence(there) {}

  std::string_view name;
  std::string_view unit;     // "m", "deg", "px"; empty for none
  std::string_view meaning;  // one line
  Presence presence;
};
inline Key Optional(std::string_view name) { return {name, "", ""}; }
inline Key Unset(std::string_view name) { return {name, "", "", Presence::kUnset}; }

/// The calls for a visitor. Variables have the units of the program, keys those of the file.
class Keys {
 public:
  using Visit = std::function<void(Keys&)>;
  virtual ~Keys() = default;

  virtual void Number(const Key& key, double& value, const Range& range) = 0;
  /// In degrees in the file; the range is in degrees, the variable in radians.
  virtual void Degrees(const Key& key, double& value_rad, const Range& range_deg) = 0;
  virtual void Integer(const Key& key, int& value, int low, int high) = 0;
  /// Any whole number of 64 bits.
  virtual void Seed(const Key& key, std::uint64_t& value) = 0;
  virtual void Bool(const Key& key, bool& value) = 0;
  /// One line of text.
  virtual void Text(const Key& key, std::string& value) = 0;
  virtual void Word(const Key& key, std::string& value, const std::vector<std::string>& words) = 0;
  /// One of the words, or else a mapping: then the variable holds `mapped`.
  virtual void WordOrMapping(const Key& key, std::string& value,
                             const std::vector<std::string>& words, std::string_view mapped,
                             const Visit& inside) = 0;
  /// A list of texts.
  virtual void Texts(const Key& key, std::vector<std::string>& values, std::size_t most) = 0;
  /// A file that exists, relative to the file in which it is named.
  virtual void File(const Key& key, std::string& path) = 0;
  /// A whole mapping or list, kept as it is; kNull: none. kind kNull: of any kind.
  virtual void Tree(const Key& key, YamlNode& tree, YamlNode::Kind kind) = 0;
  virtual void Mapping(const Key& key, const Visit& inside) = 0;
  /// A list of mappings: resize(n) makes room for n, inside(keys, i) visits one.
  virtual void List(const Key& key, std::size_t least, std::size_t most, std::size_t count,
                    const std::function<void(std::size_t)>& resize,
                    const std::function<void(Keys&, std::size_t)>& inside) = 0;
  /// Three numbers, each in the range.
  virtual void Vector3(const Key& key, Eigen::Vector3d& value, const Range& range) = 0;
  /// Whether the values are those of a file, so that what is asked of a key may depend on keys
  /// before it. Otherwise all that any file may have is named.
  virtual bool reads() const { return false; }
  /// Whether the values are to be written, so that what has no effect may be left out.
  virtual bool writes() const { return false; }
  /// A key that a file must have if `needed`.
  Key NeededIf(bool needed, const char* name) const {
    return reads() && needed ? Key(name) : Unset(name);
  }
  /// The limits that follow from other values, or those of any file.
  Range Limits(const Range& now, const Range& widest) const { return reads() ? now : widest; }
  /// What the values read so far must meet. Otherwise the key is refused: `expected`, and in place
  /// of its own value `found`, complete the message. Only reading checks it.
  virtual void Check(std::string_view /*key*/, bool /*holds*/, const std::string& /*expected*/,
                     const std::string& /*found*/ = "") {}
  /// A key that may be there only if `allowed`. `expected` completes the message.
  virtual void Allow(std::string_view /*key*/, bool /*allowed*/, const std::string& /*expected*/) {}
  /// A key that is never allowed here. `hint` completes the message "expected ...".
  virtual void Refused(std::string_view name, std::string_view hint) = 0;
  /// A word that the key no longer takes. `hint` completes the message "expected ...".
  virtual void RefusedWord(std::string_view name, std::string_view word, std::string_view hint) = 0;

  /// Red, green, blue.
  void Rgb(const Key& key, Eigen::Vector3d& value) { Vector3(key, value, Between(0.0, 1.0)); }

  /// A list whose items `visit(keys, item)` visits.
  template <class T, class VisitItem>
  void Items(const Key& key, std::vector<T>& values, std::size_t least, std::size_t most,
             const VisitItem& visit) {
    List(
        key, least, most, values.size(), [&](std::size_t count) { values.assign(count, T()); },
        [&](Keys& in, std::size_t i) { visit(in, values[i]); });
  }

  /// An enumeration whose values 0, 1, ... are called by the words in their order.
  template <class Enum>
  void Choice(const Key& key, Enum& value, const std::vector<std::string>& words) {
    std::string word = words.at(static_cast<std::size_t>(value));
    Word(key, word, words);
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] == word) value = static_cast<Enum>(i);
    }
  }
};

/// Reads the mapping into the visitor's variables. `path` is its own dotted path, empty for the
/// root. A node of kNull counts as a mapping without keys. Unknown keys, missing ones and bad
/// values throw ConfigError with file, line and column.
void ReadKeys(const YamlNode& node, const std::string& path, const Keys::Visit& visit);
/// The same, but required keys may be missing.
void ReadSomeKeys(const YamlNode& node, const std::string& path, const Keys::Visit& visit);

/// Names of the mapping's own keys, refused ones left out.
std::vector<std::string> KeyNames(const Keys::Visit& visit);

}  // namespace dockyard
