// Walks all numbers of a model's file, so that a loader's tests need no list of keys of their own.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "controller/base/number_text.h"
#include "models/read/as_built.h"
#include "models/read/config_error.h"
#include "models/read/yaml_path.h"
#include "support/bad_files.h"

namespace dockyard {

using LoadChanged = std::function<void(const ModelChanges&)>;
/// Values of a loaded model by dotted path, in the units of its file.
using FileValues = std::map<std::string, double>;
inline const std::string kNoError = "no error";

/// The numbers of a tree. Spreads are none of the model itself.
inline void CollectNumbers(const YamlNode& node, const std::string& path, FileValues& numbers) {
  if (path == "spreads") return;
  const auto number = NumberFromText(node.scalar);
  if (node.kind == YamlNode::Kind::kScalar && !node.quoted && number) numbers[path] = *number;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    const bool listed = node.kind == YamlNode::Kind::kSequence;
    const std::string dot = path.empty() ? "" : ".";
    CollectNumbers(node.items[i],
                   path + (listed ? "[" + std::to_string(i) + "]" : dot + node.keys[i].name),
                   numbers);
  }
}
inline FileValues NumbersOf(const YamlNode& tree) {
  FileValues numbers;
  CollectNumbers(tree, "", numbers);
  return numbers;
}

/// Each number of the file is in the model, and no other value is.
inline void ExpectReadAsWritten(const YamlNode& tree, const FileValues& read) {
  const FileValues written = NumbersOf(tree);
  for (const auto& [path, value] : written) {
    const auto found = read.find(path);
    if (found == read.end()) {
      ADD_FAILURE() << path << " is not compared";
    } else {
      EXPECT_NEAR(found->second, value, 1e-12 * std::max(1.0, std::abs(value))) << path;
    }
  }
  for (const auto& [path, value] : read) EXPECT_TRUE(written.contains(path)) << path;
}

/// "{a: {b: " and "}}" for "a.b".
inline std::pair<std::string, std::string> AroundValue(std::string path) {
  std::string open = "{", close = "}";
  for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.')) {
    open += path.substr(0, dot) + ": {";
    close += "}";
    path.erase(0, dot + 1);
  }
  return {open + path + ": ", close};
}

inline void LoadWith(const std::string& text, const LoadChanged& load) {
  const YamlNode keys = ParseYaml(text, "changed.yaml");
  load({&keys, nullptr});
}

inline std::string ErrorWith(const std::string& text, const LoadChanged& load) {
  try {
    LoadWith(text, load);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return kNoError;
}

/// A number of a mapping that is a word, a list, none, or beyond all bounds is refused at its
/// place, with its path.
inline void ExpectBadNumbersRefused(const YamlNode& tree, const LoadChanged& load) {
  for (const auto& [path, value] : NumbersOf(tree)) {
    if (path.find('[') != std::string::npos) continue;
    const auto [open, close] = AroundValue(path);
    const std::string place = "changed.yaml:1:" + std::to_string(open.size() + 1) + ": " + path;
    for (const char* bad : {"soon", "[1, 2]", "-1e15", "1e15"}) {
      const std::string error = ErrorWith(open + bad + close, load);
      EXPECT_THAT(error, testing::StartsWith(place + ": expected")) << bad;
      EXPECT_THAT(error, testing::HasSubstr("found")) << path;
    }
  }
}

/// A key that a mapping does not have is refused at its place.
inline void ExpectUnknownKeysRefused(const YamlNode& tree, const LoadChanged& load) {
  std::set<std::string> mappings{""};
  for (const auto& [path, value] : NumbersOf(tree)) {
    const std::size_t dot = path.rfind('.');
    if (dot != std::string::npos && path.find('[') == std::string::npos) {
      mappings.insert(path.substr(0, dot) + ".");
    }
  }
  for (const std::string& mapping : mappings) {
    const auto [open, close] = AroundValue(mapping + "no_such_key");
    const std::size_t column = open.rfind("no_such_key") + 1;
    EXPECT_THAT(ErrorWith(open + "1" + close, load),
                testing::StartsWith("changed.yaml:1:" + std::to_string(column) + ": "))
        << mapping;
  }
}

/// Without one of its numbers the file is refused, and the key named.
/// @param instead  other texts of the error, by path; kNoError: the number may be left out
/// @param write    puts the text in the file's place and loads it
inline void ExpectNumbersNeeded(const YamlNode& tree,
                                const std::map<std::string, std::string>& instead,
                                const std::function<void(const std::string&)>& write) {
  for (const auto& [path, value] : NumbersOf(tree)) {
    if (path.find('[') != std::string::npos) continue;
    YamlNode less = tree;
    const std::size_t dot = path.rfind('.');
    const std::string key = dot == std::string::npos ? path : path.substr(dot + 1);
    YamlNode& parent = dot == std::string::npos ? less : *FindPath(less, path.substr(0, dot));
    const auto at = parent.Find(key) - parent.items.data();
    parent.keys.erase(parent.keys.begin() + at);
    parent.items.erase(parent.items.begin() + at);
    std::string error = kNoError;
    try {
      write(FlowText(less));
    } catch (const ConfigError& caught) {
      error = caught.what();
    }
    const auto other = instead.find(path);
    EXPECT_THAT(error, testing::HasSubstr(other == instead.end() ? key : other->second)) << path;
    if (error == kNoError) continue;
    EXPECT_THAT(error, testing::HasSubstr(".yaml:1:")) << path;
  }
}

}  // namespace dockyard
