// What runs leave behind: logs of frames, tables of results.
#include <cmath>
#include <cstdio>
#include <memory>
#include <sstream>

#include "controller/base/check.h"
#include "fuzz/kind.h"
#include "sim/app/scenario_options.h"
#include "sim/app/systems.h"
#include "sim/base/crc32.h"
#include "sim/bridge/answer_json.h"
#include "sim/bridge/program_belief.h"
#include "sim/campaign/merge.h"
#include "sim/campaign/shard_file.h"
#include "sim/log/result_row.h"
#include "sim/log/results.h"
#include "sim/log/run_log.h"
#include "sim/mcap/mcap_repair.h"
#include "sim/run/replay_log.h"
#include "sim/scenario/load_scenario.h"
#include "support/edited_log.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

/// A docking near the station, and all that it takes to feed its log to its controller again.
struct LoggedRun {
  ScratchFolder folder;
  std::vector<System> systems = Systems();
  Scenario scenario = LoadScenario(
      SourceFile("scenarios/axel_typical.yaml"),
      {"camera={width_px: 128, height_px: 96}", "start={r_m: 1.5, alpha_deg: 0, heading_deg: 0}"},
      KnownSystems(systems));
  const System& system = FindSystem(systems, scenario.system);
  ReadyRun ready = system.make_ready(scenario);
  RunOptions options{.log_dir = {}, .labels = {}, .results_dir = {}};

  /// The log of `count` calls of the controller, every tenth period, so that a short log comes past
  /// the first images.
  std::string Write(int count, bool keep_images) const {
    const ReadyRun run = system.make_ready(scenario);
    const auto controller = MakeController(system, SingleRun(scenario), run, options);
    RunLogWriter log(folder.path(), {.run = 1,
                                     .seed = scenario.seed.number,
                                     .system = system.name,
                                     .controller = scenario.controller,
                                     .images_kept = keep_images,
                                     .nominal = run.nominal});
    Commands commands;
    for (int i = 0; i < count; ++i) {
      SensorFrame sensed = run.plant->Sense();
      if (!commands.take_images.empty())
        sensed.images = run.plant->TakeImages(commands.take_images, commands.exposure_stops);
      commands = controller->Step(sensed);
      log.Append(sensed, commands);
      for (int period = 0; period < 10; ++period) run.plant->Advance(commands);
    }
    log.Append(PlanSample{0.1, {{{2.0, 0.1, 0.2}, -0.5, 0.3}}}, 1000);
    log.Finish({{"outcome", "docked"}});
    EditLog(
        folder.path() / kRunLogFile, [](McapAttachment&) {}, /*compress=*/false);
    return Slurp(folder.path() / kRunLogFile);
  }
};

/// Logs whose check values are right: else nothing but them would be tried. Of those that can be
/// read, the controller gets one in 50: that takes a hundred times longer.
FuzzKind LogKind() {
  constexpr int kReplayEvery = 50;
  const auto run = std::make_shared<LoggedRun>();
  const auto good = std::make_shared<int>(0);
  return {"log",
          [run] {
            return std::vector{run->Write(50, true), run->Write(50, false), run->Write(3, true)};
          },
          {"\"nominal\":", "\"system\":\"axel\"", "\"seed\":", "/dockyard/frame", "/tf",
           "/image/compressed", std::string("\0\1\0\0", 4), std::string("\0\0\0\0\0\0\xf8\x7f", 8),
           std::string("\0\0\0\0\0\0\xf0\x7f", 8)},
          [run, good](const std::string& bytes) {
            run->folder.Write(kRunLogFile, WithCheckValues(bytes));
            return ReadOrRefused([&] {
              RunLogReader all(run->folder.path());
              while (all.Next()) {
              }
              if (++*good % kReplayEvery != 1) return;
              RunLogReader log(run->folder.path());
              ReplayLog(log, run->system, SingleRun(run->scenario), run->ready, run->options);
            });
          }};
}

