// Scenarios, campaigns, and tables of runs and of points.
#include <memory>

#include "fuzz/kind.h"
#include "models/read/csv_table.h"
#include "sim/app/check_file.h"
#include "sim/app/point_files.h"
#include "sim/app/scenario_options.h"
#include "sim/app/systems.h"
#include "sim/plan/make_run.h"
#include "sim/scenario/scenario_keys.h"
#include "support/bad_files.h"
#include "toy/toy_system.h"

namespace dockyard {
namespace {

std::function<std::vector<std::string>()> Files(const std::vector<std::string>& names) {
  return [names] {
    std::vector<std::string> bytes;
    for (const std::string& name : names) bytes.push_back(Slurp(SourceFile(name)));
    return bytes;
  };
}

/// The file as in the folder above: each of its paths has one step up less.
std::string OneFolderUp(std::string text) {
  for (std::size_t at = text.find("../"); at != std::string::npos; at = text.find("../", at)) {
    text.erase(at, 3);
    while (text.compare(at, 3, "../") == 0) at += 3;
  }
  return text;
}

std::vector<std::string> ScenarioWords() {
  std::vector<std::string> words{"../models/axel/axel.yaml",
                                 "../models/soils/loose_sand.yaml",
                                 "nan",
                                 ".inf",
                                 "1e308",
                                 "null",
                                 "{",
                                 "}",
                                 "[",
                                 "]",
                                 "- ",
                                 ": "};
  for (const KeyRow& row : ScenarioRows()) words.push_back(row.key);
  for (const std::string& light : LightWords()) words.push_back(light);
  return words;
}

std::vector<std::string> CampaignWords() {
  std::vector<std::string> words = ScenarioWords();
  for (const char* word : {"campaign",      "base",
                           "scenario",      "vary",
                           "arms",          "draw",
                           "correlate",     "design",
                           "runs",          "repeats",
                           "method",        "table",
                           "tags",          "limits",
                           "keep",          "none",
                           "all",           "figures",
                           "uniform",       "normal",
                           "loguniform",    "discrete",
                           "min",           "max",
                           "mean",          "sigma",
                           "values",        "weights",
                           "from",          "to",
                           "step",          "count",
                           "one_at_a_time", "latin_hypercube",
                           "sobol",         "monte_carlo",
                           "kind",          "std",
                           "rank",          "keys",
                           "panels",        "curves",
                           "measures",      "changes",
                           "as_built",      "truncate"}) {
    words.push_back(word);
  }
  return words;
}

/// What the campaigns in files leave out.
constexpr const char* kSpread = R"(campaign: spread
base: scenario.yaml
seed: 7
one_at_a_time: {time_limit_s: [10, 20]}
draw:
  start.alpha_deg: {normal: {mean: 0, std: 10, min: -40, max: 40}}
  start.r_m: {uniform: {min: 2, max: 3}}
  toy.speed_m_s: {loguniform: {min: 0.2, max: 2}}
  start.heading_deg: {discrete: {values: [-5, 0, 5], weights: [1, 2, 1]}}
correlate: [{keys: [start.r_m, start.alpha_deg], rank: 0.4}]
design: {kind: latin_hypercube, runs: 20}
)";

/// Folders laid out as in the source tree, with the models and both systems' base scenarios.
struct Tree {
  ScratchFolder folder;
  std::vector<System> systems = Systems();

