#include "sim/plan/spread_words.h"

#include <algorithm>
#include <map>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/load_model_yaml.h"
#include "models/read/load_spreads.h"
#include "models/read/near_names.h"
#include "models/read/yaml_reader.h"
#include "sim/plan/file_keys.h"
#include "sim/scenario/key_path.h"

namespace dockyard {
namespace {

using Kind = YamlNode::Kind;

struct Word {
  YamlNode::Key key;  // the whole dotted key
  YamlNode node;
  bool told = false;  // under `changes`
};

struct FileSpread {
  std::string file;
  NumberSpread spread;
};
/// A model's key ("robot.arm.offset_m") and its spread in each of the campaign's files.
struct ModelSpread {
  std::string key;
  std::vector<FileSpread> in_files;
};

[[noreturn]] void RefuseWord(const Word& word, const std::string& expected) {
  throw ConfigError(word.node.place.Text() + ": draw." + word.key.name + ": expected " + expected +
                    ", found " + word.node.Found());
}

Word ReadWord(const YamlNode::Key& key, const YamlNode& node) {
  const std::string root = key.name.substr(0, key.name.find('.'));
  Word word{key, node, root == "changes"};
  if (node.scalar != "assumed" && node.scalar != "tolerance") {
    RefuseWord(word, "a distribution, or one of the words assumed and tolerance");
  }
  if (root != "changes" && root != "as_built") {
    RefuseWord(word, "a distribution; only keys under changes and as_built have spreads");
  }
  if (word.told && node.scalar != "assumed") {
    RefuseWord(word,
               "assumed; under changes the controller would be told, a tolerance belongs "
               "under as_built");
  }
  if (!word.told && node.scalar != "tolerance") {
    RefuseWord(word, "tolerance; what the robot may be belongs under changes");
  }
  return word;
}

const std::optional<Limits>& SpreadOf(const Word& word, const FileSpread& in) {
  return word.told ? in.spread.assumed : in.spread.tolerance;
}

/// The spreads of all model files that the campaign names, by key in the order of the files.
std::vector<ModelSpread> SpreadsOf(const Campaign& campaign,
                                   const std::vector<KnownSystem>& systems,
                                   std::map<std::string, int>& file_counts) {
  std::vector<ModelSpread> all;
  const YamlNode* name = campaign.base.Find("system");
  const auto system = std::find_if(systems.begin(), systems.end(), [&](const KnownSystem& known) {
    return name != nullptr && known.name == name->scalar;
  });
  if (system == systems.end()) return all;
  const std::vector<NamedFile> files = FilesOf(WithAbsolutePaths(campaign, systems), systems).files;
  for (const ModelRoot& root : system->model_roots) {
    for (const NamedFile& file : files) {
      if (file.key != root.file_key) continue;
      ++file_counts[root.name];
      for (const NumberSpread& spread : ReadSpreads(LoadModelYaml(file.path))) {
        const std::string key = root.name + "." + spread.key.name;
        auto at = std::find_if(all.begin(), all.end(),
                               [&](const ModelSpread& known) { return known.key == key; });
        if (at == all.end()) at = all.insert(all.end(), {key, {}});
        at->in_files.push_back({file.path, spread});
      }
    }
  }
  return all;
}

std::string Text(const std::optional<Limits>& limits) {
  if (!limits) return "none";
  return "[" + NumberText(limits->low) + ", " + NumberText(limits->high) + "]";
}

/// The spread that all files have; none if none has it.
std::optional<Limits> OneSpread(const Word& word, const ModelSpread& model, int files) {
  const std::optional<Limits>& first = SpreadOf(word, model.in_files[0]);
  for (const FileSpread& other : model.in_files) {
    if (SpreadOf(word, other) == first) continue;
    RefuseWord(word, "a distribution, as the files differ in " + model.key + ": " + Text(first) +
                         " in " + model.in_files[0].file + ", " + Text(SpreadOf(word, other)) +
                         " in " + other.file);
  }
  if (first && static_cast<int>(model.in_files.size()) < files) {
    RefuseWord(word, "a distribution, as not all of the files have this spread of " + model.key);
  }
  return first;
}

YamlNode Mapping(const YamlPlace& place, std::vector<std::pair<std::string, YamlNode>> entries) {
  YamlNode node;
  node.kind = Kind::kMapping;
  node.place = place;
  for (auto& [key, value] : entries) {
    node.keys.push_back({key, place});
    node.items.push_back(std::move(value));
  }
  return node;
}

YamlNode DistributionNode(const Limits& limits, const YamlPlace& place) {
  if (limits.of == Limits::Of::kOneOf) {
    YamlNode values;
    values.kind = Kind::kSequence;
    values.place = place;
    for (const double value : limits.values) {
      values.items.push_back(ScalarNode(NumberText(value), false));
      values.items.back().place = place;
    }
    return Mapping(place, {{"discrete", Mapping(place, {{"values", values}})}});
  }
  YamlNode low = ScalarNode(NumberText(limits.low), false);
  YamlNode high = ScalarNode(NumberText(limits.high), false);
  low.place = high.place = place;
  const char* kind = limits.of == Limits::Of::kLogValue ? "loguniform" : "uniform";
  return Mapping(place, {{kind, Mapping(place, {{"min", low}, {"max", high}})}});
}

std::string DrawnKey(const std::string& key, const Limits& limits) {
  if (limits.of == Limits::Of::kTimes) return key + ".times";
  return limits.of == Limits::Of::kPlus ? key + ".plus" : key;
}

/// All dotted keys that the campaign sets by name.
std::vector<std::string> NamedKeys(const Campaign& campaign) {
  std::vector<std::string> keys;
  for (const YamlNode::Key& key : KeysOfRuns(campaign)) keys.push_back(key.name);
  for (const Factor& factor : campaign.one_at_a_time) keys.push_back(factor.key.name);
  for (const Arm& arm : campaign.arms) {
    for (const KeyValue& set : arm.sets) keys.push_back(set.key.name);
  }
  for (const YamlNode::Key& key : campaign.tree.Find("draw")->keys) keys.push_back(key.name);
  return keys;
}

/// Whether something else than the word's own key sets this one.
bool SetElsewhere(const Campaign& campaign, const std::vector<std::string>& named,
                  const std::string& word, const std::string& key) {
  if (FindPath(campaign.base, key) != nullptr) return true;
  return std::any_of(named.begin(), named.end(), [&](const std::string& other) {
    return other.size() > word.size() && PathsOverlap(other, key);
  });
}

class Writer {
 public:
  Writer(const Campaign& campaign, const std::vector<KnownSystem>& systems)
      : campaign_(campaign),
        named_(NamedKeys(campaign)),
        models_(SpreadsOf(campaign, systems, file_counts_)) {}

