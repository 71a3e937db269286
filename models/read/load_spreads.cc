#include "models/read/load_spreads.h"

#include <string>

#include "models/read/config_error.h"
#include "models/read/yaml_path.h"
#include "models/read/yaml_reader.h"

namespace dockyard {
namespace {

/// [low, high]
Limits ReadLimits(const YamlNode& list, const std::string& path, Limits::Of of) {
  Limits limits{of, 0.0, 0.0};
  const bool two = list.kind == YamlNode::Kind::kSequence && list.items.size() == 2;
  if (!two || !ParseNumber(list.items[0].scalar, limits.low) ||
      !ParseNumber(list.items[1].scalar, limits.high) || !(limits.low < limits.high) ||
      (of == Limits::Of::kLogValue && !(limits.low > 0.0))) {
    throw ConfigError(list.place.Text() + ": " + path +
                      ": expected two numbers in ascending order" +
                      (of == Limits::Of::kLogValue ? " above 0" : "") + ", found " + list.Found());
  }
  return limits;
}

void RequireOne(const YamlNode& node, const std::string& path, const std::string& expected) {
  if (node.keys.size() == 1) return;
  throw ConfigError(node.place.Text() + ": " + path + ": expected " + expected + ", found " +
                    node.Found());
}

/// {one_of: [a, b, ...]}, as for whole numbers.
Limits ReadOneOf(const YamlReader& in) {
  Limits limits{Limits::Of::kOneOf};
  for (const YamlNode& item : in.List("one_of", 2, 100).items) {
    limits.values.push_back(0.0);
    if (!ParseNumber(item.scalar, limits.values.back())) in.Refuse("one_of", "a list of numbers");
  }
  return limits;
}

/// [low, high], {log: [low, high]} or {one_of: [a, b, ...]}
Limits ReadAssumed(const YamlNode& node, const std::string& path) {
  if (node.kind != YamlNode::Kind::kMapping) return ReadLimits(node, path, Limits::Of::kValue);
  const YamlReader in(node, path, {"log", "one_of"});
  RequireOne(node, path, "one of log and one_of, or [low, high]");
  if (in.Has("one_of")) return ReadOneOf(in);
  return ReadLimits(in.Child("log"), in.PathOf("log"), Limits::Of::kLogValue);
}

/// {percent: p}, {within: d} or {plus: [low, high]}
Limits ReadTolerance(const YamlNode& node, const std::string& path) {
  const YamlReader in(node, path, {"percent", "within", "plus"});
  RequireOne(node, path, "one of percent, within and plus");
  if (in.Has("plus")) return ReadLimits(in.Child("plus"), in.PathOf("plus"), Limits::Of::kPlus);
  if (in.Has("within")) {
    const double within = in.Number("within", Positive(1e12));
    return {Limits::Of::kPlus, -within, within};
  }
  const double share = 0.01 * in.Number("percent", Between(1e-6, 99.0));
  return {Limits::Of::kTimes, 1.0 - share, 1.0 + share};
}

}  // namespace

std::vector<NumberSpread> ReadSpreads(const YamlNode& root) {
  std::vector<NumberSpread> spreads;
  const YamlNode* all = root.Find("spreads");
  if (all == nullptr) return spreads;
  if (all->kind != YamlNode::Kind::kMapping) {
    throw ConfigError(all->place.Text() + ": spreads: expected keys of this file, each with its " +
                      "spreads, found " + all->Found());
  }
  for (std::size_t i = 0; i < all->keys.size(); ++i) {
    if (all->items[i].kind == YamlNode::Kind::kNull) continue;  // takes that of a base away
    NumberSpread spread;
    spread.key = all->keys[i];
    const std::string path = "spreads." + spread.key.name;
    const YamlReader in(all->items[i], path, {"assumed", "tolerance"});
    if (all->items[i].keys.empty()) {
      throw ConfigError(all->items[i].place.Text() + ": " + path +
                        ": expected assumed, tolerance or both, found neither");
    }
    if (in.Has("assumed")) spread.assumed = ReadAssumed(in.Child("assumed"), in.PathOf("assumed"));
    if (in.Has("tolerance")) {
      spread.tolerance = ReadTolerance(in.Child("tolerance"), in.PathOf("tolerance"));
    }
    spreads.push_back(spread);
  }
  return spreads;
}

void NameSpreads(Keys& keys) {
  YamlNode spreads;
  keys.Tree(Unset("spreads"), spreads, YamlNode::Kind::kNull);
}

void CheckSpreads(const YamlNode& model) {
  for (const NumberSpread& spread : ReadSpreads(model)) {
    const YamlNode* number = FindPath(model, spread.key.name);
    double value = 0.0;
    if (number != nullptr && number->kind == YamlNode::Kind::kScalar &&
        ParseNumber(number->scalar, value)) {
      continue;
    }
    throw ConfigError(spread.key.place.Text() + ": spreads." + spread.key.name +
                      ": expected the dotted key of a number of this file, found " +
                      (number == nullptr ? "no such key" : number->Found()));
  }
}

}  // namespace dockyard
