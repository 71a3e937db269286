#include "sim/page/markdown.h"

#include <vector>

#include "controller/base/number_text.h"
#include "sim/report/rate_text.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostDraws = 12, kMostReplays = 10;

std::string Percent(double share) { return Fixed(100.0 * share, 0); }

/// "36/40 (90 %, 76-97 %)"
std::string Rate(const Json& share) {
  const int successes = share["successes"], runs = share["runs"];
  std::string text = std::to_string(successes) + "/" + std::to_string(runs);
  if (runs == 0) return text;
  return text + " (" + Percent(static_cast<double>(successes) / runs) + " %, " +
         Percent(share["interval"][0]) + "-" + Percent(share["interval"][1]) + " %)";
}

/// A bar would end the cell.
std::string Cell(std::string text) {
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) {
    text.insert(at, "\\");
  }
  return text;
}

std::string Line(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + Cell(cell) + " |";
  return line + "\n";
}

std::string Head(const std::vector<std::string>& names) {
  std::string marks = "|";
  for (std::size_t i = 0; i < names.size(); ++i) marks += "---|";
  return "\n" + Line(names) + marks + "\n";
}

std::string Number(const Json& value, int decimals) {
  return value.is_number() ? Fixed(value.get<double>(), decimals) : "-";
}

/// "0.0391", "< 0.0001"
std::string Chance(const Json& p) { return p.is_number() ? ChanceText(p.get<double>()) : "-"; }

std::string Estimate(const Json& estimate) {
  if (!estimate.is_object()) return "-";
  return Number(estimate["value"], 2) + " (" + Number(estimate["low"], 2) + " to " +
         Number(estimate["high"], 2) + ")";
}

/// A number with four figures; words as they are.
std::string ShortNumber(const std::string& text) {
  const auto number = NumberFromText(text);
  return number ? BriefNumber(*number) : text;
}

std::string Groups(const Json& groups, const std::string& word) {
  if (groups.empty()) return "";
  std::string text = Head({"factor", "value", word});
  for (const Json& group : groups) {
    for (const Json& value : group["values"]) {
      text += Line({group["label"], ShortNumber(value["value"]), Rate(value)});
    }
  }
  return text;
}

std::string Causes(const Json& causes, const std::string& replay_command) {
  if (causes.empty()) return "\nNo run failed.\n";
  std::string text = Head({"cause", "runs", "numbers"});
  std::vector<int> replayed;
  for (const Json& cause : causes) {
    std::string numbers;
    for (const Json& run : cause["runs"]) {
      numbers += (numbers.empty() ? "" : " ") + std::to_string(run.get<int>());
      if (replayed.size() < kMostReplays) replayed.push_back(run);
    }
    const bool more = cause["count"].get<std::size_t>() > cause["runs"].size();
    text += Line({cause["outcome"], std::to_string(cause["count"].get<int>()),
                  numbers + (more ? " ..." : "")});
  }
  if (replay_command.empty()) return text;
  text += "\n```sh\n";
  for (const int run : replayed) {
    std::string command = replay_command;
    text += command.replace(command.find("{run}"), 5, std::to_string(run)) + "\n";
  }
  return text + "```\n";
}

std::string Limits(const Json& limits) {
  if (limits.empty()) return "";
  std::string text = Head({"limit", "broken", "least margin of a success", "run"});
  for (const Json& each : limits) {
    const bool any = each.contains("run");
    text += Line({each["name"],
                  std::to_string(each["broken"].get<int>()) + "/" +
                      std::to_string(each["judged"].get<int>()),
                  any ? BriefNumber(each["least"]) + " " + each["unit"].get<std::string>() : "-",
                  any ? std::to_string(each["run"].get<int>()) : "-"});
  }
  return text;
}

std::string SensitivityTable(const Json& sensitivity) {
  std::string text;
  for (const Json& arm : sensitivity) {
    const std::string name = arm["arm"];
    text += "\nWhat success depends on" + (name.empty() ? "" : ", arm " + name) + ":\n";
    if (arm.contains("warning")) {
      text += "\n" + arm["warning"].get<std::string>() + ".\n";
      continue;
    }
    text += Head({"draw", "eta", "p (Holm)", "rank correlation", "partial"});
    std::size_t shown = 0;
    for (const Json& draw : arm["draws"]) {
      if (!draw["eta"].is_number() || shown++ == kMostDraws) break;
      text += Line({draw["label"], Number(draw["eta"], 2), Chance(draw["p"]),
                    Estimate(draw["rank"]), Estimate(draw["partial"])});
    }
  }
  return text;
}

std::string Arms(const Json& arms) {
  std::string text = Head({"A", "B", "only A", "only B", "A less B", "p (mid-p)"});
  for (const Json& pair : arms) {
    text += Line({pair["a"], pair["b"], std::to_string(pair["only_a"].get<int>()),
                  std::to_string(pair["only_b"].get<int>()),
                  Number(pair["difference"], 3) + " (" + Number(pair["interval"][0], 3) + " to " +
                      Number(pair["interval"][1], 3) + ")",
                  Chance(pair["mid_p"])});
  }
  return text;
}

}  // namespace

std::string OverviewMarkdown(const std::string& title, const Json& overview,
                             const std::string& replay_command) {
  const Json& totals = overview["totals"];
  const std::string word = totals["word"];
  std::string text =
      "# " + title + "\n\n" + word + " " + Rate(totals) + "; 95 % intervals, exact.\n";
  const std::int64_t missing =
      totals["planned"].get<std::int64_t>() - totals["runs"].get<std::int64_t>();
  if (totals.contains("changed_alone")) {
    text += std::to_string(totals["changed_alone"].get<std::int64_t>()) +
            " runs in which a key was changed alone are not counted there.\n";
  }
  if (missing > 0) text += std::to_string(missing) + " planned runs are not there.\n";
  if (overview.contains("acceptance")) {
    text += "\n**" + overview["acceptance"]["verdict"].get<std::string>() +
            "**: " + overview["acceptance"]["sentence"].get<std::string>() + "\n";
  }
  if (overview.contains("requirements")) {
    text += "\n";
    for (const Json& each : overview["requirements"]) {
      text += "- " + each["text"].get<std::string>() + "\n";
    }
  }
  text += Groups(overview["groups"], word) + Causes(overview["causes"], replay_command) +
          Limits(overview["limits"]);
  if (overview.contains("arms")) text += Arms(overview["arms"]);
  if (overview.contains("sensitivity")) text += SensitivityTable(overview["sensitivity"]);
  return text;
}

}  // namespace dockyard
