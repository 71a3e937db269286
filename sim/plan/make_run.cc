#include "sim/plan/make_run.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "controller/base/check.h"
#include "models/read/config_error.h"
#include "sim/base/random.h"
#include "sim/base/text.h"
#include "sim/scenario/key_path.h"
#include "sim/scenario/scenario_keys.h"

namespace dockyard {
namespace {

std::vector<std::string> KeysOf(const std::vector<Dispersion>& dispersions) {
  std::vector<std::string> keys;
  for (const Dispersion& dispersion : dispersions) keys.push_back(dispersion.key.name);
  return keys;
}

void Put(const YamlNode::Key& key, const YamlNode& value, YamlNode* tree) {
  if (tree != nullptr) PutPath(*tree, key.name, key.place, value);
}

const YamlNode* CellOf(const RunTable& table, std::int64_t row, const char* column) {
  const auto at = table.Find(column);
  if (!at) return nullptr;
  return &table.rows[static_cast<std::size_t>(row)].cells[*at];
}

[[noreturn]] void RefuseCell(const YamlNode& cell, const std::string& column,
                             const std::vector<std::string>& known) {
  throw ConfigError(cell.place.Text() + ": " + column + ": expected one of " + Listed(known) +
                    ", found " + cell.Found());
}

/// The place of the cell's text among the labels; throws ConfigError that names all.
std::size_t LevelOf(const YamlNode& cell, const std::string& column,
                    const std::vector<std::string>& labels) {
  const auto at = std::find(labels.begin(), labels.end(), CellText(cell));
  if (at == labels.end()) RefuseCell(cell, column, labels);
  return static_cast<std::size_t>(at - labels.begin());
}

std::uint64_t SeedCell(const YamlNode& cell) {
  std::uint64_t seed = 0;
  const std::string& text = cell.scalar;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || text.empty()) {
    throw ConfigError(cell.place.Text() + ": seed: expected a whole number from 0 to 2^64 - 1, " +
                      "found " + cell.Found());
  }
  return seed;
}

/// The draw as a scalar of YAML: its text reads back to the same bits.
YamlNode Drawn(const Dispersion& dispersion, double u) {
  if (dispersion.discrete()) {
    return dispersion.values.values[Pick(dispersion.weights, u)];
  }
  YamlNode value = ScalarNode(NumberText(Quantile(dispersion.distribution, u)), false);
  value.place = dispersion.key.place;
  return value;
}

}  // namespace

/// Where a run stands in its campaign, every part counted from 0.
struct RunMaker::Place {
  std::int64_t point = 0;   // of point_count()
  std::int64_t row = 0;     // of the table
  std::int64_t grid = 0;    // of the grid
  std::int64_t change = 0;  // of the values set alone; 0: none
  std::int64_t repeat = 0;
  std::size_t arm = 0;
};

RunMaker::RunMaker(const Campaign& campaign, const std::vector<KnownSystem>& systems)
    : campaign_(campaign),
      systems_(systems),
      design_(campaign.design, static_cast<std::uint64_t>(campaign.repeats), campaign.seed,
              KeysOf(campaign.dispersions)) {
  if (!campaign.numbered_by_table()) return;
  for (const RunTable::Row& row : campaign.table.rows) {
    rows_.emplace(row.run, static_cast<std::int64_t>(rows_.size()));
  }
}

RunMaker::Place RunMaker::PlaceOf(std::int64_t index) const {
  DOCKYARD_CHECK(index >= 0 && index < campaign_.run_count());
  const std::int64_t arms = campaign_.arm_count();
  Place place;
  place.arm = static_cast<std::size_t>(index % arms);
  place.repeat = index / arms % campaign_.repeats;
  place.point = index / arms / campaign_.repeats;
  place.grid = place.point % campaign_.grid_size();
  place.row = place.point / campaign_.grid_size() % campaign_.row_count();
  place.change = place.point / campaign_.grid_size() / campaign_.row_count();
  return place;
}

int RunMaker::Number(std::int64_t index) const {
  if (!campaign_.numbered_by_table()) return static_cast<int>(index) + 1;
  return campaign_.table.rows[static_cast<std::size_t>(PlaceOf(index).row)].run;
}

std::int64_t RunMaker::IndexOf(int number) const {
  if (!campaign_.numbered_by_table()) {
    return number >= 1 && number <= campaign_.run_count() ? number - 1 : -1;
  }
  const auto row = rows_.find(number);
  return row == rows_.end() ? -1 : row->second;
}

/// Rows count by their numbers in the table, so that a row keeps its seed when others come or go.
std::uint64_t RunMaker::WorldPlace(const Place& place) const {
  const auto grid = static_cast<std::uint64_t>(place.grid);
  if (campaign_.table.rows.empty()) return grid;
  const int row = campaign_.table.rows[static_cast<std::size_t>(place.row)].run;
  return (grid << 32) + static_cast<std::uint64_t>(row);
}

Seed RunMaker::SeedAt(const Place& place) const {
  if (const YamlNode* cell = CellOf(campaign_.table, place.row, "seed")) {
    return {SeedCell(*cell), campaign_.seed.secret};
  }
  return WorldSeed(campaign_.seed, WorldPlace(place), static_cast<std::uint64_t>(place.repeat));
}

std::optional<std::uint64_t> RunMaker::SeedNumber(std::int64_t index) const {
  const Place place = PlaceOf(index);
  const bool by_table = CellOf(campaign_.table, place.row, "seed") != nullptr;
  if (campaign_.is_hidden() && !by_table) return std::nullopt;
  return SeedAt(place).number;
}

