#include "sim/report/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>

#include "sim/base/text.h"
#include "sim/report/points.h"
#include "sim/report/rate_text.h"
#include "sim/statistics/levels.h"
#include "sim/statistics/multiple.h"
#include "sim/statistics/ranks.h"

namespace dockyard {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr Estimate kUnknown{kNaN, {kNaN, kNaN}};
constexpr int kMostLevels = 10, kRunsPerLevel = 20;

using Values = std::vector<double>;

/// A draw of the campaign, and where its labels stand in a row.
struct Draw {
  std::string label;
  std::vector<std::string> texts;  // of a discrete one, in the order of the file
  bool words = false;              // not all texts are numbers
  std::size_t place = 0;
};

std::vector<Draw> DrawsOf(const Campaign& campaign, const RowColumns& columns) {
  std::vector<Draw> draws;
  for (const Dispersion& dispersion : campaign.dispersions) {
    Draw draw{dispersion.key.name, dispersion.values.labels};
    draw.words = std::any_of(draw.texts.begin(), draw.texts.end(), [](const std::string& text) {
      return !NumberFromText(text).has_value();
    });
    const auto at = std::find(columns.labels.begin(), columns.labels.end(), draw.label);
    draw.place = static_cast<std::size_t>(at - columns.labels.begin());
    draws.push_back(std::move(draw));
  }
  return draws;
}

/// What was drawn; of words the place among their texts.
Values ValuesOf(const Draw& draw, const Rows& rows) {
  Values values;
  values.reserve(rows.size());
  for (const RunResult* row : rows) {
    const std::string& text = row->labels.at(draw.place);
    const auto at = std::find(draw.texts.begin(), draw.texts.end(), text);
    values.push_back(draw.words ? static_cast<double>(at - draw.texts.begin())
                                : NumberFromText(text).value_or(kNaN));
  }
  return values;
}

/// @param ranks  of the values
std::vector<int> LevelsOf(const Draw& draw, const Values& values, const Values& ranks) {
  if (draw.words) return std::vector<int>(values.begin(), values.end());
  const int count = std::clamp(static_cast<int>(values.size()) / kRunsPerLevel, 2, kMostLevels);
  return LevelsOfRanks(ranks, count);
}

/// Inputs of the regression: numbers as they are, of words all texts but one as 0 or 1.
void AddInputs(const Draw& draw, const Values& values, const Values& ranks, RankTable& table) {
  if (!draw.words) return table.AddInput(ranks);
  for (std::size_t text = 1; text < draw.texts.size(); ++text) {
    Values is_text;
    is_text.reserve(values.size());
    for (const double value : values) is_text.push_back(value == double(text) ? 1.0 : 0.0);
    table.AddInput(Ranks(is_text));
  }
}

std::size_t InputCount(const std::vector<Draw>& draws) {
  std::size_t count = 0;
  for (const Draw& draw : draws) count += draw.words ? draw.texts.size() - 1 : 1;
  return count;
}

/// Measures that the same rows have, by their places among the summed columns.
struct Group {
  std::vector<std::size_t> measures;
  std::vector<char> has;  // by row
};

std::vector<Group> GroupsOf(std::size_t measures, const Rows& rows) {
  std::vector<Group> groups;
  for (std::size_t measure = 0; measure < measures; ++measure) {
    std::vector<char> has;
    has.reserve(rows.size());
    for (const RunResult* row : rows) has.push_back(!std::isnan(SummedValue(*row, measure)));
    const auto known = std::find_if(groups.begin(), groups.end(),
                                    [&](const Group& group) { return group.has == has; });
    if (known == groups.end()) {
      groups.push_back({{measure}, std::move(has)});
    } else {
      known->measures.push_back(measure);
    }
  }
  return groups;
}

void AdjustChances(std::vector<DrawEffect>& draws) {
  Values p;
  for (const DrawEffect& draw : draws) p.push_back(draw.p_value);
  const Values adjusted = HolmAdjusted(p);
  for (std::size_t i = 0; i < draws.size(); ++i) draws[i].holm_p = adjusted[i];
}

void SortByEta(std::vector<DrawEffect>& draws) {
  const auto size = [](const DrawEffect& draw) { return std::isnan(draw.eta) ? -1.0 : draw.eta; };
  std::stable_sort(draws.begin(), draws.end(),
                   [&](const DrawEffect& a, const DrawEffect& b) { return size(a) > size(b); });
}

/// Fills the effects on a group's measures, which all rows here have.
void FindEffects(const std::vector<Draw>& draws, const Group& group, const Rows& rows,
                 std::vector<MeasureEffects>& found) {
  RankTable table(rows.size(), InputCount(draws) + group.measures.size());
  std::vector<Values> measure_ranks;
  for (const std::size_t measure : group.measures) {
    Values values;
    values.reserve(rows.size());
    for (const RunResult* row : rows) values.push_back(SummedValue(*row, measure));
    measure_ranks.push_back(Ranks(values));
    table.AddOutput(measure_ranks.back());
  }
  for (const Draw& draw : draws) {
    const Values values = ValuesOf(draw, rows), ranks = Ranks(values);
    AddInputs(draw, values, ranks, table);
    const std::vector<int> levels = LevelsOf(draw, values, ranks);
    for (std::size_t m = 0; m < group.measures.size(); ++m) {
      const LevelEffect effect = EffectOfLevels(levels, measure_ranks[m]);
      found[group.measures[m]].draws.push_back({draw.label, draw.words,
                                                std::sqrt(effect.epsilon_squared), effect.p_value,
                                                kNaN, kUnknown, kUnknown});
    }
  }
  const RankCorrelations correlations = table.Correlate();
  for (std::size_t m = 0; m < group.measures.size(); ++m) {
    MeasureEffects& effects = found[group.measures[m]];
    for (std::size_t d = 0, input = 0; d < draws.size(); ++d) {
      if (draws[d].words) {
        input += draws[d].texts.size() - 1;
        continue;
      }
      effects.draws[d].rank_correlation = correlations.spearman[m][input];
      effects.draws[d].partial = correlations.partial[m][input++];
    }
    AdjustChances(effects.draws);
    SortByEta(effects.draws);
  }
}

void AddRates(const Draw& draw, const Rows& rows, std::vector<LevelRate>& rates) {
  const Values values = ValuesOf(draw, rows);
  const std::vector<int> levels = LevelsOf(draw, values, Ranks(values));
  struct Level {
    int successes = 0, runs = 0;
    double low = std::numeric_limits<double>::infinity(), high = -low;
  };
  std::map<int, Level> by_level;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    Level& level = by_level[levels[i]];
    level.successes += rows[i]->success;
    ++level.runs;
    level.low = std::min(level.low, values[i]);
    level.high = std::max(level.high, values[i]);
  }
  for (const auto& [place, level] : by_level) {
    LevelRate rate{draw.label, "", level.low, level.high, level.successes, level.runs};
    if (draw.words) {
      const auto text = static_cast<std::size_t>(place);
      rate.word = text < draw.texts.size() ? draw.texts[text] : "";
      rate.low = rate.high = kNaN;
    }
    rates.push_back(rate);
  }
}

