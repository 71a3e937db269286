#include "sim/study/run_study.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "controller/base/check.h"
#include "sim/base/random.h"
#include "sim/jobs/pool.h"
#include "sim/log/result_row.h"

namespace dockyard {
namespace {

CampaignRun MakeRun(const Study& study, int index) {
  const int point = index / study.repeats;
  CampaignRun run;
  run.run = index + 1;
  run.scenario = study.points[static_cast<std::size_t>(point)].scenario;
  run.scenario.seed = StudySeed(study, point, index % study.repeats);
  return run;
}

/// The run's row; nothing where it threw.
std::string Answer(const StudyRunFunction& simulate, const CampaignRun& run,
                   const RowColumns& columns) {
  try {
    return CsvRow(simulate(run).result, columns);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "run %d: %s\n", run.run, error.what());
    return "";
  }
}

StudyRow MakeRow(const Study& study, const CampaignRun& run, const std::string& answer,
                 const RowColumns& columns) {
  StudyRow row{run.run, (run.run - 1) / study.repeats, run.scenario.seed, kCrashed, {}};
  if (answer.empty()) return row;
  const auto result = RowFromCsv(answer, columns);
  DOCKYARD_CHECK(result && result->run == run.run);
  row.outcome = result->outcome;
  if (row.outcome != kCrashed) row.measures = MeasuresOf(*result);
  return row;
}

}  // namespace

bool StudyEnd::any_crashed() const {
  return std::any_of(rows.begin(), rows.end(),
                     [](const StudyRow& row) { return row.outcome == kCrashed; });
}

std::uint64_t StudySeed(const Study& study, int point, int repeat) {
  const int place = point % study.grid_size();
  return WorldSeed(study.seed, static_cast<std::uint64_t>(place),
                   static_cast<std::uint64_t>(repeat));
}

StudyEnd RunStudy(const Study& study, const StudyRunFunction& simulate, const RowColumns& columns,
                  const StudyOptions& options) {
  DOCKYARD_CHECK(study.repeats >= 1 && columns.labels.empty());
  CheckMeasures(study, columns);
  StudyEnd end;
  end.total = static_cast<int>(study.points.size()) * study.repeats;
  int started = 0;
  const auto next = [&]() -> std::optional<Job> {
    if (started == end.total) return std::nullopt;
    const CampaignRun run = MakeRun(study, started++);
    return Job{static_cast<std::size_t>(run.run - 1),
               [&simulate, &columns, run] { return Answer(simulate, run, columns); },
               options.out_dir / ("run_" + std::to_string(run.run) + ".txt")};
  };
  const auto take = [&](std::size_t index, const Child::End& child) {
    const CampaignRun run = MakeRun(study, static_cast<int>(index));
    end.rows.push_back(MakeRow(study, run, child.answer, columns));
    if (options.progress) options.progress(static_cast<int>(end.rows.size()), end.total);
  };
  SignalQueue signals;
  end.signal = RunPool({.processes = options.jobs, .time_limit_s = options.run_time_limit_s},
                       signals, next, take);
  std::sort(end.rows.begin(), end.rows.end(),
            [](const StudyRow& a, const StudyRow& b) { return a.run < b.run; });
  return end;
}

}  // namespace dockyard