/// The container alone, compressed and not, and the repair of one that was cut short.
FuzzKind McapKind() {
  const auto folder = std::make_shared<ScratchFolder>();
  const std::string file = (folder->path() / "a.mcap").string();
  const auto seed = [folder, file](bool compress, bool finish) {
    McapWriter writer(file, {.profile = "ros2", .library = "a", .compress = compress});
    writer.Attach({1, 2, "a.json", "application/json", "{}"});
    const auto schema = writer.AddSchema("a/msg/B", "ros2msg", "float64 x");
    const auto channel = writer.AddChannel(schema, "/one", "cdr", {{"x", "m"}});
    for (std::uint32_t i = 0; i < 5; ++i) {
      writer.Write({channel, i, 600'000'000ull * i, 600'000'000ull * i, "message"});
    }
    writer.Add(McapMetadata{"a", {{"b", "c"}}});
    finish ? writer.Finish() : writer.Flush();
    return Slurp(file);
  };
  return {
      "mcap",
      [seed] {
        return std::vector{seed(false, true), seed(true, true), seed(true, false)};
      },
      {std::string(kMcapMagic), "zstd", "lz4", std::string("\xff\xff\xff\xff\xff\xff\xff\x7f", 8)},
      [folder, file](const std::string& bytes) {
        folder->Write("a.mcap", WithCheckValues(bytes));
        return ReadOrRefused([&] { RepairMcap(file); });
      }};
}

const std::vector<std::string> kCellWords{"nan", "inf", "1e308",   "-0",     "\"", "\"\"",
                                          ",",   "\n",  "crashed", "docked", "0",  "1"};

FuzzKind ResultsKind() {
  const auto folder = std::make_shared<ScratchFolder>();
  WriteResultsCsv(folder->path() / "results.csv", FakeResults(6), FakeColumns());
  return {"results",
          [results = Slurp(folder->path() / "results.csv")] { return std::vector{results}; },
          kCellWords,
          [](const std::string& bytes) {
            return ReadOrRefused([&] { RowsFromCsv(bytes, "results.csv", FakeColumns()); });
          }};
}

/// The lines of a shard without their check values, which are put back: else nothing but them would
/// be tried.
FuzzKind RowsKind() {
  const auto folder = std::make_shared<ScratchFolder>();
  const FinishedRuns runs = FakeResults(6);
  std::string lines = "{\"shard\": \"1-of-1\"}\n" + CsvHeader(FakeColumns()) +
                      ",cpu_time_s,wall_time_s,controller_cpu_s,"
                      "controller_wall_s,note\n";
  for (std::size_t i = 0; i < runs.size(); ++i) {
    lines += ShardRow({runs.results[i], runs.timings[i], runs.notes[i]}, FakeColumns()) + "\n";
  }
  return {"rows", [lines] { return std::vector{lines}; }, kCellWords,
          [folder](const std::string& bytes) {
            std::istringstream in(bytes);
            std::string checked;
            for (std::string line; std::getline(in, line);) {
              char check[16];
              std::snprintf(check, sizeof check, "%08x,", Crc32(line));
              checked += check + line + "\n";
            }
            folder->Write("shards/1-of-1.rows", checked);
            return ReadOrRefused(
                [&] { ReadShards(folder->path(), RowCheck::OfNoCampaign(), FakeColumns()); });
          }};
}

/// The beliefs of a controller's program, one a line, and what is kept of them.
FuzzKind BeliefKind() {
  const std::string line =
      R"({"phase": "mate", "note": "a", "x_m": 1, "y_m": -0.5, "heading_rad": 3, "values": )"
      R"({"a_m": 1e-3, "=b": 2}, "marks": [{"id": 3, "camera": 1, "u_px": 511.5, "v_px": 383}], )"
      R"("pose": {"R": [1, 0, 0, 0, 1, 0, 0, 0, 1], "p_m": [1, 2, 3]}})";
  return {
      "belief",
      [line] {
        return std::vector{line + "\n{}\n" + line, line};
      },
      {"\"marks\"", "\"pose\"", "\"values\"", "null", "[[[[", "1e308", "-1", "\\u001b", "\\u0085"},
      [](const std::string& bytes) {
        return ReadOrRefused([&] {
          ProgramBelief belief(2);
          std::istringstream in(bytes);
          for (std::string text; std::getline(in, text);) {
            belief.Take(AnswerFrom(text));
            belief.EndAnswer();
          }
          for (const unsigned char c : belief.belief().phase) {
            DOCKYARD_CHECK(c >= 0x20 && c != 0x7F);
          }
          for (const NamedValue& value : belief.belief().values) {
            DOCKYARD_CHECK(std::isfinite(value.value));
          }
        });
      }};
}

}  // namespace

std::vector<NamedKind> RecordKinds() {
  return {{"log", LogKind},
          {"mcap", McapKind},
          {"results", ResultsKind},
          {"rows", RowsKind},
          {"belief", BeliefKind}};
}

}  // namespace dockyard
