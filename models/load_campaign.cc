#include <set>
#include <utility>

#include "models/config_error.h"
#include "models/csv_table.h"
#include "models/load_scenario.h"
#include "models/random.h"
#include "models/scenario_reader.h"

namespace dockyard {
namespace {

constexpr std::size_t kMaxRuns = 100000;

struct SoilFiles {
  std::vector<std::string> names, files;
};

SoilFiles ReadSoils(const YamlReader& root) {
  const YamlNode& node = root.Child("soils");
  if (node.kind != YamlNode::Kind::kMapping || node.keys.empty()) {
    root.Refuse("soils", "a mapping of names to soil files");
  }
  SoilFiles soils;
  for (const YamlNode::Key& key : node.keys) soils.names.push_back(key.name);
  const YamlReader in(node, root.PathOf("soils"), soils.names);
  for (const std::string& name : soils.names) soils.files.push_back(in.File(name));
  return soils;
}

/// What each run brings itself would be lost if it stood in the campaign's own keys. A base file
/// may have it: it is a scenario of its own.
void RefuseKeysOfRuns(const YamlNode& scenario, const std::string& path) {
  for (const YamlNode::Key& key : scenario.keys) {
    for (const char* of_runs : {"name", "soil", "light", "start", "seed"}) {
      if (key.name != of_runs) continue;
      throw ConfigError(key.place.Text() + ": " + path + "." + key.name +
                        ": expected only keys that all runs share; each run has its own " +
                        key.name);
    }
  }
}

/// The base: a scenario file, with the keys of `scenario` on top.
YamlNode BaseTree(const YamlReader& root) {
  if (root.Has("scenario")) RefuseKeysOfRuns(root.Child("scenario"), root.PathOf("scenario"));
  if (!root.Has("base") && !root.Has("scenario")) return root.Child("scenario");  // throws: missing
  if (!root.Has("base")) return root.Child("scenario");
  YamlNode base = LoadYaml(root.File("base"));
  if (root.Has("scenario")) MergeYaml(base, root.Child("scenario"));
  return base;
}

const std::vector<std::string>& RunColumns() {
  static const std::vector<std::string> columns{"run",   "day", "region",    "soil",
                                                "light", "r_m", "alpha_deg", "heading_deg"};
  return columns;
}

CampaignRun ReadRun(const YamlReader& in, const Campaign& campaign, const Scenario& base,
                    const SoilFiles& soils) {
  CampaignRun run;
  run.run = in.Integer("run", 0, 1000000);
  run.day = in.Integer("day", 0, 10000);
  const std::vector<std::string> regions{"interior", "boundary"};
  run.region = regions[static_cast<std::size_t>(in.Choice("region", regions))];
  const auto soil = static_cast<std::size_t>(in.Choice("soil", soils.names));
  run.soil = soils.names[soil];
  run.scenario = base;
  run.scenario.name = campaign.name + " run " + std::to_string(run.run);
  run.scenario.soil_file = soils.files[soil];
  run.scenario.light = static_cast<Light>(in.Choice("light", LightWords()));
  run.scenario.start = ReadStart(in);
  run.scenario.seed = RunSeed(campaign.seed, static_cast<std::uint64_t>(run.run));
  CheckStartInYard(run.scenario, in);
  return run;
}

void ReadRuns(const YamlNode& list, const std::string& path, const Scenario& base,
              const SoilFiles& soils, Campaign& campaign) {
  if (list.items.empty() || list.items.size() > kMaxRuns) {
    throw ConfigError(list.place.Text() + ": expected 1 to " + std::to_string(kMaxRuns) +
                      " runs, found " + std::to_string(list.items.size()));
  }
  std::set<int> seen;
  for (std::size_t i = 0; i < list.items.size(); ++i) {
    // A table's rows need no path: the file and line say where.
    const YamlReader in(list.items[i], path.empty() ? "" : YamlReader::PathOf(path, i),
                        RunColumns());
    campaign.runs.push_back(ReadRun(in, campaign, base, soils));
    if (!seen.insert(campaign.runs.back().run).second) {
      in.Refuse("run", "a number that no other run has");
    }
  }
}

}  // namespace

int CheckCampaignTable(const std::string& file) {
  const YamlNode table = LoadCsv(file);
  Campaign campaign;
  Scenario base;
  base.yard.length_m = base.yard.width_m = 1000.0;  // wide enough: the campaign's file has it
  SoilFiles soils;                                  // whatever the table names
  for (const YamlNode& row : table.items) {
    const YamlReader in(row, "", RunColumns());
    soils.names.push_back(in.Text("soil"));
    soils.files.push_back("");
  }
  ReadRuns(table, "", base, soils, campaign);
  return static_cast<int>(campaign.runs.size());
}

Campaign LoadCampaign(const std::string& file, const std::vector<std::string>& overrides) {
  YamlNode tree = LoadYaml(file);
  for (const std::string& assignment : overrides) SetYaml(tree, assignment);
  const YamlReader in(tree, "", {"campaign", "seed", "base", "scenario", "soils", "table", "runs"});
  Campaign campaign;
  campaign.name = in.Text("campaign");
  if (campaign.name.size() > 100 || campaign.name[0] == '.' ||
      campaign.name.find('/') != std::string::npos) {
    in.Refuse("campaign", "a name that its results folder can have: up to 100 bytes, no '/'");
  }
  campaign.file = file;
  campaign.seed = in.SeedOr("seed", 1);
  const YamlNode base_tree = BaseTree(in);
  const Scenario base =
      ReadScenario(base_tree, in.Has("base") ? "" : in.PathOf("scenario"), ScenarioPart::kBase);
  const SoilFiles soils = ReadSoils(in);
  if (in.Has("table") == in.Has("runs")) {
    throw ConfigError(tree.place.Text() + ": expected one of the keys 'table' and 'runs', found " +
                      (in.Has("table") ? "both" : "neither"));
  }
  if (in.Has("table")) {
    ReadRuns(LoadCsv(in.File("table")), "", base, soils, campaign);
  } else {
    ReadRuns(in.List("runs", 1, kMaxRuns), in.PathOf("runs"), base, soils, campaign);
  }
  campaign.resolved_yaml = ResolvedYaml(campaign);
  return campaign;
}

}  // namespace dockyard
