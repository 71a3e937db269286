#include "sim/axel/grid_plot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "controller/base/number_text.h"
#include "sim/axel/axel_columns.h"
#include "sim/axel/run_plots.h"
#include "sim/report/svg.h"

namespace dockyard::axel {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Why the text is not well-formed XML, or none: tags nest and close, attributes are quoted, no
/// stray < & or >.
std::optional<std::string> XmlFault(const std::string& text) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '&') {
      const std::size_t end = text.find(';', i);
      if (end == std::string::npos || end - i > 6) return "stray &";
      i = end + 1;
    } else if (text[i] == '>') {
      return "stray >";
    } else if (text[i] == '<') {
      const std::size_t end = text.find('>', i);
      if (end == std::string::npos) return "a tag is not closed";
      const std::string tag = text.substr(i + 1, end - i - 1);
      if (std::count(tag.begin(), tag.end(), '"') % 2 != 0) return "a quote is open: " + tag;
      if (tag.find('<') != std::string::npos) return "a tag in a tag: " + tag;
      const std::string name = tag.substr(0, tag.find(' '));
      if (name[0] == '/') {
        if (open.empty() || "/" + open.back() != name) return "closes what is not open: " + tag;
        open.pop_back();
      } else if (tag.back() != '/' && name[0] != '?') {
        open.push_back(name);
      }
      i = end + 1;
    } else {
      ++i;
    }
  }
  return open.empty() ? std::nullopt : std::optional("left open: " + open.back());
}