Sensitivity OfArm(const std::string& arm, const Campaign& campaign, const RowColumns& columns,
                  const Rows& rows) {
  const std::vector<Draw> draws = DrawsOf(campaign, columns);
  Sensitivity found{arm, static_cast<int>(rows.size()), static_cast<int>(draws.size()), {}, {}};
  for (const Draw& draw : draws) AddRates(draw, rows, found.rates);
  for (const Column& column : SummedColumns(columns)) found.measures.push_back({column, 0, {}});
  for (const Group& group : GroupsOf(found.measures.size(), rows)) {
    Rows having;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (group.has[i]) having.push_back(rows[i]);
    }
    for (const std::size_t measure : group.measures) {
      found.measures[measure].runs = static_cast<int>(having.size());
    }
    if (having.size() < kLeastRunsPerDraw * draws.size()) continue;
    FindEffects(draws, group, having, found.measures);
  }
  return found;
}

}  // namespace

std::vector<Sensitivity> FindSensitivity(const Campaign& campaign, const RowColumns& columns,
                                         const std::vector<RunResult>& rows) {
  std::vector<Sensitivity> found;
  if (campaign.dispersions.empty() || rows.empty()) return found;
  const Rows unchanged = UnchangedRows(rows, columns);
  if (campaign.arms.empty()) return {OfArm("", campaign, columns, unchanged)};
  for (const Arm& arm : campaign.arms) {
    Rows of_arm;
    for (const RunResult* row : unchanged) {
      if (LabelOf(*row, columns, "arm") == arm.name) of_arm.push_back(row);
    }
    if (!of_arm.empty()) found.push_back(OfArm(arm.name, campaign, columns, of_arm));
  }
  return found;
}

}  // namespace dockyard
