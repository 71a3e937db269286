#include "sim/report/sensitivity.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "sim/base/random.h"
#include "sim/base/text.h"
#include "statistics/correlations_of_columns.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Draws of numbers start.r_m, start.alpha_deg and idle, and of words soil.
Campaign Drawn() {
  Campaign campaign;
  for (const char* key : {"start.r_m", "start.alpha_deg", "soil", "idle"}) {
    Dispersion draw;
    draw.key.name = key;
    if (draw.key.name == "soil") {
      draw.values.labels = {"loose", "compact"};
      draw.values.values.resize(2);
    }
    campaign.dispersions.push_back(draw);
  }
  return campaign;
}

RowColumns Columns() {
  RowColumns columns = FakeColumns();
  columns.labels = {"start.r_m", "start.alpha_deg", "soil", "idle"};
  return columns;
}

/// Far, oblique and loose runs dock less often. Depth falls with the range alone; a run that does
/// not dock has no yaw error.
std::vector<RunResult> RowsOf(int count, std::uint64_t seed = 4) {
  RandomStream random(StreamKey(seed, "rows"));
  std::vector<RunResult> rows;
  for (int i = 0; i < count; ++i) {
    const double r = random.Uniform(1.0, 4.0), alpha = random.Uniform(-40.0, 40.0);
    const bool loose = random.Uniform() < 0.5;
    RunResult row;
    row.run = i + 1;
    row.labels = {NumberText(r), NumberText(alpha), loose ? "loose" : "compact",
                  NumberText(random.Uniform())};
    row.success = random.Uniform() < 1.4 - 0.2 * r - std::abs(alpha) / 60.0 - (loose ? 0.2 : 0.0);
    row.outcome = row.success ? "docked" : "missed";
    row.measures = {10.0 - r + 0.1 * random.Normal(), random.Normal(),
                    row.success ? random.Normal() : std::nan("")};
    rows.push_back(row);
  }
  return rows;
}

const DrawEffect& Effect(const Sensitivity& found, std::size_t measure, const std::string& label) {
  for (const DrawEffect& draw : found.measures[measure].draws) {
    if (draw.label == label) return draw;
  }
  throw std::runtime_error(label);
}

constexpr std::size_t kDocked = 0, kDepth = 2, kYaw = 4;

TEST(Sensitivity, FindsARelationOfAnyShape) {
  const auto found = FindSensitivity(Drawn(), Columns(), RowsOf(2000));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].runs, 2000);
  // The rate falls to both sides of alpha = 0: no rank correlation, but the largest eta.
  const DrawEffect& alpha = Effect(found[0], kDocked, "start.alpha_deg");
  EXPECT_EQ(found[0].measures[kDocked].draws[0].label, "start.alpha_deg");
  EXPECT_LT(alpha.rank_correlation.interval.low, 0.0);
  EXPECT_GT(alpha.rank_correlation.interval.high, 0.0);
  EXPECT_LT(alpha.p_value, 1e-6);
  const DrawEffect& range = Effect(found[0], kDocked, "start.r_m");
  EXPECT_LT(range.rank_correlation.interval.high, -0.2);
  EXPECT_LT(range.partial.value, range.rank_correlation.value);  // the others blur it
  EXPECT_LT(Effect(found[0], kDocked, "soil").p_value, 1e-6);
  EXPECT_LT(Effect(found[0], kDocked, "idle").eta, 0.06);
}

TEST(Sensitivity, HasTheCorrelationsOfTheColumns) {
  const auto rows = RowsOf(300);
  std::vector<double> r, depth, r_of_docked, yaw;
  for (const RunResult& row : rows) {
    r.push_back(*NumberFromText(row.labels[0]));
    depth.push_back(row.measures[0]);
    if (!row.success) continue;
    r_of_docked.push_back(r.back());
    yaw.push_back(row.measures[2]);
  }
  const auto found = FindSensitivity(Drawn(), Columns(), rows)[0];
  EXPECT_NEAR(Effect(found, kDepth, "start.r_m").rank_correlation.value, Spearman(r, depth).value,
              1e-12);
  EXPECT_EQ(found.measures[kYaw].runs, static_cast<int>(yaw.size()));
  EXPECT_NEAR(Effect(found, kYaw, "start.r_m").rank_correlation.value,
              Spearman(r_of_docked, yaw).value, 1e-12);
}

TEST(Sensitivity, GivesWordsTheirRatesAndNoRank) {
  const auto found = FindSensitivity(Drawn(), Columns(), RowsOf(400))[0];
  const DrawEffect& soil = Effect(found, kDocked, "soil");
  EXPECT_TRUE(soil.words);
  EXPECT_TRUE(std::isnan(soil.rank_correlation.value));
  EXPECT_TRUE(std::isnan(soil.partial.value));
  int docked = 0, runs = 0;
  for (const RunResult& row : RowsOf(400)) {
    docked += row.success && row.labels[2] == "compact";
    runs += row.labels[2] == "compact";
  }
  for (const LevelRate& rate : found.rates) {
    if (rate.word != "compact") continue;
    EXPECT_EQ(rate.successes, docked);
    EXPECT_EQ(rate.runs, runs);
  }
  EXPECT_THAT(SensitivityLevelsCsv({found}), HasSubstr("\n,soil,loose,,,"));
}

