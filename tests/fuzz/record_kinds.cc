// What runs leave behind: logs of frames, tables of results.
#include <cstdio>
#include <memory>
#include <sstream>

#include "fuzz/kind.h"
#include "sim/app/scenario_options.h"
#include "sim/app/systems.h"
#include "sim/base/crc32.h"
#include "sim/campaign/merge.h"
#include "sim/campaign/shard_file.h"
#include "sim/log/result_row.h"
#include "sim/log/results.h"
#include "sim/log/run_log.h"
#include "sim/run/replay_log.h"
#include "sim/scenario/load_scenario.h"
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
  RunOptions options{.log_dir = {}, .labels = {}};

  /// The log of `count` calls of the controller, every tenth period, so that a short log comes past
  /// the first images.
  std::string Write(int count, bool keep_images) const {
    const ReadyRun run = system.make_ready(scenario);
    const auto controller = MakeController(system, scenario, run, options);
    RunLogWriter log(folder.path(), {.run = 1,
                                     .seed = scenario.seed,
                                     .system = system.name,
                                     .controller = scenario.controller,
                                     .images_kept = keep_images,
                                     .nominal = run.nominal});
    Commands commands;
    for (int i = 0; i < count; ++i) {
      SensorFrame sensed = run.plant->Sense();
      if (!commands.take_images.empty())
        sensed.images = run.plant->TakeImages(commands.take_images);
      commands = controller->Step(sensed);
      log.Append(sensed, commands);
      for (int period = 0; period < 10; ++period) run.plant->Advance(commands);
    }
    log.Finish();
    return Slurp(folder.path() / "frames.bin");
  }
};

FuzzKind LogKind() {
  const auto run = std::make_shared<LoggedRun>();
  return {"log",
          [run] {
            return std::vector{run->Write(50, true), run->Write(50, false), run->Write(3, true)};
          },
          {"DOCKLOG\n", "\"nominal\":", "\"system\":\"axel\"", "\"seed\":", "H", "F", "E",
           std::string("\0\0\0\0\0\0\xf8\x7f", 8), std::string("\0\0\0\0\0\0\xf0\x7f", 8)},
          [run](const std::string& bytes) {
            run->folder.Write("frames.bin", bytes);
            return ReadOrRefused([&] {
              RunLogReader log(run->folder.path());
              ReplayLog(log, run->system, run->scenario, run->ready, run->options);
            });
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
  std::string lines =
      "{\"shard\": \"1-of-1\"}\n" + CsvHeader(FakeColumns()) + ",cpu_time_s,wall_time_s,note\n";
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
            return ReadOrRefused([&] { ReadShards(folder->path(), FakeColumns()); });
          }};
}

}  // namespace

std::vector<NamedKind> RecordKinds() {
  return {{"log", LogKind}, {"results", ResultsKind}, {"rows", RowsKind}};
}

}  // namespace dockyard
