#include "sim/page/overview_part.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "controller/base/number_text.h"
#include "sim/page/curves_part.h"
#include "sim/page/groups_part.h"
#include "sim/report/arm_pairs.h"
#include "sim/report/margins.h"
#include "sim/report/points.h"
#include "sim/report/sensitivity.h"
#include "sim/report/until_accepted.h"
#include "sim/statistics/acceptance.h"
#include "sim/statistics/intervals.h"
#include "sim/statistics/paired.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostNumbers = 40;

/// NaN has no place in JSON.
Json Number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json Ends(const Interval& interval) { return Json::array({interval.low, interval.high}); }

/// Of the runs in which no key was changed alone: the others are no sample of the same population.
Json Totals(const FinishedRuns& runs, const RowColumns& columns, std::int64_t planned) {
  int successes = 0, lost = 0;
  const Rows unchanged = UnchangedRows(runs.results, columns);
  for (const RunResult* row : unchanged) successes += row->success;
  for (const RunResult& row : runs.results) lost += IsLost(row.outcome);
  const auto changed = static_cast<std::int64_t>(runs.size() - unchanged.size());
  Json totals = ShareJson(successes, static_cast<int>(unchanged.size()));
  totals["word"] = SuccessWord(columns, runs.results);
  totals["planned"] = planned - changed;
  totals["lost"] = lost;
  if (changed > 0) totals["changed_alone"] = changed;
  return totals;
}

Json Causes(const FinishedRuns& runs) {
  std::map<std::string, std::pair<int, std::vector<int>>> causes;
  for (const RunResult& row : runs.results) {
    if (row.success) continue;
    auto& [count, numbers] = causes[row.outcome];
    ++count;
    if (numbers.size() < kMostNumbers) numbers.push_back(row.run);
  }
  Json list = Json::array();
  for (const auto& [outcome, found] : causes) {
    list.push_back({{"outcome", outcome}, {"count", found.first}, {"runs", found.second}});
  }
  std::stable_sort(list.begin(), list.end(),
                   [](const Json& a, const Json& b) { return a["count"] > b["count"]; });
  return list;
}

/// As LimitsOverRuns.
Json LimitsOfRuns(const FinishedRuns& runs, const RowColumns& columns) {
  Json list = Json::array();
  for (const LimitOverRuns& each : LimitsOverRuns(columns, runs.results)) {
    Json limit{{"name", each.name},
               {"unit", each.unit},
               {"meaning", each.meaning},
               {"judged", each.judged},
               {"broken", each.broken}};
    if (each.least != nullptr) {
      limit["least"] = each.least_margin;
      limit["run"] = each.least->run;
    }
    list.push_back(limit);
  }
  return list;
}

Json EstimateJson(const Estimate& estimate) {
  if (!std::isfinite(estimate.value)) return nullptr;
  return {{"value", estimate.value},
          {"low", Number(estimate.interval.low)},
          {"high", Number(estimate.interval.high)}};
}

Json SensitivityJson(const std::vector<Sensitivity>& found) {
  Json list = Json::array();
  for (const Sensitivity& arm : found) {
    Json draws = Json::array(), levels = Json::array();
    for (const DrawEffect& draw : arm.measures.front().draws) {
      draws.push_back({{"label", draw.label},
                       {"words", draw.words},
                       {"eta", Number(draw.eta)},
                       {"p", Number(draw.holm_p)},
                       {"rank", EstimateJson(draw.rank_correlation)},
                       {"partial", EstimateJson(draw.partial)}});
    }
    for (const LevelRate& rate : arm.rates) {
      Json level = ShareJson(rate.successes, rate.runs);
      level.update({{"label", rate.label},
                    {"word", rate.word},
                    {"low", Number(rate.low)},
                    {"high", Number(rate.high)}});
      levels.push_back(level);
    }
    list.push_back({{"arm", arm.arm}, {"draws", draws}, {"levels", levels}});
    if (arm.too_few()) list.back()["warning"] = TooFewText(arm);
  }
  return list;
}

