#include <cmath>

#include "models/config_error.h"
#include "models/load_scenario.h"
#include "models/scenario_reader.h"
#include "models/study.h"

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
    factors.push_back(ReadFactor(name, node.items[i], root.PathOf(key) + "." + name));
  }
  return factors;
}

std::vector<ScriptStep> ReadScript(const YamlNode& list, const std::string& path) {
  if (list.kind != YamlNode::Kind::kSequence || list.items.empty()) {
    throw ConfigError(list.place.Text() + ": " + path + ": expected a list of steps, found " +
                      list.Found());
  }
  std::vector<ScriptStep> script;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const YamlReader in(
        list.items[i], YamlReader::PathOf(path, i),
        {"for_s", "speed_m_s", "turn_deg_s", "free_wheels", "reel_m_s", "tension_n"});
    ScriptStep step;
    step.for_s = in.Number("for_s", Positive(1e4));
    step.speed_m_s = in.NumberOr("speed_m_s", 0.0, Between(-10.0, 10.0));
    step.turn_rad_s = in.DegreesOr("turn_deg_s", 0.0, Between(-360.0, 360.0));
    step.free_wheels = in.BoolOr("free_wheels", false);
    step.reel_m_s = in.NumberOr("reel_m_s", 0.0, Between(-10.0, 10.0));
    if (in.Has("tension_n")) step.tension_n = in.Number("tension_n", NonNegative(1e5));
    script.push_back(step);
  }
  return script;
}

/// Puts the value under the dotted key on top of the tree.
void Put(YamlNode& tree, const std::string& key, const YamlNode& value) {
  YamlNode node = value;
  std::size_t end = key.size();
  while (true) {
    const std::size_t dot = end == 0 ? std::string::npos : key.rfind('.', end - 1);
    const std::size_t begin = dot == std::string::npos ? 0 : dot + 1;
    YamlNode mapping;
    mapping.kind = YamlNode::Kind::kMapping;
    mapping.place = value.place;
    mapping.keys.push_back({key.substr(begin, end - begin), value.place});
    mapping.items.push_back(std::move(node));
    node = std::move(mapping);
    if (dot == std::string::npos) break;
    end = dot;
  }
  MergeYaml(tree, node);
}

/// Sets a factor to one of its values at a point.
void Set(const StudyFactor& factor, int level, YamlNode& tree, StudyPoint& point) {
  const YamlNode& value = factor.values[static_cast<std::size_t>(level)];
  if (factor.key == "script") {
    point.script = ReadScript(value, factor.key);
  } else {
    Put(tree, factor.key, value);
  }
}

void AddPoints(const YamlNode& base, const std::vector<ScriptStep>& script, Study& study) {
  const int changes = static_cast<int>(study.one_at_a_time.size());
  for (int change = -1; change < changes; ++change) {
    const std::size_t levels =
        change < 0 ? 1 : study.one_at_a_time[static_cast<std::size_t>(change)].values.size();
    for (std::size_t level = 0; level < levels; ++level) {
      for (int i = 0; i < study.grid_size(); ++i) {
        StudyPoint point;
        point.script = script;
        YamlNode tree = base;
        int rest = i;
        for (const StudyFactor& factor : study.factors) {
          const int count = static_cast<int>(factor.values.size());
          point.level.push_back(rest % count);
          Set(factor, rest % count, tree, point);
          rest /= count;
        }
        if (change >= 0) {
          const StudyFactor& factor = study.one_at_a_time[static_cast<std::size_t>(change)];
          point.changed = change;
          point.changed_level = static_cast<int>(level);
          Set(factor, point.changed_level, tree, point);
        }
        point.scenario = ReadScenario(tree, "", ScenarioPart::kWhole);
        // Where the models are changed, one place of the grid tells whether they are sound.
        if (i == 0) LoadModels(point.scenario);
        study.points.push_back(std::move(point));
      }
    }
  }
}

void ReadPlot(const YamlReader& root, Study& study) {
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
    for (const std::string& measure : StudyMeasures()) known = known || measure == item.scalar;
    if (!known) {
      const std::string near = NearestName(item.scalar, StudyMeasures());
      throw ConfigError(item.place.Text() +
                        ": plot.measures: expected a column of runs.csv, found " + item.Found() +
                        (near.empty() ? "" : "; nearest is '" + near + "'"));
    }
    study.measures.push_back(item.scalar);
  }
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

const std::vector<std::string>& StudyMeasures() {
  static const std::vector<std::string> names{"docked",
                                              "sim_time_s",
                                              "tip_depth_m",
                                              "lateral_error_m",
                                              "yaw_error_deg",
                                              "station_shift_m",
                                              "cone_force_peak_n",
                                              "tension_peak_n",
                                              "spool_current_mean_a",
                                              "spool_current_peak_a",
                                              "arm_up_peak_deg",
                                              "roll_rms_deg",
                                              "entry_current_mean_a",
                                              "entry_current_peak_a",
                                              "entry_force_peak_n",
                                              "advance_m",
                                              "turned_deg"};
  return names;
}

Study LoadStudy(const std::string& file, const std::vector<std::string>& overrides) {
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
  std::vector<ScriptStep> script;
  if (in.Has("script")) script = ReadScript(in.Child("script"), "script");
  ReadPlot(in, study);
  std::size_t points = 1;
  for (const StudyFactor& factor : study.factors) {
    points *= factor.values.size();
    if (points > kMaxPoints) in.Refuse("vary", "at most 20000 points");
  }
  YamlNode base = LoadYaml(in.File("base"));
  if (in.Has("scenario")) {
    if (in.Child("scenario").Find("seed") != nullptr) {
      in.Refuse("scenario", "no seed in it; seeds follow from the study's seed and repeats");
    }
    MergeYaml(base, in.Child("scenario"));
  }
  AddPoints(base, script, study);
  return study;
}

}  // namespace dockyard
