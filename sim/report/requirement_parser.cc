#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "sim/base/text.h"
#include "sim/report/points.h"
#include "sim/report/requirement.h"

namespace dockyard {
namespace {

using Names = std::vector<std::string>;
using Relation = Requirement::Relation;
using Statistic = Requirement::Statistic;

const std::string kOutcome = "outcome.", kMargin = "margin.";
const std::string kShareStatistics = "none, .lower95, .upper95, or another per cent from 50 on";
const std::string kMeasureStatistics = ".mean, .min, .median, .max, or .p90 or another per cent";

std::string Trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t");
  if (from == std::string::npos) return "";
  return text.substr(from, text.find_last_not_of(" \t") - from + 1);
}

bool Holds(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The texts that the campaign's file gives a label; empty where it leaves them open.
Names TextsOf(const std::string& label, const Campaign& campaign) {
  Names texts;
  const auto add = [&](const std::vector<Factor>& factors) {
    for (const Factor& factor : factors) {
      if (factor.key.name == label) texts = factor.labels;
    }
  };
  if (label == "arm") {
    for (const Arm& arm : campaign.arms) texts.push_back(arm.name);
  }
  add(campaign.grid);
  add(campaign.named);
  for (const Dispersion& dispersion : campaign.dispersions) {
    if (dispersion.discrete()) add({dispersion.values});
  }
  return texts;
}

/// "success[arm=ours].lower95 >= 0.9" in parts, spaces left out.
struct Parts {
  std::string figure, where, statistic, relation, limit;
  bool filtered = false;
};

std::optional<Parts> Split(const std::string& text) {
  Parts parts;
  const std::size_t open = text.find('['), close = text.find(']');
  const std::size_t relation = text.find_first_of("<>=", close == std::string::npos ? 0 : close);
  if (relation == std::string::npos) return std::nullopt;
  parts.filtered = open < relation;
  if (parts.filtered && (close == std::string::npos || close < open)) return std::nullopt;
  if (parts.filtered) {
    parts.figure = Trimmed(text.substr(0, open));
    parts.where = text.substr(open + 1, close - open - 1);
    parts.statistic = Trimmed(text.substr(close + 1, relation - close - 1));
  } else {
    parts.figure = Trimmed(text.substr(0, relation));
  }
  const std::size_t limit = text.find_first_not_of("<>=", relation);
  if (limit == std::string::npos) return std::nullopt;
  parts.relation = text.substr(relation, limit - relation);
  parts.limit = Trimmed(text.substr(limit));
  return parts;
}

/// Without brackets the statistic is what follows the figure's name.
void SplitStatistic(Parts& parts) {
  if (parts.filtered) return;
  std::size_t from = 0;
  for (const std::string& head : {kOutcome, kMargin}) {
    if (parts.figure.starts_with(head)) from = head.size();
  }
  const std::size_t dot = parts.figure.find('.', from);
  if (dot == std::string::npos) return;
  parts.statistic = parts.figure.substr(dot);
  parts.figure.erase(dot);
}

class Parser {
 public:
  Parser(const std::string& text, const RowColumns& columns, const Campaign& campaign)
      : columns_(columns), campaign_(campaign) {
    made_.text = Trimmed(text);
  }

  Result<Requirement, std::string> Parse() {
    auto parts = Split(made_.text);
    if (!parts) {
      return Said("a figure, a relation and a number, such as 'success >= 0.9'", made_.text);
    }
    SplitStatistic(*parts);
    for (const auto& read : {&Parser::ReadFigure, &Parser::ReadWhere, &Parser::ReadStatistic,
                             &Parser::ReadRelation, &Parser::ReadLimit}) {
      const std::string fault = (this->*read)(*parts);
      if (!fault.empty()) return fault;
    }
    return made_;
  }

 private:
  std::string Said(const std::string& expected, const std::string& found) const {
    return "'" + made_.text + "': expected " + expected + ", found '" + found + "'";
  }

  bool IsShare() const { return made_.outcome || made_.figure == kSuccess; }

  std::string ReadFigure(const Parts& parts) {
    Names figures;
    for (const Column& column : SummedColumns(columns_)) figures.push_back(column.name);
    made_.figure = parts.figure == "docked" ? kSuccess : parts.figure;  // the former name
    if (Holds(figures, made_.figure)) return "";
    for (const OutcomeName& outcome : columns_.outcomes) {
      figures.push_back(kOutcome + outcome.name);
    }
    if (!Holds(figures, made_.figure)) return Said("one of " + Listed(figures), made_.figure);
    made_.outcome = true;
    made_.figure.erase(0, kOutcome.size());
    return "";
  }

  std::string ReadWhere(const Parts& parts) {
    if (!parts.filtered) return "";
    Names labels = columns_.labels;
    labels.push_back("controller");
    for (std::size_t from = 0; from <= parts.where.size();) {
      const std::size_t comma = std::min(parts.where.find(',', from), parts.where.size());
      const std::string one = Trimmed(parts.where.substr(from, comma - from));
      const std::size_t equals = one.find('=');
      if (equals == std::string::npos) return Said("LABEL=TEXT in the brackets", one);
      const std::string label = Trimmed(one.substr(0, equals)),
                        text = Trimmed(one.substr(equals + 1));
      if (!Holds(labels, label)) return Said("a label (" + Listed(labels) + ")", label);
      const Names texts = TextsOf(label, campaign_);
      if (!texts.empty() && !Holds(texts, text)) {
        return Said(label + " to be one of " + Listed(texts), text);
      }
      made_.where.push_back({label, text});
      from = comma + 1;
    }
    return "";
  }

  /// ".lower95": the word with its per cent.
  static std::optional<double> PerCentAfter(const std::string& word, const std::string& text) {
    if (text.rfind(word, 0) != 0 || text.size() == word.size()) return std::nullopt;
    if (std::isdigit(static_cast<unsigned char>(text[word.size()])) == 0) return std::nullopt;
    return NumberFromText(text.substr(word.size()));
  }

  std::string ReadStatistic(const Parts& parts) {
    return IsShare() ? ReadShareStatistic(parts.statistic) : ReadMeasureStatistic(parts.statistic);
  }

  std::string ReadShareStatistic(const std::string& text) {
    if (text.empty()) return "";
    made_.statistic = Statistic::kLower;
    std::optional<double> percent = PerCentAfter(".lower", text);
    if (!percent) {
      made_.statistic = Statistic::kUpper;
      percent = PerCentAfter(".upper", text);
    }
    if (!percent || !(*percent >= 50.0 && *percent < 100.0)) return Said(kShareStatistics, text);
    made_.level = *percent / 100.0;
    return "";
  }

  std::string ReadMeasureStatistic(const std::string& text) {
    made_.statistic = Statistic::kQuantile;
    if (text == ".mean") {
      made_.statistic = Statistic::kMean;
      return "";
    }
    const std::optional<double> percent = text == ".min"      ? 0.0
                                          : text == ".median" ? 50.0
                                          : text == ".max"    ? 100.0
                                                              : PerCentAfter(".p", text);
    if (!percent || !(*percent >= 0.0 && *percent <= 100.0)) return Said(kMeasureStatistics, text);
    made_.level = *percent / 100.0;
    return "";
  }

  std::string ReadRelation(const Parts& parts) {
    static const std::array<std::pair<const char*, Relation>, 4> known{{{">=", Relation::kAtLeast},
                                                                        {">", Relation::kAbove},
                                                                        {"<=", Relation::kAtMost},
                                                                        {"<", Relation::kBelow}}};
    for (const auto& [text, relation] : known) {
      if (parts.relation != text) continue;
      made_.relation = relation;
      return "";
    }
    return Said(">=, >, <= or <", parts.relation);
  }

  std::string ReadLimit(const Parts& parts) {
    const auto value = NumberFromText(parts.limit);
    const bool good = value && value.value() - value.value() == 0.0;  // finite
    if (IsShare() && !(good && *value >= 0.0 && *value <= 1.0)) {
      return Said("a share from 0 to 1", parts.limit);
    }
    if (!good) return Said("a number", parts.limit);
    made_.limit = *value;
    return "";
  }

  const RowColumns& columns_;
  const Campaign& campaign_;
  Requirement made_;
};

}  // namespace

Result<Requirement, std::string> ParseRequirement(const std::string& text,
                                                  const RowColumns& columns,
                                                  const Campaign& campaign) {
  return Parser(text, columns, campaign).Parse();
}

}  // namespace dockyard