void RunMaker::SetArm(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const {
  if (campaign_.arms.empty()) return;
  std::size_t chosen = place.arm;
  if (const YamlNode* cell = CellOf(campaign_.table, place.row, "arm")) {
    std::vector<std::string> names;
    for (const Arm& arm : campaign_.arms) names.push_back(arm.name);
    chosen = LevelOf(*cell, "arm", names);
  }
  labels.push_back(campaign_.arms[chosen].name);
  for (const KeyValue& set : campaign_.arms[chosen].sets) Put(set.key, set.value, tree);
}

void RunMaker::SetRow(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const {
  if (campaign_.table.rows.empty()) return;
  const RunTable::Row& row = campaign_.table.rows[static_cast<std::size_t>(place.row)];
  for (std::size_t i = 0; i < row.cells.size(); ++i) {
    const YamlNode::Key& column = campaign_.table.columns[i];
    if (IsPlanColumn(column.name)) continue;
    const YamlNode& cell = row.cells[i];
    if (IsTag(campaign_, column.name)) {
      labels.push_back(cell.scalar);
      continue;
    }
    const auto named =
        std::find_if(campaign_.named.begin(), campaign_.named.end(),
                     [&](const Factor& factor) { return factor.key.name == column.name; });
    const YamlNode& value = named == campaign_.named.end()
                                ? cell
                                : named->values[LevelOf(cell, column.name, named->labels)];
    Put(column, value, tree);
    if (!TellsController(column.name, named == campaign_.named.end() ? nullptr : &*named)) {
      labels.push_back(CellText(cell));
    }
  }
}

void RunMaker::SetGrid(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const {
  std::int64_t rest = place.grid;
  for (const Factor& factor : campaign_.grid) {
    const auto count = static_cast<std::int64_t>(factor.values.size());
    const auto level = static_cast<std::size_t>(rest % count);
    rest /= count;
    Put(factor.key, factor.values[level], tree);
    if (!TellsController(factor.key.name, &factor)) labels.push_back(factor.labels[level]);
  }
}

void RunMaker::SetChange(const Place& place, YamlNode* tree,
                         std::vector<std::string>& labels) const {
  if (campaign_.one_at_a_time.empty()) return;
  const Factor* factor = nullptr;
  std::size_t level = 0;
  const YamlNode* changed = CellOf(campaign_.table, place.row, "changed");
  if (changed != nullptr && changed->kind != YamlNode::Kind::kNull) {
    std::vector<std::string> keys;
    for (const Factor& each : campaign_.one_at_a_time) keys.push_back(each.key.name);
    factor = &campaign_.one_at_a_time[LevelOf(*changed, "changed", keys)];
    level =
        LevelOf(*CellOf(campaign_.table, place.row, "changed_to"), "changed_to", factor->labels);
  } else if (changed == nullptr && place.change > 0) {
    std::int64_t rest = place.change - 1;
    for (const Factor& each : campaign_.one_at_a_time) {
      const auto count = static_cast<std::int64_t>(each.values.size());
      factor = &each;
      level = static_cast<std::size_t>(rest);
      if (rest < count) break;
      rest -= count;
    }
  }
  if (factor != nullptr) Put(factor->key, factor->values[level], tree);
  labels.push_back(factor == nullptr ? "" : factor->key.name);
  labels.push_back(factor == nullptr ? "" : factor->labels[level]);
}

void RunMaker::Draw(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const {
  std::vector<double> uniforms;
  for (std::size_t i = 0; i < campaign_.dispersions.size(); ++i) {
    uniforms.push_back(
        design_.Uniform(i, WorldPlace(place), static_cast<std::uint64_t>(place.repeat)));
  }
  if (campaign_.correlation) campaign_.correlation->Apply(uniforms);
  for (std::size_t i = 0; i < uniforms.size(); ++i) {
    const Dispersion& dispersion = campaign_.dispersions[i];
    const YamlNode value = Drawn(dispersion, uniforms[i]);
    Put(dispersion.key, value, tree);
    labels.push_back(dispersion.discrete()
                         ? dispersion.values.labels[Pick(dispersion.weights, uniforms[i])]
                         : value.scalar);
  }
}

void RunMaker::SetAll(const Place& place, YamlNode* tree, std::vector<std::string>& labels) const {
  SetArm(place, tree, labels);
  const auto told = [&](const char* column, std::int64_t value) {
    const YamlNode* cell = CellOf(campaign_.table, place.row, column);
    labels.push_back(cell != nullptr ? CellText(*cell) : std::to_string(value + 1));
  };
  if (campaign_.has_points()) told("point", place.point);
  if (campaign_.has_repeats()) told("repeat", place.repeat);
  SetRow(place, tree, labels);
  SetGrid(place, tree, labels);
  SetChange(place, tree, labels);
  Draw(place, tree, labels);
}

std::vector<std::string> RunMaker::Labels(std::int64_t index) const {
  std::vector<std::string> labels;
  SetAll(PlaceOf(index), nullptr, labels);
  return labels;
}

CampaignRun RunMaker::Make(std::int64_t index) const {
  if (campaign_.is_hidden()) {
    throw ConfigError(campaign_.name +
                      ": its worlds are sealed: expected its secret, --secret FILE");
  }
  const Place place = PlaceOf(index);
  CampaignRun run;
  run.run = Number(index);
  YamlNode tree = campaign_.base;
  SetAll(place, &tree, run.labels);
  PutPath(tree, "name", {}, ScalarNode(campaign_.name + " run " + std::to_string(run.run), true));
  RemovePath(tree, "seed");  // the base's own
  run.scenario = ReadScenario(tree, systems_);
  run.scenario.seed = SeedAt(place);
  return run;
}

}  // namespace dockyard