TEST(Sensitivity, CutsANumberIntoLevelsOfAsManyRuns) {
  const auto found = FindSensitivity(Drawn(), Columns(), RowsOf(400))[0];
  int levels = 0, runs = 0;
  double last = 0.0;
  for (const LevelRate& rate : found.rates) {
    if (rate.label != "start.r_m") continue;
    ++levels;
    runs += rate.runs;
    EXPECT_EQ(rate.runs, 40);
    EXPECT_GT(rate.low, last);
    last = rate.high;
  }
  EXPECT_EQ(levels, 10);
  EXPECT_EQ(runs, 400);
}

TEST(Sensitivity, KeepsArmsApart) {
  Campaign campaign = Drawn();
  campaign.arms = {{"ours", {}}, {"paper", {}}, {"absent", {}}};
  RowColumns columns = Columns();
  columns.labels.insert(columns.labels.begin(), "arm");
  std::vector<RunResult> rows = RowsOf(100);
  for (RunResult& row : rows)
    row.labels.insert(row.labels.begin(), row.run > 30 ? "paper" : "ours");
  const auto found = FindSensitivity(campaign, columns, rows);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].arm, "ours");
  EXPECT_EQ(found[0].runs, 30);
  EXPECT_EQ(found[1].runs, 70);
  EXPECT_THAT(SensitivityText(found), HasSubstr("arm paper, 70 runs"));
}

TEST(Sensitivity, LeavesOutRunsInWhichAKeyWasChangedAlone) {
  RowColumns columns = Columns();
  columns.labels.push_back("changed");
  std::vector<RunResult> rows = RowsOf(60);
  for (RunResult& row : rows) row.labels.push_back(row.run > 40 ? "changes.a" : "");
  EXPECT_EQ(FindSensitivity(Drawn(), columns, rows)[0].runs, 40);
}

TEST(Sensitivity, SaysThatItCannotTellWhereAllRunsDock) {
  std::vector<RunResult> rows = RowsOf(100);
  for (RunResult& row : rows) row.success = true;
  const auto found = FindSensitivity(Drawn(), Columns(), rows);
  EXPECT_TRUE(std::isnan(found[0].measures[kDocked].draws[0].eta));
  EXPECT_FALSE(std::isnan(found[0].measures[kDepth].draws[0].eta));
  EXPECT_THAT(SensitivityText(found), HasSubstr("success does not vary"));
  EXPECT_THAT(SensitivityPlot("all", found), IsEmpty());
  EXPECT_THAT(SensitivityCsv(found), HasSubstr("\n,success,start.r_m,numbers,100,,,,,,,,,\n"));
}

TEST(Sensitivity, TakesAnyNumberOfRuns) {
  for (const int count : {1, 2, 3, 4, 5, 9}) {
    std::vector<RunResult> rows = RowsOf(count);
    rows[0].measures.clear();  // crashed
    const auto found = FindSensitivity(Drawn(), Columns(), rows);
    EXPECT_THAT(SensitivityText(found), Not(IsEmpty()));
    EXPECT_THAT(SensitivityCsv(found), Not(HasSubstr("nan")));
    EXPECT_THAT(SensitivityPlot("few", found), Not(HasSubstr("nan")));
  }
  EXPECT_THAT(FindSensitivity(Drawn(), Columns(), {}), IsEmpty());
  EXPECT_THAT(FindSensitivity(Campaign{}, Columns(), RowsOf(5)), IsEmpty());
}

TEST(Sensitivity, ListsNothingBelowFiveRunsADraw) {
  const auto few = FindSensitivity(Drawn(), Columns(), RowsOf(19));
  EXPECT_THAT(SensitivityText(few), HasSubstr("warning: no list: 19 runs for 4 draws"));
  EXPECT_THAT(SensitivityText(few), Not(HasSubstr("eta")));
  EXPECT_THAT(SensitivityCsv(few), Not(HasSubstr("start.r_m")));
  EXPECT_THAT(SensitivityPlot("few", few), IsEmpty());
  const auto enough = FindSensitivity(Drawn(), Columns(), RowsOf(20));
  EXPECT_THAT(SensitivityText(enough), HasSubstr("p (Holm)"));
  EXPECT_THAT(SensitivityText(enough), Not(HasSubstr("warning")));
}

// Holm's method by hand, on the raw p of the same list.
TEST(Sensitivity, AdjustsItsChancesForTheNumberOfDraws) {
  const auto found = FindSensitivity(Drawn(), Columns(), RowsOf(100))[0];
  std::vector<std::pair<double, double>> chances;
  for (const DrawEffect& draw : found.measures[kDocked].draws) {
    chances.push_back({draw.p_value, draw.holm_p});
  }
  std::sort(chances.begin(), chances.end());
  double least = 0.0;
  for (std::size_t i = 0; i < chances.size(); ++i) {
    least = std::max(least, std::min(1.0, static_cast<double>(4 - i) * chances[i].first));
    EXPECT_NEAR(chances[i].second, least, 1e-15);
  }
  EXPECT_THAT(SensitivityCsv({found}), HasSubstr("eta_p,eta_p_holm,"));
}

TEST(Sensitivity, ShowsTheStrongestDrawsFirst) {
  const auto found = FindSensitivity(Drawn(), Columns(), RowsOf(2000));
  const std::string text = SensitivityText(found), plot = SensitivityPlot("drawn", found);
  for (const std::string& shown : {text, plot}) {
    EXPECT_LT(shown.find("start.alpha_deg"), shown.find("start.r_m"));
    EXPECT_LT(shown.find("start.r_m"), shown.find("idle"));
    EXPECT_THAT(shown, HasSubstr("compact "));
  }
  EXPECT_THAT(SensitivityCsv(found), HasSubstr("\n,yaw_error_deg,"));
}

}  // namespace
}  // namespace dockyard
