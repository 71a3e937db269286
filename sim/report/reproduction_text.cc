#include "sim/report/reproduction_text.h"

#include <algorithm>
#include <cmath>

#include "controller/base/number_text.h"
#include "controller/geometry/pose.h"
#include "sim/base/count_text.h"
#include "sim/report/rate_text.h"

namespace dockyard {
namespace {

using Line = std::vector<std::string>;

/// Columns as wide as their longest cell; a header line of one cell is a title and stands alone.
std::string Table(const std::vector<Line>& lines) {
  std::vector<std::size_t> widths;
  for (const Line& line : lines) {
    widths.resize(std::max(widths.size(), line.size()));
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  for (const Line& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) {
      row += (i == 0 ? "" : "  ") + line[i] + std::string(widths[i] - line[i].size(), ' ');
    }
    row.erase(row.find_last_not_of(' ') + 1);
    text += row + "\n";
  }
  return text;
}

std::string Range(const CountInterval& counts) {
  return std::to_string(counts.low) + "-" + std::to_string(counts.high);
}

std::string PercentText(double confidence) {
  return NumberText(std::round(1e4 * confidence) / 100.0) + " %";
}

std::string NamesText(const std::vector<PublishedName>& names) {
  std::string text;
  for (const PublishedName& name : names) text += (text.empty() ? "" : ", ") + name.text;
  return text;
}

/// Of a row or of a class of failures that has its runs.
template <class Finding>
std::string CountVerdict(const Finding& found) {
  const std::string word = found.inside() ? "inside " : "outside ";
  return word + (found.counts ? "at " + PercentText(found.confidence) + ": " : "") +
         Range(found.judged_at) + ", p = " + BriefNumber(found.p) +
         (found.counts ? "" : ", does not count");
}

std::string RowVerdict(const RowFinding& found) {
  if (!found.row->paper) return found.row->says;
  const int wanted = found.runs + found.lacking;
  if (!found.comparable()) {
    return std::to_string(found.runs) + " of " + CountText(wanted, "run") + ": not judged";
  }
  return CountVerdict(found);
}

std::string RowsText(const ReproductionFinding& found) {
  std::vector<Line> lines{{"runs", "paper", "here", "predicted", "the paper's count is"}};
  for (const RowFinding& each : found.rows) {
    const auto& paper = each.row->paper;
    lines.push_back({each.row->name, paper ? RateText(paper->count, paper->runs) : "not given",
                     RateText(each.successes, each.runs),
                     each.comparable() ? Range(each.at_95) : "", RowVerdict(each)});
  }
  return Table(lines);
}

/// The paper's counts against the runs that are truly successes.
std::string StrictText(const ReproductionFinding& found) {
  if (found.published->strict.empty()) return "";
  std::vector<Line> lines{{"strictly", "paper", "here", "predicted", "the paper's count would be"}};
  for (const RowFinding& each : found.rows) {
    if (!each.strict) continue;
    const auto& paper = each.row->paper;
    const StrictFinding& strict = *each.strict;
    const bool inside = paper && strict.at_95.Holds(paper->count);
    lines.push_back(
        {each.row->name, paper ? RateText(paper->count, paper->runs) : "not given",
         RateText(strict.successes, each.runs), each.comparable() ? Range(strict.at_95) : "",
         each.comparable()
             ? std::string(inside ? "inside" : "outside") + ", p = " + BriefNumber(strict.p)
             : ""});
  }
  return "\nstrictly: " + NamesText(found.published->strict) + " alone; it does not count\n" +
         Table(lines);
}

/// How the paper's count lies, and what else the paper says.
std::string FailureVerdict(const FailureFinding& each) {
  if (!each.counts) return each.says;
  const std::string verdict = each.comparable() ? CountVerdict(each) : "not judged";
  return verdict + (each.says.empty() ? "" : "; " + each.says);
}

std::string FailuresText(const ReproductionFinding& found) {
  if (found.failures.empty()) return "";
  std::vector<Line> lines{{"failures", "paper", "here", "predicted", "the paper's count is"}};
  for (const FailureFinding& each : found.failures) {
    lines.push_back(
        {each.name,
         each.paper ? std::to_string(each.paper->count) + " of " + std::to_string(each.paper->runs)
                    : "",
         std::to_string(each.count) + " of " + std::to_string(each.runs),
         each.at_95 ? Range(*each.at_95) : "", FailureVerdict(each)});
  }
  return "\n" + Table(lines);
}

/// "2.6 (1.9)"; "-" without values.
std::string MeanAndMedian(double mean, double median, double unit) {
  if (std::isnan(mean)) return "-";
  return Fixed(mean / unit, 1) + " (" + Fixed(median / unit, 1) + ")";
}

std::string ErrorsText(const ReproductionFinding& found) {
  if (found.errors.empty()) return "";
  constexpr double kCm = 0.01;
  const double degree = Radians(1.0);
  const auto paper = [](double value, double unit) {
    return std::isnan(value) ? std::string("-") : Fixed(value / unit, 2);
  };
  std::vector<Line> lines{{"sightings at", "r, paper", "here, cm", "place here, cm",
                           "heading, paper", "here, deg", "sightings", "wrong"}};
  for (const ErrorFinding& each : found.errors) {
    lines.push_back({NumberText(each.paper.at_m) + " m", paper(each.paper.r_m, kCm),
                     MeanAndMedian(each.mean_r_m, each.median_r_m, kCm),
                     MeanAndMedian(each.mean_place_m, each.median_place_m, kCm),
                     paper(each.paper.heading_rad, degree),
                     MeanAndMedian(each.mean_heading_rad, each.median_heading_rad, degree),
                     std::to_string(each.sightings) + " in " + CountText(each.runs, "run"),
                     std::to_string(each.wrong)});
  }
  return "\nmean error of the accepted sightings within " + NumberText(found.published->within_m) +
         " m of a distance, median in brackets; without the wrong ones\n" + Table(lines);
}

std::string MeasuresText(const ReproductionFinding& found) {
  if (found.measures.empty()) return "";
  std::vector<Line> lines{{"measure", "paper", "mean", "median", "10-90 %", "runs", "judged"}};
  for (const MeasureFinding& each : found.measures) {
    const std::string unit = each.unit.empty() ? "" : " " + each.unit;
    const std::string paper =
        std::isnan(each.measure->low)
            ? "not given"
            : NumberText(each.measure->low) + "-" + NumberText(each.measure->high) + unit;
    if (!each.simulated || each.runs == 0) {
      lines.push_back({each.measure->name, paper, each.simulated ? "no run has it" : "not run"});
      continue;
    }
    lines.push_back({each.measure->name, paper, BriefNumber(each.mean) + unit,
                     BriefNumber(each.median), BriefNumber(each.low) + "-" + BriefNumber(each.high),
                     std::to_string(each.runs),
                     !each.measure->judged ? ""
                     : each.inside()       ? "inside"
                                           : "outside"});
  }
  return "\n" + Table(lines);
}

std::string NamesWhere(const ReproductionFinding& found, bool lacking) {
  std::string names;
  for (const RowFinding& each : found.rows) {
    if (!each.counts || (lacking ? each.comparable() : each.inside())) continue;
    names += (names.empty() ? "" : ", ") + each.row->name;
  }
  for (const FailureFinding& each : found.failures) {
    if (!each.counts || (lacking ? each.comparable() : each.inside())) continue;
    names += (names.empty() ? "" : ", ") + each.name;
  }
  for (const MeasureFinding& each : found.measures) {
    if (!each.measure->judged || (lacking ? each.simulated : each.inside())) continue;
    names += (names.empty() ? "" : ", ") + each.measure->name;
  }
  return names;
}

int JudgedCauses(const ReproductionFinding& found) {
  return static_cast<int>(std::count_if(found.failures.begin(), found.failures.end(),
                                        [](const FailureFinding& each) { return each.counts; }));
}

}  // namespace

std::string VerdictText(const ReproductionFinding& found) {
  const std::string verdict = NameOf(found.verdict);
  switch (found.verdict) {
    case ReproductionVerdict::kInside:
      return verdict + ": the paper's total, and each row" +
             (JudgedCauses(found) > 0 ? ", cause" : "") + " and measure that counts";
    case ReproductionVerdict::kOutside:
      return verdict + ": " + NamesWhere(found, false);
    case ReproductionVerdict::kNotJudged:
      break;
  }
  return verdict + ": these runs are not those of the paper: " + NamesWhere(found, true);
}

std::string ReproductionText(const ReproductionFinding& found) {
  const Published& published = *found.published;
  const std::size_t m = published.judged.size();
  std::string text =
      published.name + ": " + published.source + "\n" + CountText(found.runs, "run") + ", " +
      CountText(found.replications, "replication") +
      "; counted as successes, as the paper counts: " + NamesText(published.counted) + "\n\n";
  text += RowsText(found);
  text +=
      "95 % intervals of Clopper and Pearson; predicted: the paper's count at 95 %, given these "
      "runs (Thatcher)";
  if (m > 0) {
    text += "\nthe total counts at 95 %, each of " + CountText(m, "row") + " at 1 - 0.05/" +
            std::to_string(m);
  }
  const int causes = JudgedCauses(found);
  if (causes > 0) {
    text += ", each of " + CountText(causes, "cause") + " at 1 - 0.05/" + std::to_string(causes);
  }
  text += "\n" + StrictText(found) + FailuresText(found) + ErrorsText(found) + MeasuresText(found);
  return text + "\n" + VerdictText(found) + "\n";
}

}  // namespace dockyard
