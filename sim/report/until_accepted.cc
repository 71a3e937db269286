#include "sim/report/until_accepted.h"

#include <array>

#include "sim/base/count_text.h"
#include "sim/base/text.h"
#include "sim/report/rate_text.h"
#include "sim/report/sample.h"

namespace dockyard {
namespace {

const char* NameOf(SequentialState state) {
  switch (state) {
    case SequentialState::kAccepted:
      return "accepted";
    case SequentialState::kRejected:
      return "not accepted";
    case SequentialState::kUndecided:
      return "undecided";
    case SequentialState::kContinue:
      break;
  }
  return "not ended";
}

Json ToJson(const SequentialAims& aims) {
  return {{"reliability", aims.reliability},
          {"confidence", aims.confidence},
          {"design_reliability", aims.design_reliability},
          {"power", aims.power},
          {"max_runs", aims.max_runs}};
}

Json ToJson(double reliability, const SequentialOperation& operation) {
  return {{"reliability", reliability},
          {"accept", operation.accept},
          {"not_accept", operation.reject},
          {"undecided", operation.undecided},
          {"mean_runs", operation.mean_runs}};
}

std::string Chances(double reliability, const SequentialOperation& operation) {
  return "  a system at " + NumberText(reliability) + ": accepted with the chance " +
         BriefNumber(operation.accept) + ", not accepted " + BriefNumber(operation.reject) +
         ", undecided " + BriefNumber(operation.undecided) + "; " + Fixed(operation.mean_runs, 1) +
         " runs on the mean\n";
}

}  // namespace

std::string WhyNotSequential(const Campaign& campaign) {
  return campaign.arms.empty() ? WhyNoSample(campaign) : "it has arms";
}

Json SequentialJson(const SequentialPlan& plan, const SequentialEnd& end) {
  const SequentialAims& aims = plan.aims;
  Json json{{"verdict", NameOf(end.state)}, {"trials", end.trials}, {"failures", end.failures}};
  json["aims"] = ToJson(aims);
  json["exact"] =
      Json::array({ToJson(aims.reliability, ExactOperation(plan, aims.reliability)),
                   ToJson(aims.design_reliability, ExactOperation(plan, aims.design_reliability))});
  return json;
}

std::string SequentialText(const SequentialPlan& plan, const SequentialEnd& end) {
  const SequentialAims& aims = plan.aims;
  std::string text = std::string(NameOf(end.state)) + " after " + CountText(end.trials, "run") +
                     ", " + CountText(end.failures, "failure") + ": reliability " +
                     NumberText(aims.reliability) + " at confidence " +
                     NumberText(aims.confidence) + "\n";
  text += "sequential test against " + NumberText(aims.design_reliability) + ", power " +
          NumberText(aims.power) + ", at most " + CountText(aims.max_runs, "run") + "; exactly:\n";
  for (const double reliability : std::array{aims.reliability, aims.design_reliability}) {
    text += Chances(reliability, ExactOperation(plan, reliability));
  }
  return text + "The share of successes is no fair estimate: the runs ended because of it.\n";
}

int DecidedRuns(const std::string& json_text) {
  const Json json = Json::parse(json_text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object() || json.value("went_on", Json(false)) == true) return 0;
  const Json verdict = json.value("verdict", Json()), trials = json.value("trials", Json());
  const bool decided = verdict.is_string() && verdict != NameOf(SequentialState::kContinue);
  const bool counted = trials.is_number_unsigned() && trials <= 1000000000u;
  return decided && counted ? trials.get<int>() : 0;
}

std::string WentOnText(const std::string& json_text) {
  Json json = Json::parse(json_text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return "";
  json["went_on"] = true;
  return json.dump(2) + "\n";
}

bool HasTheseAims(const std::string& json_text, const SequentialAims& aims) {
  const Json json = Json::parse(json_text, nullptr, /*allow_exceptions=*/false);
  return json.is_object() && json.contains("aims") && json["aims"] == ToJson(aims);
}

}  // namespace dockyard
