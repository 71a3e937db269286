#include "models/read/load_model_yaml.h"

#include "models/read/config_error.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

constexpr int kMostBases = 5;

/// The file that the key `base` names, as the reader of keys resolves it.
std::string BaseOf(const YamlNode& tree) {
  YamlNode only;
  only.kind = YamlNode::Kind::kMapping;
  only.place = tree.place;
  only.keys.push_back({"base", tree.Find("base")->place});
  only.items.push_back(*tree.Find("base"));
  return YamlReader(only, "", {"base"}).File("base");
}

YamlNode Load(const std::string& file, int bases) {
  YamlNode tree = LoadYaml(file);
  const YamlNode* base = tree.Find("base");
  if (base == nullptr) return tree;
  if (bases == kMostBases) {
    throw ConfigError(base->place.Text() + ": base: expected at most " +
                      std::to_string(kMostBases) + " files on top of each other, found more");
  }
  YamlNode whole = Load(BaseOf(tree), bases + 1);
  const auto at = base - tree.items.data();
  tree.keys.erase(tree.keys.begin() + at);
  tree.items.erase(tree.items.begin() + at);
  MergeYaml(whole, tree);
  whole.place = tree.place;
  return whole;
}

}  // namespace

YamlNode LoadModelYaml(const std::string& file) { return Load(file, 0); }

}  // namespace dockyard
