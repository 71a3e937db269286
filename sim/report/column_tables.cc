#include "sim/report/column_tables.h"

#include <algorithm>
#include <cstddef>

#include "sim/log/belief_error.h"

namespace dockyard {
namespace {

// Stand for columns with names of their own.
const Column kLabels{"[labels]", "",
                     "how the run was made, as text exactly as in the campaign's file or table; a "
                     "label with the name of another column is called `table.<name>`"};
const Column kMeasures{
    "[measures]", "",
    "the system's, below; empty for a run that crashed or was stopped, `nan` "
    "where a measure does not apply; at their end `margin.NAME` of each limit of the judge"};

ColumnTable Results() {
  return {
      "results.csv",
      "A row per run, in order of their numbers. The table `runs` of `results.sqlite` has the "
      "same columns: `seed` and `state_hash` are TEXT, as SQLite's integers end at 2^63; labels "
      "are numbers where they read as numbers; `nan` is NULL.",
      {{"run", "", "the run's number"},
       {"seed", "", "of the run's world, 64 bits without sign"},
       {"system", "", "name of the system"},
       {"controller", "", "name of the controller; `command` for a program"},
       kLabels,
       {"success", "", "1 or 0: whether the outcome is a success of the system"},
       {"success_word", "", "the outcome that the run's task asks for; empty for a lost run"},
       {"docked", "", "`success` by its former name"},
       {"outcome", "", "a name: [outcomes.md](outcomes.md)"},
       {"sim_time_s", "s",
        "simulated time, from the start to the last command; a docking is tried after it"},
       {"images", "", "images that the controller was given, all cameras together"},
       kMeasures,
       {"state_hash", "",
        "16 hexadecimal digits: fingerprint of commands and true state over the whole run"}}};
}

std::vector<Column> Times() {
  return {{"cpu_time_s", "s", "processor time of the run, without a controller's program"},
          {"wall_time_s", "s", "wall time of the run"},
          {"controller_cpu_s", "s",
           "processor time of the controller's program and of all that it started; 0 without one"},
          {"controller_wall_s", "s",
           "wall time that the run waited for the controller's program, its start and end "
           "included; 0 without one"}};
}

ColumnTable Timing() {
  return {"timing.csv", "Values that differ between computers, a row per run.", [] {
            std::vector<Column> columns = Times();
            columns.insert(columns.begin(), {"run", "", "the run's number"});
            return columns;
          }()};
}

/// The columns of results.csv, and five more.
ColumnTable Shards() {
  ColumnTable table{"shards/K-of-N.rows",
                    "A line per finished run, as it ended, after two lines of head: a check value "
                    "(CRC-32 of the rest, 8 hexadecimal digits), a comma, and these columns. A run "
                    "may have several lines ([run_log.md](run_log.md#shards)).",
                    Results().columns};
  for (const Column& column : Times()) table.columns.push_back(column);
  table.columns.push_back({"note", "", "what went wrong, a sentence for people"});
  return table;
}

ColumnTable Points() {
  return {"points.csv",
          "Of a campaign with a grid, arms, or keys set one at a time: a row per combination.",
          {{"[settings]", "",
            "labels of the combination: `arm`, the grid's keys, `changed`, "
            "`changed_to`"},
           {"runs", "", "runs of the combination"},
           {"success", "", "share of the runs that succeeded"},
           {"success_low", "", "lower end of its 95 % interval (Clopper and Pearson)"},
           {"success_high", "", "upper end"},
           {"docked", "", "`success` by its former name; likewise the next two"},
           {"docked_low", "", "lower end"},
           {"docked_high", "", "upper end"},
           {"[measure]_mean", "",
            "mean of `sim_time_s`, then of each measure, over the runs that "
            "have it; empty if none has"},
           {"[measure]_p10", "", "its 10 % quantile"},
           {"[measure]_p90", "", "its 90 % quantile"}}};
}

ColumnTable Sensitivities() {
  return {"sensitivity.csv",
          "Of a campaign with draws: a row per arm, measure and draw, the largest `eta` first. An "
          "empty cell cannot be told: the measure does not vary, or the runs are too few.",
          {{"arm", "", "name of the arm; empty without arms"},
           {"measure", "", "`success`, `sim_time_s` or a measure"},
           {"draw", "", "key that is drawn"},
           {"kind", "", "`numbers`, or `words`, which have no order and so no correlations"},
           {"runs", "", "runs that have the measure"},
           {"eta", "",
            "0 to 1: square root of the share of the measure's variation (of its ranks) "
            "that goes with the draw's level, of any shape, corrected for chance"},
           {"eta_p", "",
            "chance of so large an `eta`, or a larger, if the draw did not matter "
            "(Kruskal and Wallis)"},
           {"eta_p_holm", "",
            "the same for all draws of the measure together (Holm 1979): of draws that all do not "
            "matter, one has it below 0.05 in at most 5 % of campaigns"},
           {"rank_correlation", "", "Spearman's, -1 to 1: whether the measure rises or falls"},
           {"rank_correlation_low", "", "lower end of its 95 % interval (Bonett and Wright)"},
           {"rank_correlation_high", "", "upper end"},
           {"partial", "", "partial rank correlation: without what goes by the other draws"},
           {"partial_low", "", "lower end of its 95 % interval"},
           {"partial_high", "", "upper end"}}};
}

ColumnTable Levels() {
  return {"sensitivity_levels.csv",
          "Of a campaign with draws: a row per arm, draw and level. Numbers are cut into up to ten "
          "levels of as many runs.",
          {{"arm", "", "name of the arm; empty without arms"},
           {"draw", "", "key that is drawn"},
           {"word", "", "the level, of words"},
           {"low", "", "smallest number of the level, in the unit of the key"},
           {"high", "", "largest number of the level, in the unit of the key"},
           {"runs", "", "runs in the level"},
           {"success", "", "share of them that succeeded"},
           {"success_low", "", "lower end of its 95 % interval (Clopper and Pearson)"},
           {"success_high", "", "upper end"},
           {"docked", "", "`success` by its former name; likewise the next two"},
           {"docked_low", "", "lower end"},
           {"docked_high", "", "upper end"}}};
}

ColumnTable History() {
  ColumnTable table{
      "history.csv",
      "Of a run whose log is kept: truth and belief, 10 Hz and at the end, the judge's trial "
      "included.",
      {{"time_s", "s", "simulated time"},
       {"x_m", "m",
        "truth: `X_DR`, the robot in the target's frame D "
        "([frames](../contributing.md#frames))"},
       {"y_m", "m", "truth, likewise"},
       {"heading_deg", "deg", "truth, likewise"},
       {"z_m", "m", "truth, likewise: above the target's ground"},
       {"roll_DR_deg", "deg", "truth: roll of `X_DR` about moving axes, right side down positive"},
       {"pitch_DR_deg", "deg", "truth: its pitch, nose-down positive"},
       {"[channels]", "", "truth, by the system: below"},
       {"sensor.NAME", "",
        "each sensor that the system states by name, as the "
        "controller got it last; unit and period are in the log's header"},
       {"phase", "",
        "belief: state of the controller; `rest` and `shake` while the judge tries a claim"},
       {"located", "", "belief: 1 if the believed pose means anything yet"},
       {"believed_x_m", "m", "belief: `X_DR`"},
       {"believed_y_m", "m", "belief, likewise"},
       {"believed_heading_deg", "deg", "belief, likewise"},
       {"believed_z_m", "m", "belief, likewise; 0 of a controller that believes on the plane"},
       {"believed_roll_deg", "deg", "belief, likewise"},
       {"believed_pitch_deg", "deg", "belief, likewise"},
       {"sightings", "", "sightings of the target so far"},
       {"plans", "", "plans of the controller so far"},
       {"[beliefs]", "", "belief, by the system: below; `nan` if the controller gives none"}}};
  const std::vector<Column>& errors = BeliefErrorColumns();
  table.columns.insert(table.columns.end(), errors.begin(), errors.end());
  return table;
}

ColumnTable Values() {
  return {"values.csv",
          "Of a run whose log is kept, where its controller has values that the system does not "
          "name among its beliefs: a row at each time of history.csv, in the same order.",
          {{"time_s", "s", "simulated time"},
           {"[values]", "",
            "belief: each value by its name, in the order in which the names came; `nan` while the "
            "controller gives none. A value called `time_s` is called `value.time_s`"}}};
}

std::string MarkdownTable(const char* kind, const std::vector<Column>& columns) {
  std::string text = "| " + std::string(kind) + " | unit | meaning |\n|---|---|---|\n";
  for (const Column& column : columns) {
    text += "| `" + column.name + "` | " + column.unit + " | " + column.meaning + " |\n";
  }
  return text;
}

/// Lines of at most 120 columns.
std::string Wrapped(const std::string& text) {
  constexpr std::size_t kMost = 120;
  std::string wrapped, line;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t space = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, space - from);
    if (!line.empty() && line.size() + 1 + word.size() > kMost) {
      wrapped += line + "\n";
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
    from = space + 1;
  }
  return wrapped + line + "\n";
}

}  // namespace

std::vector<ColumnTable> ColumnTables() {
  return {Results(), Timing(), Shards(), Points(), Sensitivities(), Levels(), History(), Values()};
}

std::string ColumnsPage(const std::vector<SystemColumns>& systems) {
  std::string text =
      "# Columns\n\nThis page is printed by `dockyard columns`. Numbers are in the shortest form "
      "that reads back to the same bits.\nNames in brackets stand for columns that the campaign or "
      "the system names.\n";
  for (const ColumnTable& table : ColumnTables()) {
    text += "\n## " + table.file + "\n\n" + Wrapped(table.about) + "\n" +
            MarkdownTable("column", table.columns);
  }
  for (const SystemColumns& system : systems) {
    text += "\n## Of the system " + system.system + "\n";
    if (!system.measures.empty()) text += "\n" + MarkdownTable("measure", system.measures);
    if (!system.channels.empty()) text += "\n" + MarkdownTable("channel", system.channels);
    if (!system.beliefs.empty()) text += "\n" + MarkdownTable("belief", system.beliefs);
  }
  return text;
}

}  // namespace dockyard
