// Static figures: what stands where.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

#include "sim/report/run_plots.h"
#include "sim/report/starts_plot.h"
#include "sim/report/svg.h"
#include "support/xml_fault.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

int Occurrences(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

/// The group with its content, to the first </g>.
std::string GroupOf(const std::string& svg, const std::string& attributes) {
  const std::size_t start = svg.find("<g " + attributes);
  if (start == std::string::npos) return "";
  return svg.substr(start, svg.find("</g>", start) - start);
}

/// The numbers of the n-th occurrence of ` name="..."`.
std::vector<double> Numbers(const std::string& svg, const std::string& name, int n = 0) {
  std::size_t at = 0;
  for (int i = 0; i <= n; ++i) at = svg.find(" " + name + "=\"", at) + name.size() + 3;
  std::string text = svg.substr(at, svg.find('"', at) - at);
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream in(text);
  return {std::istream_iterator<double>(in), {}};
}

RunResult Row(int run, bool docked) {
  RunResult row;
  row.run = run;
  row.success = docked;
  row.outcome = docked ? "docked" : "missed_cone";
  return row;
}

std::string Start(int run) { return "class=\"start\" id=\"run-" + std::to_string(run) + "\""; }

TEST(XmlFault, SeesFaults) {  // the checker itself
  EXPECT_FALSE(XmlFault("<a><b c=\"1\"/>x &amp; y</a>"));
  for (const char* bad : {"<a><b></a></b>", "<a>", "<a>&</a>", "<a b=\"></a>", "a > b"}) {
    EXPECT_TRUE(XmlFault(bad)) << bad;
  }
}

// x runs to the right and y upwards on the page, while pixels count downwards.
TEST(StartsPlot, PutsEachStartAtItsPlaceAndPointsItAlongItsHeading) {
  for (const double heading : {0.0, 0.7, -2.0}) {
    const std::string svg = StartsPlot("grid", "docked", {Row(1, true), Row(2, true), Row(3, true)},
                                       {{2.0, 0.0, kPi}, {3.0, 0.0, kPi}, {2.5, 1.2, heading}});
    EXPECT_EQ(XmlFault(svg), std::nullopt);
    const std::string a = GroupOf(svg, Start(1)), b = GroupOf(svg, Start(2));
    const std::string c = GroupOf(svg, Start(3));
    const double per_m = Numbers(b, "cx")[0] - Numbers(a, "cx")[0];
    ASSERT_GT(per_m, 20.0);
    const double x = Numbers(c, "cx")[0], y = Numbers(c, "cy")[0];
    EXPECT_NEAR(x, Numbers(a, "cx")[0] + 0.5 * per_m, 0.1);
    EXPECT_NEAR(y, Numbers(a, "cy")[0] - 1.2 * per_m, 0.1);
    const double dx = Numbers(c, "x2")[0] - x, dy = Numbers(c, "y2")[0] - y;
    EXPECT_NEAR(dx / std::hypot(dx, dy), std::cos(heading), 0.01);
    EXPECT_NEAR(dy / std::hypot(dx, dy), -std::sin(heading), 0.01);
  }
}

TEST(StartsPlot, TellsTheRateAndEachFailureByMoreThanColour) {
  const std::string svg = StartsPlot("a < b & \"c\"", "docked", {Row(1, true), Row(2, false)},
                                     {{2.0, 0.0, kPi}, {3.0, 0.0, kPi}});
  EXPECT_EQ(XmlFault(svg), std::nullopt);
  EXPECT_THAT(svg, HasSubstr("docked 1/2"));
  EXPECT_THAT(svg, HasSubstr(">2 missed_cone<"));
  EXPECT_THAT(GroupOf(svg, Start(1)), HasSubstr("<circle"));
  EXPECT_THAT(GroupOf(svg, Start(2)), Not(HasSubstr("<circle")));
}

TEST(StartsPlot, CountsRunsThatStartAlikeAsOneStart) {
  const Pose2 place{2.0, 0.0, kPi}, other{2.0, 0.0, kPi - 0.2};
  const std::string svg =
      StartsPlot("repeats", "docked", {Row(1, true), Row(2, false), Row(3, false), Row(4, false)},
                 {place, place, place, other});
  EXPECT_EQ(Occurrences(svg, "class=\"start\""), 2);
  EXPECT_THAT(svg, HasSubstr(">2 of 3 failed<"));
  EXPECT_THAT(svg, HasSubstr(">4 missed_cone<"));
  EXPECT_THAT(GroupOf(svg, Start(1)), HasSubstr("<circle"));
}

TEST(StartsPlot, GrowsWithTheRunsAndNotWithTheirSquare) {
  const auto size_of = [](int count) {
    std::vector<RunResult> rows;
    std::vector<Pose2> starts;
    for (int i = 1; i <= count; ++i) {
      rows.push_back(Row(i, i % 2 == 0));
      starts.push_back({1.0 + i % 7, 1e-4 * i, kPi + 0.01 * (i % 100)});
    }
    return static_cast<double>(StartsPlot("many", "docked", rows, starts).size());
  };
  EXPECT_LT(size_of(20000), 2.5 * size_of(10000));
}

TEST(StartsPlot, IsWellFormedWithoutRunsAndWithWildStarts) {
  EXPECT_EQ(XmlFault(StartsPlot("none", "docked", {}, {})), std::nullopt);
  const double wild = std::numeric_limits<double>::quiet_NaN();
  const std::string svg = StartsPlot("wild", "docked", {Row(1, true), Row(2, true)},
                                     {{wild, 0.0, 0.0}, {1e300, 0.0, 0.0}});
  EXPECT_EQ(XmlFault(svg), std::nullopt);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

LoggedRun SomeRun() {
  LoggedRun run;
  for (int i = 0; i < 50; ++i) {
    run.times_s.push_back(0.1 * i);
    run.truth["x_m"].push_back(4.0 - 0.05 * i);
    run.truth["y_m"].push_back(0.2);
    run.truth["heading_rad"].push_back(kPi);
    run.truth["left_current_a"].push_back(0.01 * i);
    run.truth["right_current_a"].push_back(0.02 * i);
    run.truth["tension_n"].push_back(i == 20 ? 80.0 : 5.0);
  }
  run.belief = run.truth;
  run.belief["located"].assign(50, 1.0);
  run.notes = {{0.0, {"phase", "approach"}}, {2.5, {"phase", "reel_in"}}};
  run.plans = {{0.2, {{4.0, 0.2, kPi}, {3.0, 0.3, kPi}}}};
  SightingSample sighting{};
  sighting.report.accepted = true;
  sighting.X_DR = {4.0, 0.2, kPi};
  sighting.X_DR_measured = {4.02, 0.21, kPi};
  run.sightings = {sighting, {}};
  return run;
}

const std::vector<Column> kChannels{{"left_current_a", "A", ""},
                                    {"right_current_a", "A", ""},
                                    {"tension_n", "N", ""},
                                    {"unlogged_m", "m", ""}};

TEST(PathPlot, HasThePathsThePlansAndTheLooks) {
  const std::string svg = PathPlot("run 1: docked", SomeRun());
  EXPECT_EQ(XmlFault(svg), std::nullopt);
  EXPECT_THAT(svg, HasSubstr("run 1: docked"));
  const std::vector<double> truth = Numbers(GroupOf(svg, "class=\"truth\""), "points");
  ASSERT_GE(truth.size(), 4u);
  EXPECT_GT(truth.front(), truth[truth.size() - 2]);  // it drives from the right to the left
  EXPECT_EQ(Numbers(GroupOf(svg, "class=\"believed\""), "points"), truth);
  EXPECT_EQ(Numbers(GroupOf(svg, "class=\"plan\""), "points").size(), 4u);
  EXPECT_EQ(Occurrences(GroupOf(svg, "class=\"looks\""), "<polygon"), 2);
  EXPECT_EQ(XmlFault(PathPlot("bare", LoggedRun{})), std::nullopt);
}

TEST(PathPlot, LeavesOutWhatHasNoPlace) {
  LoggedRun run = SomeRun();
  run.truth["x_m"][3] = std::numeric_limits<double>::quiet_NaN();
  run.sightings[0].X_DR_measured.x = std::numeric_limits<double>::infinity();
  const std::string svg = PathPlot("wild", run);
  EXPECT_EQ(XmlFault(svg), std::nullopt);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf\"")));
}

