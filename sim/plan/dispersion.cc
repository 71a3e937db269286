#include "sim/plan/dispersion.h"

#include <algorithm>
#include <set>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/yaml_reader.h"
#include "sim/plan/campaign_keys.h"

namespace dockyard {
namespace {

constexpr double kLargest = 1e12;
const Range kAny = Between(-kLargest, kLargest);

Normal ReadNormal(const YamlReader& in) {
  Normal normal{.mean = in.Number("mean", kAny), .std = in.Number("std", Positive(kLargest))};
  if (in.Has("min")) normal.min = in.Number("min", kAny);
  if (in.Has("max")) normal.max = in.Number("max", kAny);
  if (normal.min >= normal.max) in.Refuse("max", "a number above min");
  if (ShareLeft(normal) < kLeastShareLeft) {
    in.Refuse("std", "a spread that leaves something between min and max");
  }
  return normal;
}

/// Bounds of Uniform and LogUniform.
template <class Bounded>
Bounded ReadBounds(const YamlReader& in, const Range& range) {
  Bounded bounded;
  bounded.min = in.Number("min", range);
  bounded.max = in.Number("max", range);
  if (bounded.min >= bounded.max) in.Refuse("max", "a number above min");
  return bounded;
}

void ReadDiscrete(const YamlReader& in, const std::string& path, Dispersion& dispersion) {
  dispersion.values = ReadFactor(dispersion.key, in.Child("values"), path + ".values");
  const std::size_t count = dispersion.values.values.size();
  dispersion.weights.weights.assign(count, 1.0);
  if (!in.Has("weights")) return;
  const YamlNode& list = in.List("weights", count, count);
  double sum = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    double& weight = dispersion.weights.weights[i];
    const bool number =
        list.items[i].kind == YamlNode::Kind::kScalar && ParseNumber(list.items[i].scalar, weight);
    if (!number || !(weight >= 0.0 && weight <= kLargest)) {
      throw ConfigError(list.items[i].place.Text() + ": " + path +
                        ".weights: expected a number >= 0, found " + list.items[i].Found());
    }
    sum += weight;
  }
  if (sum <= 0.0) in.Refuse("weights", "a weight above 0");
}

/// The place of the key among the dispersions. Throws ConfigError.
std::size_t PlaceOf(const YamlNode& key, const std::string& path,
                    const std::vector<Dispersion>& dispersions) {
  for (std::size_t i = 0; i < dispersions.size(); ++i) {
    if (dispersions[i].key.name == key.scalar) return i;
  }
  throw ConfigError(key.place.Text() + ": " + path + ": expected a key of draw, found " +
                    key.Found());
}

}  // namespace

Dispersion ReadDispersion(const YamlNode::Key& key, const YamlNode& node) {
  const std::string path = "draw." + key.name;
  RequireSettable(key, path);
  const YamlReader in(node, path, DistributionWords());
  if (node.keys.size() != 1) {
    throw ConfigError(node.place.Text() + ": " + path +
                      ": expected one distribution, such as {uniform: {min: 1, max: 2}}");
  }
  Dispersion dispersion;
  dispersion.key = key;
  const std::string kind = node.keys[0].name, inner = in.PathOf(kind);
  const YamlNode& of = node.items[0];
  if (kind == "normal") {
    dispersion.distribution = ReadNormal(YamlReader(of, inner, {"mean", "std", "min", "max"}));
  } else if (kind == "uniform") {
    dispersion.distribution = ReadBounds<Uniform>(YamlReader(of, inner, {"min", "max"}), kAny);
  } else if (kind == "loguniform") {
    dispersion.distribution =
        ReadBounds<LogUniform>(YamlReader(of, inner, {"min", "max"}), Positive(kLargest));
  } else {
    ReadDiscrete(YamlReader(of, inner, {"values", "weights"}), inner, dispersion);
  }
  return dispersion;
}

std::vector<Dispersion> ReadDispersions(const YamlReader& root) {
  std::vector<Dispersion> dispersions;
  if (!root.Has("draw")) return dispersions;
  const YamlNode& node = root.Child("draw");
  if (node.kind != YamlNode::Kind::kMapping || node.keys.empty()) {
    root.Refuse("draw", "keys of the scenario, each with its distribution");
  }
  if (node.keys.size() > kMostDraws) {
    root.Refuse("draw", "at most " + std::to_string(kMostDraws) + " keys",
                std::to_string(node.keys.size()));
  }
  for (std::size_t i = 0; i < node.keys.size(); ++i) {
    dispersions.push_back(ReadDispersion(node.keys[i], node.items[i]));
  }
  return dispersions;
}

std::optional<Correlation> ReadCorrelation(const YamlReader& root,
                                           const std::vector<Dispersion>& dispersions) {
  if (!root.Has("correlate")) return std::nullopt;
  std::vector<RankCorrelation> ranks;
  std::set<std::pair<std::size_t, std::size_t>> given;
  const YamlNode& list = root.List("correlate", 1, 1000);
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    const std::string path = YamlReader::PathOf("correlate", i);
    const YamlReader in(list.items[i], path, {"keys", "rank"});
    const YamlNode& keys = in.List("keys", 2, 2);
    const std::size_t a = PlaceOf(keys.items[0], path + ".keys", dispersions),
                      b = PlaceOf(keys.items[1], path + ".keys", dispersions);
    if (a == b) in.Refuse("keys", "two different keys");
    if (!given.insert(std::minmax(a, b)).second) in.Refuse("keys", "each pair once");
    ranks.push_back({a, b, in.Number("rank", Between(-1.0, 1.0))});
  }
  const auto correlation = Correlation::FromRanks(dispersions.size(), ranks);
  if (!correlation) {
    root.Refuse("correlate",
                "correlations that numbers can have together, each between -1 and 1 "
                "(their matrix is not positive definite)");
  }
  return correlation;
}

}  // namespace dockyard
