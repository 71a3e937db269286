#include "sim/page/report_page.h"

#include <algorithm>
#include <cstdio>
#include <future>
#include <stdexcept>
#include <utility>

#include "sim/page/near_part.h"
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
          {"seed", std::to_string(campaign->seed.number)},
          {"planned", campaign->run_count()},
          {"design", campaign->dispersions.empty() ? "as listed" : design},
          {"file", "campaign.yaml"}};
}

/// The judge's sentence, as the log's outcome has it.
std::string SentenceOf(const LoggedRun& log) {
  const bool told = log.outcome.is_object() && log.outcome.contains("failure_note");
  const Json note = told ? log.outcome["failure_note"] : Json();
  return note.is_string() ? note.get<std::string>() : "The log is cut short.";
}

/// Images without a sighting that each run may keep: together they take half of the file, at most.
std::size_t MostImages(const ReportContent& content) {
  constexpr std::size_t kOfOne = 240, kLeast = 8;
  constexpr std::size_t kBytes = 16'000;  // of an image, packed, at most: 640 px wide
  const std::size_t all = content.most_bytes / 2 / kBytes;
  return std::clamp(all / std::max<std::size_t>(1, content.watched.size()), kLeast, kOfOne);
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
          .success = row.success,
          .channels = content.channels,
          .beliefs = content.beliefs,
          .pictures = content.pictures,
          .most_images = MostImages(content)};
}

/// Replays until the data are as large as they may be. They count before they are packed, which can
/// only make them smaller: images are packed already.
void AddReplays(const ReportContent& content, Payload& payload, Json& header,
                std::vector<std::string>& left_out) {
  constexpr double kBase64 = 4.0 / 3.0;
  Scenes scenes(payload);
  Json replays = Json::array();
  // The next log is read while this one is packed.
  const auto read = [&](std::size_t i) {
    return i < content.watched.size() ? std::async(std::launch::async, content.watched[i].log)
                                      : std::future<LoggedRun>();
  };
  std::future<LoggedRun> next = read(0);
  for (std::size_t i = 0; i < content.watched.size(); ++i) {
    const WatchedRun& watched = content.watched[i];
    std::future<LoggedRun> here = std::exchange(next, read(i + 1));
    try {
      const LoggedRun log = here.get();
      const StageShapes shapes = watched.shapes();
      const std::size_t scene = scenes.Add(shapes);
      const std::size_t before = payload.size();
      Json replay = ReplayPart(log, FactsOf(content, watched, scene, log), payload);
      if (!replay.is_null()) replay["near"] = NearPart(log, shapes, payload);
      if (kBase64 * static_cast<double>(payload.size()) > static_cast<double>(content.most_bytes)) {
        payload.CutTo(before);
        left_out.push_back(std::to_string(content.watched.size() - i) + " of " +
                           std::to_string(content.watched.size()) +
                           " kept runs have no replay here: the file would be larger than " +
                           std::to_string(content.most_bytes >> 20) + " MiB.");
        break;
      }
      if (!replay.is_null()) replays.push_back(std::move(replay));
    } catch (const std::runtime_error& error) {  // a damaged log costs its replay alone
      const int run = content.runs->results[watched.place].run;
      left_out.push_back("Run " + std::to_string(run) + " cannot be shown: " + error.what());
    }
  }
  header["meshes"] = scenes.meshes();
  header["scenes"] = scenes.scenes();
  header["replays"] = std::move(replays);
}

}  // namespace

std::string ReportPage(const ReportContent& content) {
  Payload payload;
  std::vector<std::string> left_out;
  Json header = OverviewPart(content.campaign, *content.runs, content.columns, content.aim,
                             content.requirements);
  header["format"] = 1;
  header["title"] = content.title;
  header["program"] = content.program;
  header["campaign"] = CampaignJson(content.campaign);
  header["system"] = SystemJson(content);
  header["table"] = TablePart(*content.runs, content.columns, content.starts, payload, left_out);
  // Of a measure no column says which end is the bad one; of the tightest limit it is the least.
  header["worst"] = Json::array({{{"column", "sim_time_s"}, {"largest", true}}});
  if (!header["limits"].empty()) {
    const std::string name = header["limits"][0]["name"];
    header["worst"].push_back({{"column", "margin." + name}, {"largest", false}});
  }
  if (!content.replay_command.empty()) header["replay_command"] = content.replay_command;
  AddReplays(content, payload, header, left_out);
  header["left_out"] = left_out;
  return PageWith(payload.Text(header));
}

}  // namespace dockyard
