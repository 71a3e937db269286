#include "sim/campaign/plots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

#include "campaign/fake_runs.h"
#include "sim/campaign/run_plots.h"
#include "sim/campaign/svg.h"

namespace dockyard {
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

std::vector<RunResult> FakeRows(int count) {
  std::vector<RunResult> rows;
  for (const CampaignRun& run : FakeCampaign(count).runs) rows.push_back(FakeRecord(run).result);
  return rows;
}

TEST(XmlFault, SeesFaults) {  // the checker itself
  EXPECT_FALSE(XmlFault("<a><b c=\"1\"/>x &amp; y</a>"));
  for (const char* bad : {"<a><b></a></b>", "<a>", "<a>&</a>", "<a b=\"></a>", "a > b"}) {
    EXPECT_TRUE(XmlFault(bad)) << bad;
  }
}

TEST(GridPlot, HasOneArrowPerRun) {
  const std::string svg = GridPlot("grid", FakeRows(40));
  EXPECT_EQ(XmlFault(svg), std::nullopt);
  EXPECT_EQ(Occurrences(svg, "class=\"run-arrow\""), 40);
  EXPECT_EQ(Occurrences(svg, "id=\"run-40\""), 1);
}

TEST(GridPlot, NamesTheCauseOfEachFailureAndTheRate) {
  const std::string svg = GridPlot("grid", FakeRows(9));
  EXPECT_EQ(Occurrences(svg, " missed_cone<"), 3);
  EXPECT_THAT(svg, HasSubstr("docked 6/9 (67 %, 30-93 %)"));
}

TEST(GridPlot, IsWellFormedWithoutRunsAndWithHostileText) {
  EXPECT_EQ(XmlFault(GridPlot("a < b & \"c\"", {})), std::nullopt);
}

TEST(PathPlot, IsWellFormedForAnyRecord) {
  RunRecord record = FakeRecord(FakeCampaign(1).runs[0]);
  EXPECT_EQ(XmlFault(PathPlot(record)), std::nullopt);
  EXPECT_EQ(XmlFault(PathPlot({})), std::nullopt);
  record.history[3].X_DR.x = std::numeric_limits<double>::quiet_NaN();
  record.sightings[0].X_DR_measured.x = std::numeric_limits<double>::infinity();
  const std::string svg = PathPlot(record);
  EXPECT_EQ(XmlFault(svg), std::nullopt);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf\"")));
}

TEST(HistoryPlot, IsWellFormedForAnyRecord) {
  RunRecord record = FakeRecord(FakeCampaign(1).runs[0]);
  EXPECT_EQ(XmlFault(HistoryPlot(record)), std::nullopt);
  EXPECT_EQ(XmlFault(HistoryPlot({})), std::nullopt);
  record.history[3].tension_n = std::numeric_limits<double>::quiet_NaN();
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
}  // namespace dockyard
