// A campaign's dispersed keys as its file has them.
#pragma once

#include <optional>
#include <vector>

#include "sim/draws/copula.h"
#include "sim/draws/distribution.h"
#include "sim/plan/factor.h"

namespace dockyard {

/// A key whose value is drawn anew for each run.
struct Dispersion {
  YamlNode::Key key;
  Distribution distribution;  // of a number
  Discrete weights;           // of the values, if there are any
  Factor values;              // what is chosen from; without values: a number

  bool discrete() const { return !values.values.empty(); }
};

/// Reads a key of the mapping `draw` with one of
///   {normal: {mean, std, min, max}}   min and max may be left out
///   {uniform: {min, max}}
///   {loguniform: {min, max}}
///   {discrete: {values: ..., weights: [...]}}   values as of a factor; equal weights if left out
/// Throws ConfigError.
Dispersion ReadDispersion(const YamlNode::Key& key, const YamlNode& node);

/// Reads the whole mapping `draw`. None if it is not there. Throws ConfigError.
std::vector<Dispersion> ReadDispersions(const YamlReader& root);

/// Reads the list `correlate`: {keys: [a, b], rank: r} for pairs of dispersed keys. None if it is
/// not there. Throws ConfigError, also for correlations that no numbers can have together.
std::optional<Correlation> ReadCorrelation(const YamlReader& root,
                                           const std::vector<Dispersion>& dispersions);

}  // namespace dockyard
