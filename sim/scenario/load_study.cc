#include <cmath>
#include <set>

#include "models/read/config_error.h"
#include "models/read/yaml_reader.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/scenario_keys.h"
#include "sim/scenario/study.h"

namespace dockyard {
namespace {

constexpr std::size_t kMaxValues = 1000;
constexpr std::size_t kMaxPoints = 20000;

YamlNode Scalar(const YamlNode& at, const std::string& text) {
  YamlNode node;
  node.kind = YamlNode::Kind::kScalar;
  node.place = at.place;
  node.scalar = text;
  return node;
}

/// {from, to, step}: both ends included.
void AddRange(const YamlNode& node, const std::string& path, StudyFactor& factor) {
  const YamlReader in(node, path, {"from", "to", "step"});
  const double from = in.Number("from", Between(-1e9, 1e9)), to = in.Number("to", {from, 1e9});
  const double step = in.Number("step", Positive(1e9));
  const double steps = std::floor((to - from) / step + 1e-9);
  if (steps >= static_cast<double>(kMaxValues)) in.Refuse("step", "at most 1000 values");
  for (double i = 0; i <= steps; ++i) {
    // So that 0.1 + 2 x 0.1 reads 0.3.
    const double value = std::round((from + i * step) * 1e9) / 1e9;
    factor.labels.push_back(NumberText(value));
    factor.values.push_back(Scalar(node, factor.labels.back()));
  }
}

/// A list of values, a range, or a mapping of labels to values.
StudyFactor ReadFactor(const std::string& key, const YamlNode& node, const std::string& path) {
  StudyFactor factor;
  factor.key = key;
  if (node.kind == YamlNode::Kind::kSequence) {
    for (const YamlNode& value : node.items) {
      factor.labels.push_back(value.kind == YamlNode::Kind::kScalar ? value.scalar
                                                                    : FlowText(value));
      factor.values.push_back(value);
    }
  } else if (node.kind == YamlNode::Kind::kMapping && node.Find("from") != nullptr) {
    AddRange(node, path, factor);
  } else if (node.kind == YamlNode::Kind::kMapping) {
    for (std::size_t i = 0; i < node.keys.size(); ++i) {
      factor.labels.push_back(node.keys[i].name);
      factor.values.push_back(node.items[i]);
    }
  }
  if (factor.values.empty() || factor.values.size() > kMaxValues) {
    throw ConfigError(node.place.Text() + ": " + path +
                      ": expected a list of values, {from, to, step}, or labels with values");
  }
  return factor;
}

std::vector<StudyFactor> ReadFactors(const YamlReader& root, const char* key) {
  std::vector<StudyFactor> factors;
  if (!root.Has(key)) return factors;
  const YamlNode& node = root.Child(key);
  if (node.kind != YamlNode::Kind::kMapping || node.keys.empty()) {
    root.Refuse(key, "keys of the scenario, each with its values");
  }
  for (std::size_t i = 0; i < node.keys.size(); ++i) {
    const std::string& name = node.keys[i].name;
    if (name == "seed") {
      throw ConfigError(node.keys[i].place.Text() + ": " + root.PathOf(key) +
                        ".seed: expected none; seeds follow from the study's seed and repeats");
    }
    if (name == "system") {
      throw ConfigError(node.keys[i].place.Text() + ": " + root.PathOf(key) +
                        ".system: expected none; all points are of one system");
    }
    factors.push_back(ReadFactor(name, node.items[i], root.PathOf(key) + "." + name));
  }
  return factors;
}

/// Sets a factor to one of its values.
void Set(const StudyFactor& factor, int level, YamlNode& tree) {
  const YamlNode& value = factor.values[static_cast<std::size_t>(level)];
  PutPath(tree, factor.key, value.place, value);
}

/// Checks a scenario unless its system saw an equal one before.
class SystemCheck {
 public:
  explicit SystemCheck(const StudySystems& systems) : systems_(systems) {}
  void operator()(const Scenario& scenario) {
    if (systems_.check && checked_.insert(ModelText(scenario)).second) systems_.check(scenario);
  }