  Tree() {
    for (const char* model : {"axel", "soils", "cameras", "boards"}) folder.CopyModel(model);
    folder.Write("scenarios/axel_typical.yaml", Slurp(SourceFile("scenarios/axel_typical.yaml")));
    folder.Write("scenarios/scenario.yaml", Slurp(SourceFile("tests/toy/scenario.yaml")));
    systems.push_back(toy::ToySystem());
  }
};

FuzzKind ScenarioKind() {
  const auto tree = std::make_shared<Tree>();
  return {"scenario", Files({"scenarios/axel_typical.yaml", "tests/toy/scenario.yaml"}),
          ScenarioWords(), [tree](const std::string& bytes) {
            const std::string file = tree->folder.Write("scenarios/fuzzed.yaml", bytes);
            return ReadOrRefused([&] { CheckFile(file, tree->systems); });
          }};
}

FuzzKind CampaignKind() {
  const auto tree = std::make_shared<Tree>();
  const auto files = Files({"scenarios/ci_4.yaml", "tests/toy/campaign.yaml", "tests/toy/arms.yaml",
                            "tests/toy/sweep.yaml"});
  const auto seeds = [files] {
    std::vector<std::string> all = files();
    all.push_back(OneFolderUp(Slurp(SourceFile("scenarios/studies/reel_alpha.yaml"))));
    all.push_back(kSpread);
    return all;
  };
  return {"campaign", seeds, CampaignWords(), [tree](const std::string& bytes) {
            const std::string file = tree->folder.Write("scenarios/fuzzed.yaml", bytes);
            return ReadOrRefused([&] { CheckFile(file, tree->systems); });
          }};
}

/// What a publication says, with its campaigns beside it.
FuzzKind PublishedKind() {
  const auto tree = std::make_shared<Tree>();
  for (const char* name : {"twelve.yaml", "campaign.yaml"}) {
    tree->folder.Write(std::string("scenarios/") + name,
                       Slurp(SourceFile(std::string("tests/toy/") + name)));
  }
  std::vector<std::string> words{"sightings", "errors",  "at_m",   "wrong_place_m", "within_m",
                                 "cases",     "methods", "others", "at_least",      "channels",
                                 "judged",    "[1, 2]",  "nan",    "1e308",         "{}"};
  return {"published", Files({"tests/toy/published.yaml", "tests/toy/published_never.yaml"}), words,
          [tree](const std::string& bytes) {
            const std::string file = tree->folder.Write("scenarios/fuzzed.yaml", bytes);
            return ReadOrRefused([&] { CheckFile(file, tree->systems); });
          }};
}

/// A table by itself, and as the table of a campaign.
FuzzKind TableKind() {
  const auto tree = std::make_shared<Tree>();
  const std::string yard = tree->folder.Write(
      "scenarios/yard.yaml",
      Replaced(Slurp(SourceFile("scenarios/mars_yard_40.yaml")), "mars_yard_40.csv", "fuzzed.csv"));
  std::vector<std::string> words = ScenarioWords();
  for (const char* word : {"\"", "\"\"", ",", "\r\n", "seed", "arm", "point", "repeat"}) {
    words.push_back(word);
  }
  return {"table", Files({"scenarios/mars_yard_40.csv", "tests/fuzz/small_table.csv"}), words,
          [tree, yard](const std::string& bytes) {
            const std::string file = tree->folder.Write("scenarios/fuzzed.csv", bytes);
            const bool alone = ReadOrRefused([&] { CheckFile(file, tree->systems); });
            const bool used = ReadOrRefused([&] { CheckFile(yard, tree->systems); });
            return alone || used;
          }};
}

FuzzKind PointsKind() {
  const auto folder = std::make_shared<ScratchFolder>();
  return {"points",
          Files({"examples/points.csv", "examples/frames.csv"}),
          {"camera", "left", "right", "u_px", "v_px", "x_m", "survey_error_m", "frame", "\"", ","},
          [folder](const std::string& bytes) {
            const std::string file = folder->Write("points.csv", bytes);
            bool read = false;
            for (const bool sequence : {false, true}) {
              read |= ReadOrRefused([&] { DefaultSurveyError(LoadPointFrames(file, sequence)); });
            }
            return read;
          }};
}

}  // namespace

std::vector<NamedKind> PlanKinds() {
  return {{"scenario", ScenarioKind},
          {"campaign", CampaignKind},
          {"published", PublishedKind},
          {"table", TableKind},
          {"points", PointsKind}};
}

}  // namespace dockyard