Json ArmsJson(const Campaign& campaign, const FinishedRuns& runs, const RowColumns& columns) {
  std::map<std::string, Rows> by_arm;
  for (const RunResult& row : runs.results) by_arm[LabelOf(row, columns, "arm")].push_back(&row);
  Json list = Json::array();
  for (std::size_t i = 0; i < campaign.arms.size(); ++i) {
    for (std::size_t j = i + 1; j < campaign.arms.size(); ++j) {
      const std::string &a = campaign.arms[i].name, &b = campaign.arms[j].name;
      const PairedCounts counts = PairArms(by_arm[a], by_arm[b]).counts;
      const Estimate difference = PairedDifference(counts);
      list.push_back({{"a", a},
                      {"b", b},
                      {"both", counts.both},
                      {"only_a", counts.only_a},
                      {"only_b", counts.only_b},
                      {"neither", counts.neither},
                      {"difference", Number(difference.value)},
                      {"interval", Ends(difference.interval)},
                      {"exact_p", McNemarExact(counts.only_a, counts.only_b)},
                      {"mid_p", McNemarMidP(counts.only_a, counts.only_b)}});
    }
  }
  return list;
}

Json AcceptanceJson(const Json& totals, const AcceptanceAim& aim) {
  const int runs = totals["runs"], successes = totals["successes"];
  const Acceptance found = JudgeAcceptance(runs, runs - successes, aim.reliability, aim.confidence);
  std::string sentence = std::to_string(successes) + " of " + std::to_string(runs) + " " +
                         totals["word"].get<std::string>();
  const bool undecided = found.verdict == AcceptanceVerdict::kUndecided,
             accepted = found.verdict == AcceptanceVerdict::kAccepted;
  sentence += accepted ? " show " : undecided ? " do not yet show " : " show less than ";
  sentence += "a reliability of ";
  sentence += NumberText(100.0 * aim.reliability) + " % at a confidence of " +
              NumberText(100.0 * aim.confidence) + " %.";
  return {{"verdict", NameOf(found.verdict)},
          {"sentence", sentence},
          {"reliability", aim.reliability},
          {"confidence", aim.confidence},
          {"lower", found.lower},
          {"upper", found.upper},
          {"further_runs", undecided && found.further_runs ? Json(*found.further_runs) : Json()}};
}

/// `requirements` and `aims`: the limits of those on success, for figures to show.
void AddRequirements(const std::vector<Requirement>& requirements,
                     const std::optional<AcceptanceAim>& aim, const FinishedRuns& runs,
                     const RowColumns& columns, Json& json) {
  Json judged = Json::array(), aims = Json::array();
  if (aim) {
    aims.push_back({{"text", NumberText(100.0 * aim->reliability) + " % to be shown"},
                    {"share", aim->reliability}});
  }
  for (const Requirement& requirement : requirements) {
    const Judgement found = Judge(requirement, columns, runs.results);
    judged.push_back({{"met", found.met}, {"text", found.text}});
    if (requirement.figure != kSuccess || requirement.outcome) continue;
    aims.push_back({{"text", requirement.text}, {"share", requirement.limit}});
  }
  if (!judged.empty()) json["requirements"] = judged;
  if (!aims.empty()) json["aims"] = aims;
}

}  // namespace

Json OverviewPart(const Campaign* campaign, const FinishedRuns& runs, const RowColumns& columns,
                  const std::optional<AcceptanceAim>& aim,
                  const std::vector<Requirement>& requirements) {
  const auto count = static_cast<std::int64_t>(runs.size());
  Json json{{"totals", Totals(runs, columns, campaign ? campaign->run_count() : count)},
            {"groups", GroupsPart(campaign, runs, columns)},
            {"causes", Causes(runs)},
            {"limits", LimitsOfRuns(runs, columns)}};
  if (campaign != nullptr) {
    json["sensitivity"] = SensitivityJson(FindSensitivity(*campaign, columns, runs.results));
    if (!campaign->arms.empty()) json["arms"] = ArmsJson(*campaign, runs, columns);
  }
  if (campaign != nullptr) json["curves"] = CurvesPart(*campaign, runs, columns);
  const bool sample = campaign == nullptr || WhyNotSequential(*campaign).empty();
  if (aim && sample) json["acceptance"] = AcceptanceJson(json["totals"], *aim);
  AddRequirements(requirements, aim, runs, columns, json);
  return json;
}

}  // namespace dockyard