  void Write(const Word& word, YamlNode& draw) const {
    const std::string root = word.told ? "changes" : "as_built";
    bool found = false;
    std::vector<std::string> known;
    for (const ModelSpread& model : models_) {
      const std::string key = root + "." + model.key;
      const std::string& head = word.key.name;
      const bool any = std::any_of(model.in_files.begin(), model.in_files.end(),
                                   [&](const FileSpread& in) { return SpreadOf(word, in); });
      if (!any) continue;
      known.push_back(key);
      if (key.size() < head.size() || !PathsOverlap(head, key)) continue;
      found = true;
      if (key != head && SetElsewhere(campaign_, named_, head, key)) continue;
      const auto limits =
          OneSpread(word, model, file_counts_.at(model.key.substr(0, model.key.find('.'))));
      draw.keys.push_back({DrawnKey(key, *limits), word.key.place});
      draw.items.push_back(DistributionNode(*limits, word.node.place));
    }
    if (found) return;
    const std::string nearest = NearestName(word.key.name, known);
    RefuseWord(word, "a key with this spread in its model's file" +
                         (nearest.empty() ? "" : ", such as '" + nearest + "'"));
  }

 private:
  const Campaign& campaign_;
  std::vector<std::string> named_;
  std::map<std::string, int> file_counts_;  // by root
  std::vector<ModelSpread> models_;
};

}  // namespace

void WriteSpreads(Campaign& campaign, const std::vector<KnownSystem>& systems) {
  YamlNode* draw = FindPath(campaign.tree, "draw");
  if (draw == nullptr || draw->kind != Kind::kMapping) return;
  std::vector<Word> words;
  for (std::size_t i = 0; i < draw->keys.size(); ++i) {
    if (draw->items[i].kind == Kind::kScalar) {
      words.push_back(ReadWord(draw->keys[i], draw->items[i]));
    } else {  // may choose among model files
      campaign.dispersions.push_back(ReadDispersion(draw->keys[i], draw->items[i]));
    }
  }
  if (words.empty()) return;
  const Writer writer(campaign, systems);
  YamlNode written = Mapping(draw->place, {});
  std::size_t next = 0;
  for (std::size_t i = 0; i < draw->keys.size(); ++i) {
    if (draw->items[i].kind == Kind::kScalar) {
      writer.Write(words[next++], written);
    } else {
      written.keys.push_back(draw->keys[i]);
      written.items.push_back(draw->items[i]);
    }
  }
  // A table of all draws, such as a plan, leaves nothing to them.
  if (written.keys.empty()) {
    RemovePath(campaign.tree, "draw");
  } else {
    *draw = std::move(written);
  }
}

}  // namespace dockyard
