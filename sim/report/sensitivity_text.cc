#include <algorithm>
#include <cmath>

#include "sim/base/count_text.h"
#include "sim/base/text.h"
#include "sim/report/rate_text.h"
#include "sim/report/sensitivity.h"
#include "sim/statistics/intervals.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostDraws = 12;  // in the summary

using Cells = std::vector<std::string>;

/// Empty for NaN.
std::string Cell(double value) { return std::isnan(value) ? "" : NumberText(value); }

std::string Signed(double value) { return (value < 0.0 ? "" : "+") + Fixed(value, 2); }

/// "-0.31 (-0.37 to -0.25)", a dash where it cannot be told.
std::string EstimateText(const Estimate& estimate) {
  if (std::isnan(estimate.value)) return "-";
  if (std::isnan(estimate.interval.low)) return Signed(estimate.value);
  return Signed(estimate.value) + " (" + Signed(estimate.interval.low) + " to " +
         Signed(estimate.interval.high) + ")";
}

/// "loose 60 % (36-81), compact 95 % (75-100)"
std::string RatesText(const std::string& label, const std::vector<LevelRate>& rates) {
  std::string text;
  for (const LevelRate& rate : rates) {
    if (rate.label != label) continue;
    text += (text.empty() ? "" : ", ") + rate.word + " " + ShortRate(rate.successes, rate.runs);
  }
  return text;
}

std::string Padded(std::string text, std::size_t width) {
  text.append(width > text.size() ? width - text.size() : 0, ' ');
  return text;
}

/// Columns as wide as their longest cell; a line's last cell does not count.
std::string Table(const std::vector<Cells>& lines) {
  std::vector<std::size_t> widths;
  for (const Cells& cells : lines) {
    widths.resize(std::max(widths.size(), cells.size()), 0);
    for (std::size_t i = 0; i + 1 < cells.size(); ++i) {
      widths[i] = std::max(widths[i], cells[i].size());
    }
  }
  std::string text;
  for (const Cells& cells : lines) {
    std::string line = " ";
    for (std::size_t i = 0; i < cells.size(); ++i) {
      line += " " + (i + 1 < cells.size() ? Padded(cells[i], widths[i] + 1) : cells[i]);
    }
    text += line + "\n";
  }
  return text;
}

std::string ArmText(const Sensitivity& found) {
  const MeasureEffects& success = found.measures[0];
  std::string text = "\nsensitivity of success to the draws" +
                     (found.arm.empty() ? "" : ", arm " + found.arm) + ", " +
                     CountText(found.runs, "run") + ", 95 % intervals\n";
  if (found.too_few()) return text + "  " + TooFewText(found) + "\n";
  std::vector<Cells> lines{{"", "eta", "p (Holm)", "rank correlation", "partial"}};
  for (const DrawEffect& draw : success.draws) {
    if (std::isnan(draw.eta) || lines.size() > kMostDraws) break;
    Cells cells{draw.label, Fixed(draw.eta, 2), ChanceText(draw.holm_p)};
    if (draw.words) {
      cells.push_back(RatesText(draw.label, found.rates));
    } else {
      cells.push_back(EstimateText(draw.rank_correlation));
      cells.push_back(EstimateText(draw.partial));
    }
    lines.push_back(cells);
  }
  if (lines.size() == 1) return text + "  success does not vary, or the runs are too few\n";
  text += Table(lines);
  const std::size_t more = success.draws.size() + 1 - lines.size();
  if (more > 0) text += "  " + std::to_string(more) + " more in sensitivity.csv\n";
  return text;
}

}  // namespace

std::string TooFewText(const Sensitivity& arm) {
  if (!arm.too_few()) return "";
  return "warning: no list: " + CountText(arm.runs, "run") + " for " +
         CountText(arm.draws, "draw") + ", and below " + std::to_string(kLeastRunsPerDraw) +
         " runs a draw its order is mostly chance";
}

std::string SensitivityText(const std::vector<Sensitivity>& found) {
  std::string text;
  for (const Sensitivity& arm : found) text += ArmText(arm);
  return text;
}

std::string SensitivityCsv(const std::vector<Sensitivity>& found) {
  std::string text =
      "arm,measure,draw,kind,runs,eta,eta_p,eta_p_holm,rank_correlation,rank_correlation_low,"
      "rank_correlation_high,partial,partial_low,partial_high\n";
  for (const Sensitivity& arm : found) {
    for (const MeasureEffects& measure : arm.measures) {
      for (const DrawEffect& draw : measure.draws) {
        Cells cells{arm.arm,
                    measure.measure.name,
                    draw.label,
                    draw.words ? "words" : "numbers",
                    std::to_string(measure.runs),
                    Cell(draw.eta),
                    Cell(draw.p_value),
                    Cell(draw.holm_p)};
        for (const Estimate* estimate : {&draw.rank_correlation, &draw.partial}) {
          cells.insert(cells.end(), {Cell(estimate->value), Cell(estimate->interval.low),
                                     Cell(estimate->interval.high)});
        }
        text += SafeCsvLine(cells) + "\n";
      }
    }
  }
  return text;
}

std::string SensitivityLevelsCsv(const std::vector<Sensitivity>& found) {
  std::string text =
      "arm,draw,word,low,high,runs,success,success_low,success_high,docked,docked_low,docked_"
      "high\n";
  for (const Sensitivity& arm : found) {
    for (const LevelRate& rate : arm.rates) {
      const Interval interval = ClopperPearson(rate.successes, rate.runs);
      const Cells share{NumberText(static_cast<double>(rate.successes) / rate.runs),
                        NumberText(interval.low), NumberText(interval.high)};
      Cells cells{arm.arm,        rate.label,      rate.word,
                  Cell(rate.low), Cell(rate.high), std::to_string(rate.runs)};
      for (int i = 0; i < 2; ++i) cells.insert(cells.end(), share.begin(), share.end());
      text += SafeCsvLine(cells) + "\n";
    }
  }
  return text;
}

}  // namespace dockyard
