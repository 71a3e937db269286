#include "sim/study/run_study.h"

#include <algorithm>
#include <memory>
#include <sstream>

#include "controller/base/check.h"
#include "models/random.h"
#include "sim/campaign/signal_queue.h"
#include "sim/log/result_row.h"
#include "sim/study/scripted_controller.h"

namespace dockyard {
namespace {

CampaignRun MakeRun(const Study& study, int index) {
  const int point = index / study.repeats;
  CampaignRun run;
  run.run = index + 1;
  run.region = "study";
  run.scenario = study.points[static_cast<std::size_t>(point)].scenario;
  run.scenario.seed = StudySeed(study, point, index % study.repeats);
  run.soil = std::filesystem::path(run.scenario.soil_file).stem().string();
  return run;
}

/// Outcome and measures in one line.
std::string Answer(const std::vector<ScriptStep>& script, const ControllerFactory& make_controller,
                   const CampaignRun& run) {
  try {
    const ControllerFactory scripted = [&](const std::string&, const RoverSheet& sheet) {
      return MakeScriptedController(sheet, script);
    };
    const RunRecord record =
        RunDocking(run, script.empty() ? make_controller : scripted, RunOptions{});
    std::string text = Name(record.result.outcome);
    for (const double measure : MeasuresOf(record)) text += " " + NumberText(measure);
    return text;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "run %d: %s\n", run.run, error.what());
    return "";
  }
}

StudyRow MakeRow(const Study& study, const CampaignRun& run, const std::string& answer) {
  StudyRow row;
  row.run = run.run;
  row.point = (run.run - 1) / study.repeats;
  row.seed = run.scenario.seed;
  row.outcome = Name(Outcome::kCrashed);
  std::istringstream words(answer);
  std::string word;
  if (words >> word) row.outcome = word;
  while (words >> word) {
    const auto number = NumberFromText(word);
    DOCKYARD_CHECK(number.has_value());
    row.measures.push_back(*number);
  }
  return row;
}

struct Running {
  CampaignRun run;
  std::unique_ptr<Child> child;
};

}  // namespace

bool StudyEnd::any_crashed() const {
  return std::any_of(rows.begin(), rows.end(),
                     [](const StudyRow& row) { return row.measures.empty(); });
}

std::uint64_t StudySeed(const Study& study, int point, int repeat) {
  const int place = point % study.grid_size();
  return RunSeed(study.seed, static_cast<std::uint64_t>(place * study.repeats + repeat + 1));
}

StudyEnd RunStudy(const Study& study, const ControllerFactory& make_controller,
                  const StudyOptions& options) {
  DOCKYARD_CHECK(options.jobs >= 1 && study.repeats >= 1);
  StudyEnd end;
  end.total = static_cast<int>(study.points.size()) * study.repeats;
  SignalQueue signals;
  std::vector<Running> running;
  int next = 0;
  while (end.signal == 0 && (next < end.total || !running.empty())) {
    while (next < end.total && static_cast<int>(running.size()) < options.jobs) {
      Running& one = running.emplace_back();
      one.run = MakeRun(study, next++);
      const auto& point = study.points[static_cast<std::size_t>((one.run.run - 1) / study.repeats)];
      const auto work = [&] { return Answer(point.script, make_controller, one.run); };
      const auto messages = options.out_dir / ("run_" + std::to_string(one.run.run) + ".txt");
      one.child = std::make_unique<Child>(work, messages, options.run_time_limit_s,
                                          std::vector<int>{signals.descriptor()});
    }
    std::vector<const Child*> children;
    for (const Running& one : running) children.push_back(one.child.get());
    WaitForChildren(children, signals);
    for (Running& one : running) {
      one.child->KillIfLate();
      if (!one.child->Read()) continue;
      end.rows.push_back(MakeRow(study, one.run, one.child->Finish().answer));
      one.child.reset();
      if (options.progress) options.progress(static_cast<int>(end.rows.size()), end.total);
    }
    running.erase(std::remove_if(running.begin(), running.end(),
                                 [](const Running& one) { return one.child == nullptr; }),
                  running.end());
    end.signal = signals.Take();
  }
  std::sort(end.rows.begin(), end.rows.end(),
            [](const StudyRow& a, const StudyRow& b) { return a.run < b.run; });
  return end;
}

}  // namespace dockyard
