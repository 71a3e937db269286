#include <algorithm>
#include <filesystem>
#include <utility>

#include "models/read/config_error.h"
#include "models/read/csv_table.h"
#include "models/read/near_names.h"
#include "models/read/text_file.h"
#include "models/read/yaml_reader.h"
#include "sim/plan/campaign.h"
#include "sim/plan/campaign_keys.h"
#include "sim/plan/check_campaign.h"
#include "sim/plan/spread_words.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/other_file_kind.h"
#include "sim/scenario/scenario_keys.h"
#include "sim/scenario/short_forms.h"

namespace dockyard {
namespace {

[[noreturn]] void RefuseKey(const YamlNode::Key& key, const std::string& path,
                            const std::string& expected) {
  throw ConfigError(key.place.Text() + ": " + path + ": expected " + expected);
}

void RefuseFormerKeys(const YamlNode& tree) {
  static const std::vector<std::pair<std::string, std::string>> former{
      {"study", "campaign: NAME; a study is a campaign"},
      {"repeats", "design: {runs: N} instead"},
      {"plot", "figures instead"},
      {"soils", "vary: {soil: {NAME: FILE, ...}} instead"},
      {"values", "vary instead"}};
  for (const YamlNode::Key& key : tree.keys) {
    for (const auto& [name, now] : former) {
      if (key.name == name) RefuseKey(key, name, now);
    }
  }
}

/// A scenario has its system and its start at the top, a campaign neither.
void RefuseScenario(const YamlNode& tree, const std::string& file) {
  const bool scenario = tree.Find("system") != nullptr && tree.Find("start") != nullptr;
  if (!scenario || tree.Find("campaign") != nullptr) return;
  throw OtherFileKind(tree.place.Text() + ": expected a campaign, found one scenario", "run", file);
}

/// The base: a scenario file, with the keys of `scenario` and `script` on top.
YamlNode BaseTree(const YamlReader& root) {
  if (root.Has("scenario") && root.Child("scenario").kind != YamlNode::Kind::kMapping) {
    throw ConfigError(root.Child("scenario").place.Text() +
                      ": scenario: expected a mapping of keys; a scenario's file is named by base");
  }
  YamlNode base = root.Has("base") ? LoadYaml(root.File("base")) : root.Child("scenario");
  if (root.Has("base") && root.Has("scenario")) MergeYaml(base, root.Child("scenario"));
  if (root.Has("script")) {
    PutPath(base, "script", root.Child("script").place, root.Child("script"));
  }
  return base;
}

RunTable ReadTableOf(const YamlReader& in, const YamlNode& tree) {
  if (in.Has("table") && in.Has("runs")) {
    throw ConfigError(tree.place.Text() +
                      ": expected one of the keys 'table' and 'runs', found both");
  }
  if (in.Has("table")) return ReadTable(LoadCsv(in.File("table")), "");
  if (in.Has("runs")) return ReadTable(in.List("runs", 0, 1u << 30), in.PathOf("runs"));
  return {};
}

void ReadTags(const YamlReader& in, Campaign& campaign) {
  if (!in.Has("tags")) return;
  for (const YamlNode& tag : in.List("tags", 1, 100).items) {
    const auto column = campaign.table.Find(tag.scalar);
    if (!column) {
      std::vector<std::string> columns;
      for (const YamlNode::Key& each : campaign.table.columns) columns.push_back(each.name);
      throw ConfigError(tag.place.Text() + ": tags: expected a column of the table, found " +
                        tag.Found() + DidYouMean(tag.scalar, columns));
    }
    campaign.tags.push_back(tag.scalar);
    for (const RunTable::Row& row : campaign.table.rows) {
      if (row.cells[*column].kind != YamlNode::Kind::kScalar) {
        throw ConfigError(row.cells[*column].place.Text() + ": " + tag.scalar +
                          ": expected a value, found " + row.cells[*column].Found());
      }
      if (const auto control = FirstControl(row.cells[*column].scalar)) {
        throw ConfigError(row.cells[*column].place.Text() + ": " + tag.scalar +
                          ": expected one line without control characters, found " +
                          CharacterName(*control));
      }
    }
  }
}

/// Factors that the table has a column of name its values; the rest is the grid.
void ReadVary(const YamlReader& in, Campaign& campaign) {
  for (Factor& factor : ReadFactors(in, "vary")) {
    const std::string& key = factor.key.name;
    if (IsTag(campaign, key)) RefuseKey(factor.key, "vary." + key, "none; it is a tag");
    (campaign.table.Find(key) ? campaign.named : campaign.grid).push_back(std::move(factor));
  }
}

/// The factor with the column's other cells as values of their own.
void AddOtherCells(const RunTable& table, std::size_t column, Factor& factor) {
  for (const RunTable::Row& row : table.rows) {
    const std::string text = CellText(row.cells[column]);
    if (std::find(factor.labels.begin(), factor.labels.end(), text) != factor.labels.end())
      continue;
    factor.labels.push_back(text);
    factor.values.push_back(row.cells[column]);
  }
}

/// A table's column of a discrete draw may hold the draw's names, as --dry-run prints them. Files
/// are then those of the draw, wherever the table lies.
void NameDrawnValues(const YamlReader& in, Campaign& campaign) {
  if (!in.Has("draw")) return;
  const YamlNode& draw = in.Child("draw");
  for (std::size_t i = 0; i < draw.keys.size(); ++i) {
    const YamlNode::Key& key = draw.keys[i];
    const auto column = campaign.table.Find(key.name);
    const auto same = [&](const Factor& factor) { return factor.key.name == key.name; };
    if (!column || draw.items[i].Find("discrete") == nullptr || IsTag(campaign, key.name) ||
        std::any_of(campaign.named.begin(), campaign.named.end(), same)) {
      continue;
    }
    Factor values = ReadDispersion(key, draw.items[i]).values;
    AddOtherCells(campaign.table, *column, values);
    campaign.named.push_back(std::move(values));
  }
}

void ReadArms(const YamlReader& in, Campaign& campaign) {
  if (!in.Has("arms")) return;
  const YamlNode& arms = in.Child("arms");
  if (arms.kind != YamlNode::Kind::kMapping || arms.keys.empty()) {
    in.Refuse("arms", "names, each with the keys that it sets");
  }
  for (std::size_t i = 0; i < arms.keys.size(); ++i) {
    const std::string path = "arms." + arms.keys[i].name;
    const YamlNode& sets = arms.items[i];
    if (sets.kind != YamlNode::Kind::kMapping) {
      throw ConfigError(sets.place.Text() + ": " + path +
                        ": expected keys of the scenario with their values, found " + sets.Found());
    }
    Arm arm{arms.keys[i].name, {}};
    for (std::size_t k = 0; k < sets.keys.size(); ++k) {
      RequireSettable(sets.keys[k], path + "." + sets.keys[k].name);
      arm.sets.push_back({sets.keys[k], sets.items[k]});
    }
    campaign.arms.push_back(std::move(arm));
  }
}

void ReadDesign(const YamlReader& root, Campaign& campaign) {
  if (!root.Has("design")) return;
  const YamlReader in(root.Child("design"), "design", {"kind", "runs"});
  campaign.design = static_cast<DesignKind>(in.ChoiceOr("kind", 0, DesignWords()));
  campaign.repeats = in.IntegerOr("runs", 1, 1, 1000000000);
  if (campaign.design != DesignKind::kMonteCarlo && campaign.dispersions.empty()) {
    in.Refuse("kind", "keys in draw for this design");
  }
  if (campaign.design == DesignKind::kSobol && campaign.dispersions.size() > kSobolDimensions) {
    in.Refuse("kind", "at most " + std::to_string(kSobolDimensions) + " keys in draw");
  }
}

void AddLabels(Campaign& campaign) {
  std::vector<std::string>& labels = campaign.labels;
  const auto add = [&](const std::string& key, const Factor* named) {
    if (TellsController(key, named)) {
      campaign.sets_controller = true;
    } else {
      labels.push_back(key);
    }
  };
  if (!campaign.arms.empty()) labels.push_back("arm");
  if (campaign.has_points()) labels.push_back("point");
  if (campaign.has_repeats()) labels.push_back("repeat");
  for (const YamlNode::Key& column : campaign.table.columns) {
    if (IsPlanColumn(column.name)) continue;
    const auto named =
        std::find_if(campaign.named.begin(), campaign.named.end(),
                     [&](const Factor& factor) { return factor.key.name == column.name; });
    add(column.name, named == campaign.named.end() ? nullptr : &*named);
  }
  for (const Factor& factor : campaign.grid) add(factor.key.name, &factor);
  if (!campaign.one_at_a_time.empty()) labels.insert(labels.end(), {"changed", "changed_to"});
  for (const Dispersion& dispersion : campaign.dispersions) labels.push_back(dispersion.key.name);
}

void ReadFigures(const YamlReader& root, const std::vector<std::string>& measures,
                 Campaign& campaign) {
  campaign.figures.measures = {"success"};
  // Nothing: of a campaign's file whose figures are taken out, with --set figures=.
  if (!root.Has("figures") || root.Child("figures").kind == YamlNode::Kind::kNull) return;
  const YamlReader in(root.Child("figures"), "figures", {"x", "curves", "panels", "measures"});
  std::vector<std::string> labels = campaign.labels;
  if (campaign.sets_controller) labels.push_back("controller");
  const auto label = [&](const char* key) {
    return in.Has(key) ? labels[static_cast<std::size_t>(in.Choice(key, labels))] : std::string();
  };
  campaign.figures.x = label("x");
  campaign.figures.curves = label("curves");
  campaign.figures.panels = label("panels");
  if (!in.Has("measures")) return;
  campaign.figures.measures.clear();
  for (const YamlNode& item : in.List("measures", 1, 8).items) {
    const std::string name = item.scalar == "docked" ? "success" : item.scalar;  // its former name
    if (std::find(measures.begin(), measures.end(), name) == measures.end()) {
      const std::string near = NearestName(item.scalar, measures);
      throw ConfigError(item.place.Text() +
                        ": figures.measures: expected a column of results.csv, found " +
                        item.Found() + (near.empty() ? "" : "; nearest is '" + near + "'"));
    }
    campaign.figures.measures.push_back(name);
  }
}

std::string NameOf(const YamlReader& in) {
  const std::string name = in.Text("campaign");
  if (name.size() > 100 || name[0] == '.' || name.find('/') != std::string::npos) {
    in.Refuse("campaign", "a name that its results folder can have: up to 100 bytes, no '/'");
  }
  return name;
}

/// Logs of a whole large campaign would fill a disk.
Keep ReadKeep(const YamlReader& root, std::int64_t runs) {
  constexpr std::int64_t kFewRuns = 100;
  const Keep of_many{20, 50, true};
  if (!root.Has("keep")) return runs <= kFewRuns ? Keep{} : of_many;
  if (root.Child("keep").kind != YamlNode::Kind::kMapping) {
    return root.Choice("keep", {"all", "none"}) == 0 ? Keep{} : Keep::None();
  }
  const YamlReader in(root.Child("keep"), "keep",
                      {"failures_per_cause", "every_nth_success", "pictures", "sightings"});
  constexpr int kMost = 1000000000;
  return {
      in.IntegerOr("failures_per_cause", static_cast<int>(of_many.failures_per_cause), 0, kMost),
      in.IntegerOr("every_nth_success", static_cast<int>(of_many.every_nth_success), 0, kMost),
      in.BoolOr("pictures", true), in.BoolOr("sightings", false)};
}

RunLimits ReadLimits(const YamlReader& root) {
  RunLimits limits;
  if (!root.Has("limits")) return limits;
  const YamlReader in(root.Child("limits"), "limits", {"wall_s", "memory_mib", "retries"});
  limits.wall_s = in.NumberOr("wall_s", limits.wall_s, Between(0.001, 1e6));
  limits.memory_mib = in.IntegerOr("memory_mib", static_cast<int>(limits.memory_mib), 64, 1 << 24);
  limits.retries = in.IntegerOr("retries", limits.retries, 0, 10);
  return limits;
}

/// A table made by --dry-run holds all that the file draws and repeats: nothing is drawn again.
void LeaveToTable(Campaign& campaign, const YamlReader& in) {
  if (campaign.table.Find("repeat")) campaign.repeats = 1;
  auto& dispersions = campaign.dispersions;
  const std::size_t before = dispersions.size();
  dispersions.erase(std::remove_if(dispersions.begin(), dispersions.end(),
                                   [&](const Dispersion& each) {
                                     return campaign.table.Find(each.key.name).has_value();
                                   }),
                    dispersions.end());
  if (dispersions.size() == before || !campaign.correlation) return;
  if (!dispersions.empty()) in.Refuse("correlate", "a table with all keys of draw, or with none");
  campaign.correlation.reset();
}

}  // namespace

Campaign LoadCampaign(const std::string& file, const std::vector<std::string>& overrides,
                      const CampaignSystems& systems) {
  Campaign campaign;
  campaign.tree = LoadYaml(file);
  for (const std::string& assignment : overrides) SetYaml(campaign.tree, assignment);
  RefuseFormerKeys(campaign.tree);
  RefuseScenario(campaign.tree, file);
  const YamlReader in(campaign.tree, "", CampaignKeyNames());
  campaign.name = NameOf(in);
  campaign.file = file;
  campaign.seed = in.SeedOr("seed", 1);
  campaign.base = WithoutShortForms(BaseTree(in), systems.known);
  campaign.table = ReadTableOf(in, campaign.tree);
  ReadTags(in, campaign);
  ReadArms(in, campaign);
  ReadVary(in, campaign);
  campaign.one_at_a_time = ReadFactors(in, "one_at_a_time");
  NameDrawnValues(in, campaign);
  WriteSpreads(campaign, systems.known);
  campaign.dispersions = ReadDispersions(in);
  ReadDesign(in, campaign);
  campaign.limits = ReadLimits(in);
  campaign.correlation = ReadCorrelation(in, campaign.dispersions);
  LeaveToTable(campaign, in);
  CheckWhole(campaign, in, systems.known);
  campaign.keep = ReadKeep(in, campaign.run_count());
  AddLabels(campaign);
  const YamlNode* system = campaign.base.Find("system");
  const bool named = system != nullptr && systems.measures;
  ReadFigures(in, named ? systems.measures(system->scalar) : std::vector<std::string>(), campaign);
  return campaign;
}

}  // namespace dockyard