TEST(HistoryPlot, PutsChannelsOfOneKindIntoOnePanel) {
  const std::string svg = HistoryPlot("run 1", SomeRun(), kChannels);
  EXPECT_EQ(XmlFault(svg), std::nullopt);
  EXPECT_EQ(Occurrences(svg, ">[A]<"), 1);
  EXPECT_EQ(Occurrences(svg, ">[N]<"), 1);
  EXPECT_EQ(Occurrences(svg, ">[m]<"), 0);
  for (const char* name : {">left_current_a<", ">right_current_a<", ">tension_n<"}) {
    EXPECT_EQ(Occurrences(svg, name), 1) << name;
  }
  EXPECT_THAT(svg, HasSubstr(">approach<"));
}

TEST(HistoryPlot, KeepsEveryPeakOfALongRun) {
  LoggedRun run;
  for (int i = 0; i < 100000; ++i) {
    run.times_s.push_back(0.1 * i);
    run.truth["tension_n"].push_back(i == 54321 ? 80.0 : 5.0);
  }
  const std::string svg = HistoryPlot("long", run, kChannels);
  EXPECT_LT(svg.size(), 100000u);
  const std::vector<double> points = Numbers(svg, "points", Occurrences(svg, "<polyline") - 1);
  double least = 1e9, greatest = -1e9;
  for (std::size_t i = 1; i < points.size(); i += 2) {
    least = std::min(least, points[i]);
    greatest = std::max(greatest, points[i]);
  }
  EXPECT_GT(greatest - least, 60.0);  // most of a panel's height
}

TEST(HistoryPlot, IsWellFormedWithoutSamplesAndWithNaN) {
  EXPECT_EQ(XmlFault(HistoryPlot("none", LoggedRun{}, kChannels)), std::nullopt);
  LoggedRun run = SomeRun();
  run.truth["tension_n"][7] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(HistoryPlot("gap", run, kChannels), Not(HasSubstr("nan")));
}

TEST(Ticks, AreOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(NiceStep(10.0, 10), 1.0);
  EXPECT_DOUBLE_EQ(NiceStep(7.3, 4), 2.0);
  EXPECT_DOUBLE_EQ(NiceStep(0.021, 5), 0.005);
  EXPECT_EQ(TickText(0.015, 0.005), "0.015");
  EXPECT_EQ(TickText(200.0, 50.0), "200");
}

}  // namespace
}  // namespace dockyard