 private:
  const StudySystems& systems_;
  std::set<std::string> checked_;
};

/// Every place of the grid, with at most one key changed.
void AddPoints(const YamlNode& base, const StudySystems& systems, SystemCheck& check, int changed,
               int changed_level, Study& study) {
  for (int i = 0; i < study.grid_size(); ++i) {
    StudyPoint point;
    YamlNode tree = base;
    int rest = i;
    for (const StudyFactor& factor : study.factors) {
      const int count = static_cast<int>(factor.values.size());
      point.level.push_back(rest % count);
      Set(factor, rest % count, tree);
      rest /= count;
    }
    point.changed = changed;
    point.changed_level = changed_level;
    if (changed >= 0) {
      Set(study.one_at_a_time[static_cast<std::size_t>(changed)], changed_level, tree);
    }
    point.scenario = ReadScenario(tree, systems.known);
    check(point.scenario);
    study.points.push_back(std::move(point));
  }
}

void AddAllPoints(const YamlNode& base, const StudySystems& systems, Study& study) {
  SystemCheck check(systems);
  AddPoints(base, systems, check, -1, -1, study);
  for (std::size_t change = 0; change < study.one_at_a_time.size(); ++change) {
    const int levels = static_cast<int>(study.one_at_a_time[change].values.size());
    for (int level = 0; level < levels; ++level) {
      AddPoints(base, systems, check, static_cast<int>(change), level, study);
    }
  }
}

void ReadPlot(const YamlReader& root, const std::vector<std::string>& measures, Study& study) {
  std::vector<std::string> keys;
  for (const StudyFactor& factor : study.factors) keys.push_back(factor.key);
  study.measures = {"docked"};
  if (!root.Has("plot")) return;
  const YamlReader in(root.Child("plot"), "plot", {"x", "curves", "panels", "measures"});
  const auto factor = [&](const char* key) {
    return in.Has(key) ? keys[static_cast<std::size_t>(in.Choice(key, keys))] : std::string();
  };
  study.x = factor("x");
  study.curves = factor("curves");
  study.panels = factor("panels");
  if (!in.Has("measures")) return;
  study.measures.clear();
  const YamlNode& list = in.List("measures", 1, 8);
  for (const YamlNode& item : list.items) {
    bool known = false;
    for (const std::string& measure : measures) known = known || measure == item.scalar;
    if (!known) {
      const std::string near = NearestName(item.scalar, measures);
      throw ConfigError(item.place.Text() +
                        ": plot.measures: expected a column of runs.csv, found " + item.Found() +
                        (near.empty() ? "" : "; nearest is '" + near + "'"));
    }
    study.measures.push_back(item.scalar);
  }
}

/// The base: a scenario file, with the study's keys of a scenario on top.
YamlNode BaseTree(const YamlReader& root) {
  YamlNode base = LoadYaml(root.File("base"));
  if (root.Has("scenario")) {
    if (root.Child("scenario").Find("seed") != nullptr) {
      root.Refuse("scenario", "no seed in it; seeds follow from the study's seed and repeats");
    }
    MergeYaml(base, root.Child("scenario"));
  }
  if (root.Has("script")) {
    PutPath(base, "script", root.Child("script").place, root.Child("script"));
  }
  return base;
}

}  // namespace

bool StudyFactor::numeric() const {
  for (const std::string& label : labels) {
    double value = 0.0;
    if (!ParseNumber(label, value)) return false;
  }
  return true;
}

int Study::grid_size() const {
  std::size_t size = 1;
  for (const StudyFactor& factor : factors) size *= factor.values.size();
  return static_cast<int>(size);
}

Study LoadStudy(const std::string& file, const std::vector<std::string>& overrides,
                const StudySystems& systems) {
  YamlNode tree = LoadYaml(file);
  for (const std::string& assignment : overrides) SetYaml(tree, assignment);
  const YamlReader in(
      tree, "",
      {"study", "base", "scenario", "seed", "repeats", "vary", "one_at_a_time", "script", "plot"});
  Study study;
  study.name = in.Text("study");
  study.seed = in.SeedOr("seed", 1);
  study.repeats = in.Integer("repeats", 1, 10000);
  study.factors = ReadFactors(in, "vary");
  study.one_at_a_time = ReadFactors(in, "one_at_a_time");
  std::size_t points = 1;
  for (const StudyFactor& factor : study.factors) {
    points *= factor.values.size();
    if (points > kMaxPoints) in.Refuse("vary", "at most 20000 points");
  }
  AddAllPoints(BaseTree(in), systems, study);
  const std::string& system = study.points.front().scenario.system;
  ReadPlot(in, systems.measures ? systems.measures(system) : std::vector<std::string>(), study);
  return study;
}

}  // namespace dockyard