int Occurrences(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

const ConeModel kCone{.mouth_radius_m = 0.2,
                      .funnel_length_m = 0.25,
                      .throat_radius_m = 0.05,
                      .socket_end_m = 0.5,
                      .stop_depth_m = 0.45};

/// Columns of a campaign whose table has soils and start poses.
RowColumns GridColumns() {
  return {{"soil", "start.r_m", "start.alpha_deg", "start.heading_deg"}, Measures(), {}};
}

/// Runs 1..count on two soils; every third missed the cone.
std::vector<RunResult> FakeRows(int count) {
  std::vector<RunResult> rows;
  for (int i = 1; i <= count; ++i) {
    RunResult row;
    row.run = i;
    row.labels = {i % 2 ? "loose" : "compact", std::to_string(2 + i % 5),
                  std::to_string(3 * i % 40), "5"};
    row.docked = i % 3 != 0;
    row.outcome = row.docked ? "docked" : "missed_cone";
    rows.push_back(row);
  }
  return rows;
}

std::string Grid(const std::vector<RunResult>& rows, const std::string& title = "grid") {
  return GridPlot(title, GridColumns(), rows, kCone);
}

/// A run of two samples, a sighting and a plan.
RunRecord FakeRecord() {
  RunRecord record;
  record.result = FakeRows(1)[0];
  record.columns = GridColumns();
  record.channels = Channels();
  for (int i = 0; i < 5; ++i) {
    HistorySample sample;
    sample.time_s = 0.1 * i;
    sample.X_DR = {4.0 - 0.1 * i, 0.2, kPi};
    sample.channels.assign(record.channels.size(), 0.5 * i);
    sample.phase = i < 3 ? "approach" : "reel";
    record.history.push_back(sample);
  }
  SightingSample sighting;
  sighting.report.accepted = true;
  sighting.X_DR = sighting.X_DR_measured = {4.0, 0.2, kPi};
  record.sightings.push_back(sighting);
  record.plans.push_back({0.2, {{{4.0, 0.2, kPi}, 1.0, 0.3}}});
  return record;
}

/// The element of that class with its content, to the first </g>.
std::string GroupOf(const std::string& svg, const std::string& attribute) {
  const std::size_t start = svg.find("<g " + attribute);
  if (start == std::string::npos) return "";
  return svg.substr(start, svg.find("</g>", start) - start);
}

/// The numbers of the n-th occurrence of `name="..."`.
std::vector<double> Numbers(const std::string& svg, const std::string& name, int n = 0) {
  std::size_t at = 0;
  for (int i = 0; i <= n; ++i) at = svg.find(" " + name + "=\"", at) + name.size() + 3;
  std::string text = svg.substr(at, svg.find('"', at) - at);
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream in(text);
  return {std::istream_iterator<double>(in), {}};
}

/// Pixels per metre of a grid plot: two runs a metre apart on the axis.
struct GridScale {
  double px_per_m = 0.0, x0_px = 0.0, y0_px = 0.0;  // of the dock's origin
};
GridScale ScaleOf(const std::string& svg, const std::string& at_2m, const std::string& at_3m) {
  const std::string two = GroupOf(svg, at_2m), three = GroupOf(svg, at_3m);
  const double x2 = Numbers(two, "cx")[0], x3 = Numbers(three, "cx")[0];
  return {x3 - x2, x2 - 2.0 * (x3 - x2), Numbers(two, "cy")[0]};
}

/// Runs 1 and 2 on the cone's axis at 2 and 3 m, facing the dock; then the given one.
std::vector<RunResult> RowsForScale(double r_m, double alpha_deg, double heading_deg) {
  std::vector<RunResult> rows(3);
  for (int i = 0; i < 3; ++i) rows[static_cast<std::size_t>(i)].run = i + 1;
  rows[0].labels = {"loose", "2", "0", "0"};
  rows[1].labels = {"loose", "3", "0", "0"};
  rows[2].labels = {"loose", NumberText(r_m), NumberText(alpha_deg), NumberText(heading_deg)};
  return rows;
}
std::string RunGroup(int run) {
  return "class=\"run-arrow\" id=\"run-" + std::to_string(run) + "\"";
}

TEST(XmlFault, SeesFaults) {  // the checker itself
  EXPECT_FALSE(XmlFault("<a><b c=\"1\"/>x &amp; y</a>"));
  for (const char* bad : {"<a><b></a></b>", "<a>", "<a>&</a>", "<a b=\"></a>", "a > b"}) {
    EXPECT_TRUE(XmlFault(bad)) << bad;
  }
}

TEST(GridPlot, HasOneArrowPerRun) {
  const std::string svg = Grid(FakeRows(40));
  EXPECT_EQ(XmlFault(svg), std::nullopt);
  EXPECT_EQ(Occurrences(svg, "class=\"run-arrow\""), 40);
  EXPECT_EQ(Occurrences(svg, "id=\"run-40\""), 1);
}

TEST(GridPlot, NamesTheCauseOfEachFailureAndTheRate) {
  const std::string svg = Grid(FakeRows(9));
  EXPECT_EQ(Occurrences(svg, " missed_cone<"), 3);
  EXPECT_THAT(svg, HasSubstr("docked 6/9 (67 %, 30-93 %)"));
}

// Tsai et al., Fig. 7 and Eq. 1: alpha and heading count counter-clockwise from above; on the
// page x runs to the right and y upwards, while pixels count downwards.
TEST(GridPlot, PutsEachArrowAtItsStartAndPointsItAlongItsHeading) {
  for (const double alpha_deg : {30.0, -20.0}) {
    for (const double heading_deg : {0.0, 10.0, -40.0}) {
      const std::string svg = Grid(RowsForScale(2.5, alpha_deg, heading_deg));
      const GridScale scale = ScaleOf(svg, RunGroup(1), RunGroup(2));
      ASSERT_GT(scale.px_per_m, 20.0);
      const std::string arrow = GroupOf(svg, RunGroup(3));
      const double alpha = Radians(alpha_deg), heading = Radians(heading_deg);
      const double x_px = Numbers(arrow, "cx")[0], y_px = Numbers(arrow, "cy")[0];
      EXPECT_NEAR(x_px, scale.x0_px + scale.px_per_m * 2.5 * std::cos(alpha), 0.1);
      EXPECT_NEAR(y_px, scale.y0_px - scale.px_per_m * 2.5 * std::sin(alpha), 0.1);
      // h = 0 points into the station: along -x. The head's point is the polygon's first.
      const std::vector<double> head = Numbers(arrow, "points");
      ASSERT_GE(head.size(), 2u);
      const double length = std::hypot(head[0] - x_px, head[1] - y_px);
      EXPECT_GT(length, 20.0);
      EXPECT_NEAR((head[0] - x_px) / length, -std::cos(heading), 0.01);
      EXPECT_NEAR((head[1] - y_px) / length, std::sin(heading), 0.01);
    }
  }
}

TEST(GridPlot, DrawsTheConeThatItIsGiven) {
  const std::string svg = Grid(RowsForScale(2.5, 0.0, 0.0));
  const GridScale scale = ScaleOf(svg, RunGroup(1), RunGroup(2));
  const std::string cone = GroupOf(svg, "class=\"cone\"");
  const std::vector<double> px = Numbers(cone, "points");
  const double outline_m[6][2] = {{0, 0.2},      {-0.25, 0.05},  {-0.5, 0.05},
                                  {-0.5, -0.05}, {-0.25, -0.05}, {0, -0.2}};
  ASSERT_EQ(px.size(), 12u);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR((px[2 * i] - scale.x0_px) / scale.px_per_m, outline_m[i][0], 1e-3);
    EXPECT_NEAR((scale.y0_px - px[2 * i + 1]) / scale.px_per_m, outline_m[i][1], 1e-3);
  }
  EXPECT_NEAR((Numbers(cone, "x1")[0] - scale.x0_px) / scale.px_per_m, -0.45, 1e-3);
}

