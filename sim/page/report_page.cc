#include "sim/page/report_page.h"

#include <algorithm>
#include <cstdio>

#include "models/read/config_error.h"
#include "sim/base/bytes.h"
#include "sim/base/files.h"
#include "sim/page/scene_part.h"
#include "sim/page/table_part.h"

namespace dockyard {
namespace {

std::string Hexadecimal(std::uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

Json SystemJson(const ReportContent& content) {
  Json outcomes = Json::array(), columns = Json::array();
  for (const OutcomeName& outcome : content.columns.outcomes) {
    outcomes.push_back(
        {{"name", outcome.name}, {"success", outcome.success}, {"meaning", outcome.meaning}});
  }
  for (const Column& column : content.columns.measures) {
    columns.push_back({{"name", column.name}, {"unit", column.unit}, {"meaning", column.meaning}});
  }
  return {{"name", content.system}, {"outcomes", outcomes}, {"columns", columns}};
}

Json CampaignJson(const Campaign* campaign) {
  if (campaign == nullptr) return nullptr;
  const char* design = campaign->design == DesignKind::kMonteCarlo       ? "Monte Carlo"
                       : campaign->design == DesignKind::kLatinHypercube ? "Latin hypercube"
                                                                         : "Sobol";
  return {{"name", campaign->name},
          {"seed", std::to_string(campaign->seed)},
          {"planned", campaign->run_count()},
          {"design", campaign->dispersions.empty() ? "as listed" : design},
          {"file", campaign->name + ".yaml"}};
}

/// The judge's sentence, as the log's outcome has it.
std::string SentenceOf(const LoggedRun& log) {
  const bool told = log.outcome.is_object() && log.outcome.contains("failure_note");
  const Json note = told ? log.outcome["failure_note"] : Json();
  return note.is_string() ? note.get<std::string>() : "The log is cut short.";
}

ReplayFacts FactsOf(const ReportContent& content, const WatchedRun& watched, std::size_t scene,
                    const LoggedRun& log) {
  const RunResult& row = content.runs->results[watched.place];
  return {.run = row.run,
          .scene = scene,
          .outcome = row.outcome,
          .sentence = SentenceOf(log),
          .command = watched.command,
          .seed = std::to_string(row.seed),
          .state_hash = Hexadecimal(row.state_hash),
          .messages = watched.messages,
          .docked = row.docked,
          .channels = content.channels,
          .beliefs = content.beliefs,
          .pictures = content.pictures};
}

/// Replays as far as the file may be large. What is packed counts before the packing: pictures are
/// packed already.
void AddReplays(const ReportContent& content, Payload& payload, Json& header,
                std::vector<std::string>& left_out) {
  constexpr double kText = 4.0 / 3.0;  // of base64
  Scenes scenes(payload);
  Json replays = Json::array();
  std::size_t no_room = 0, largest = 0;
  for (const WatchedRun& watched : content.watched) {
    const int run = content.runs->results[watched.place].run;
    const auto after = static_cast<double>(payload.size() + largest) * kText;
    if (after > static_cast<double>(content.most_bytes)) {
      ++no_room;
      continue;
    }
    const std::size_t before = payload.size();
    try {
      const LoggedRun log = watched.log();
      const std::size_t scene = scenes.Add(watched.shapes());
      Json replay = ReplayPart(log, FactsOf(content, watched, scene, log), payload);
      if (!replay.is_null()) replays.push_back(std::move(replay));
    } catch (const DataError& error) {
      left_out.push_back("Run " + std::to_string(run) + " cannot be shown: " + error.what());
    } catch (const IoError& error) {
      left_out.push_back("Run " + std::to_string(run) + " cannot be shown: " + error.what());
    } catch (const ConfigError& error) {
      left_out.push_back("Run " + std::to_string(run) + " cannot be shown: " + error.what());
    }
    if (!replays.empty() && replays.size() > 1)
      largest = std::max(largest, payload.size() - before);
  }
  if (no_room > 0) {
    left_out.push_back(std::to_string(no_room) + " of " + std::to_string(content.watched.size()) +
                       " kept runs have no replay here: the file would be larger than " +
                       std::to_string(content.most_bytes >> 20) + " MiB.");
  }
  header["meshes"] = scenes.meshes();
  header["scenes"] = scenes.scenes();
  header["replays"] = std::move(replays);
}

/// The system's first headline measures, largest first.
Json Worst(const RowColumns& columns) {
  Json worst = Json::array({{{"column", "sim_time_s"}, {"largest", true}}});
  for (const Column& measure : columns.measures) {
    if (!measure.headline || worst.size() == 3) continue;
    worst.push_back({{"column", measure.name}, {"largest", true}});
  }
  return worst;
}

}  // namespace

std::string ReportPage(const ReportContent& content) {
  Payload payload;
  std::vector<std::string> left_out;
  Json header = OverviewPart(content.campaign, *content.runs, content.columns, content.aim);
  header["format"] = 1;
  header["title"] = content.title;
  header["program"] = content.program;
  header["campaign"] = CampaignJson(content.campaign);
  header["system"] = SystemJson(content);
  header["table"] = TablePart(*content.runs, content.columns, content.start, payload, left_out);
  header["worst"] = Worst(content.columns);
  if (!content.replay_command.empty()) header["replay_command"] = content.replay_command;
  AddReplays(content, payload, header, left_out);
  header["left_out"] = left_out;
  return PageWith(payload.Text(header));
}

}  // namespace dockyard
