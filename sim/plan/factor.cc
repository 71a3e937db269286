#include "sim/plan/factor.h"

#include <cmath>

#include "models/read/config_error.h"
#include "sim/plan/campaign_keys.h"
#include "sim/scenario/key_path.h"

namespace dockyard {
namespace {

/// {from, to, step}: both ends included.
void AddRange(const YamlNode& node, const std::string& path, Factor& factor) {
  const YamlReader in(node, path, {"from", "to", "step"});
  const double from = in.Number("from", Between(-1e9, 1e9)), to = in.Number("to", {from, 1e9});
  const double step = in.Number("step", Positive(1e9));
  const double steps = std::floor((to - from) / step + 1e-9);
  if (steps >= static_cast<double>(kMostFactorValues)) in.Refuse("step", "at most 1000 values");
  for (double i = 0; i <= steps; ++i) {
    // So that 0.1 + 2 x 0.1 reads 0.3.
    const double value = std::round((from + i * step) * 1e9) / 1e9;
    factor.labels.push_back(NumberText(value));
    factor.values.push_back(ScalarNode(factor.labels.back(), false));
    factor.values.back().place = node.place;
  }
}

}  // namespace

void RequireSettable(const YamlNode::Key& key, const std::string& path) {
  for (const char* of_campaign : {"name", "seed", "system"}) {
    if (key.name != of_campaign) continue;
    throw ConfigError(key.place.Text() + ": " + path +
                      ": expected none; names and seeds follow from the runs' numbers, all runs "
                      "are of one system");
  }
}

Factor ReadFactor(const YamlNode::Key& key, const YamlNode& node, const std::string& path) {
  Factor factor;
  factor.key = key;
  if (node.kind == YamlNode::Kind::kSequence) {
    for (const YamlNode& value : node.items) {
      factor.labels.push_back(CellText(value));
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
  if (factor.values.empty() || factor.values.size() > kMostFactorValues) {
    throw ConfigError(node.place.Text() + ": " + path +
                      ": expected a list of values, {from, to, step}, or labels with values");
  }
  return factor;
}

std::vector<Factor> ReadFactors(const YamlReader& root, const char* name) {
  std::vector<Factor> factors;
  if (!root.Has(name)) return factors;
  const YamlNode& node = root.Child(name);
  if (node.kind != YamlNode::Kind::kMapping || node.keys.empty()) {
    root.Refuse(name, "keys of the scenario, each with its values");
  }
  if (node.keys.size() > kMostFactors) {
    root.Refuse(name, "at most " + std::to_string(kMostFactors) + " keys",
                std::to_string(node.keys.size()));
  }
  for (std::size_t i = 0; i < node.keys.size(); ++i) {
    const std::string path = root.PathOf(name) + "." + node.keys[i].name;
    RequireSettable(node.keys[i], path);
    factors.push_back(ReadFactor(node.keys[i], node.items[i], path));
  }
  return factors;
}

}  // namespace dockyard