TEST(GridPlot, MarksEachSoilByItsLabelAndNamesItInTheKey) {
  std::vector<RunResult> rows = FakeRows(6);
  const char* soils[] = {"gravel", "GRC-1", "gravel", "a < b", "", "GRC-1"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].labels[0] = soils[i];
    rows[i].docked = true;
  }
  const std::string svg = Grid(rows);
  EXPECT_EQ(XmlFault(svg), std::nullopt);
  EXPECT_EQ(Occurrences(svg, "class=\"soil-key\""), 4);
  for (const char* label : {">gravel<", ">GRC-1<", ">a &lt; b<", ">-<"}) {
    EXPECT_THAT(svg, HasSubstr(label));
  }
  EXPECT_THAT(svg, Not(HasSubstr("compact")));
  // The marker without its place: its kind, fill and number of corners.
  const auto marker = [&](int run) {
    const std::string group = GroupOf(svg, RunGroup(run));
    const std::string last = group.substr(group.rfind('<'));
    const std::string kind = last.substr(0, last.find(' '));
    const std::string corners =
        kind == "<polygon" ? std::to_string(Numbers(last, "points").size()) : "";
    return kind + corners + last.substr(last.find(" fill="));
  };
  EXPECT_EQ(marker(1), marker(3));
  EXPECT_EQ(marker(2), marker(6));
  const std::set<std::string> kinds{marker(1), marker(2), marker(4), marker(5)};
  EXPECT_EQ(kinds.size(), 4u) << ::testing::PrintToString(kinds);
}

TEST(GridPlot, IsWellFormedWithoutRunsAndWithHostileText) {
  EXPECT_EQ(XmlFault(Grid({}, "a < b & \"c\"")), std::nullopt);
}

TEST(PathPlot, DrawsTheConeOfTheStationThatWasSimulated) {
  RunRecord record = FakeRecord();
  const std::vector<double> px =
      Numbers(GroupOf(PathPlot(record, kCone), "class=\"cone\""), "points");
  ASSERT_EQ(px.size(), 12u);
  const double mouth_px = px[11] - px[1], throat_px = px[9] - px[3], end_px = px[0] - px[4];
  EXPECT_NEAR(throat_px / mouth_px, 0.05 / 0.2, 1e-3);
  EXPECT_NEAR(end_px / mouth_px, 0.5 / 0.4, 1e-3);
}

TEST(PathPlot, IsWellFormedForAnyRecord) {
  RunRecord record = FakeRecord();
  EXPECT_EQ(XmlFault(PathPlot(record, kCone)), std::nullopt);
  EXPECT_EQ(XmlFault(PathPlot({}, kCone)), std::nullopt);
  record.history[3].X_DR.x = std::numeric_limits<double>::quiet_NaN();
  record.sightings[0].X_DR_measured.x = std::numeric_limits<double>::infinity();
  const std::string svg = PathPlot(record, kCone);
  EXPECT_EQ(XmlFault(svg), std::nullopt);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf\"")));
}

TEST(HistoryPlot, IsWellFormedForAnyRecord) {
  RunRecord record = FakeRecord();
  EXPECT_EQ(XmlFault(HistoryPlot(record)), std::nullopt);
  RunRecord empty;
  empty.channels = Channels();
  EXPECT_EQ(XmlFault(HistoryPlot(empty)), std::nullopt);
  record.history[3].channels[6] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(HistoryPlot(record), Not(HasSubstr("nan")));
}

TEST(ArcPoints, EndAQuarterTurnOnAtARadiusInAndOut) {
  const PlannedArc arc{{1.0, 2.0, 0.0}, kPi / 2 * 3.0, kPi / 2};  // radius 3 to the left
  const Eigen::Vector2d end = ArcPoints(arc, 10).back();
  EXPECT_NEAR(end.x(), 4.0, 1e-12);
  EXPECT_NEAR(end.y(), 5.0, 1e-12);
}

TEST(ArcPoints, RunBackwardsForANegativeLength) {
  const Eigen::Vector2d end = ArcPoints({{0.0, 0.0, 0.0}, -2.0, 0.0}, 4).back();
  EXPECT_NEAR(end.x(), -2.0, 1e-12);
}

TEST(Ticks, AreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(NiceStep(10.0, 10), 1.0);
  EXPECT_DOUBLE_EQ(NiceStep(7.3, 4), 2.0);
  EXPECT_DOUBLE_EQ(NiceStep(0.021, 5), 0.005);
  EXPECT_EQ(TickText(0.015, 0.005), "0.015");
  EXPECT_EQ(TickText(200.0, 50.0), "200");
}

}  // namespace
}  // namespace dockyard::axel
