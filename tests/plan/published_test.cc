#include "sim/plan/published.h"

#include <gmock/gmock.h>

#include "support/bad_files.h"

namespace dockyard {
namespace {

const char* const kGood = R"(reproduction: yard
source: A paper
campaigns: [{name: grid, file: grid.yaml}]
counted: [docked]
rows:
  - {name: all, paper: [29, 40]}
  - {name: sand, where: {soil: loose}}
  - {name: inside, paper: [20, 24], where: {region: interior}}
total: all
judged: [inside]
failures: [{name: blind, cases: [{outcomes: [unseen]}]}]
sightings: {wrong_place_m: 0.3, wrong_heading_deg: 10, within_m: 0.25, errors: [{at_m: 1, r_m: 0.02}]}
measures: [{name: current, campaign: grid, measure: current_a, low: 0.5, high: 1}]
figures: [{file: fig, title: A run, shows: run, at_least: {recoveries: 1}, channels: [roll_deg]}]
choices: grid.yaml
)";

CampaignNames Names() {
  return {{"soil", "region"}, {"docked", "unseen"}, {"current_a", "recoveries"}, {"roll_deg"}};
}

class PublishedFile : public testing::Test {
 protected:
  PublishedFile() { folder_.Write("grid.yaml", "campaign: x\n"); }
  Published Load(const std::string& text) const {
    return LoadPublished(folder_.Write("p.yaml", text));
  }
  /// What is said of kGood with that replacement.
  std::string Refusal(const std::string& from, const std::string& to) const {
    const std::string text = Replaced(kGood, from, to);
    return MessageOf([&] { CheckPublished(Load(text), {Names()}); }, folder_);
  }
  ScratchFolder folder_;
};

TEST_F(PublishedFile, ReadsRowsAndWhatCounts) {
  const Published published = Load(kGood);
  EXPECT_NO_THROW(CheckPublished(published, {Names()}));
  EXPECT_EQ(published.total, 0u);
  EXPECT_EQ(published.judged, std::vector<std::size_t>{2});
  EXPECT_EQ(published.rows[2].paper->count, 20);
  EXPECT_FALSE(published.rows[1].paper);
  EXPECT_EQ(published.rows[1].where[0].texts, std::vector<std::string>{"loose"});
  EXPECT_NEAR(published.wrong_heading_rad, 0.1745329251994, 1e-12);
  EXPECT_EQ(published.figures[0].least, 1.0);
  EXPECT_EQ(published.choices_file, (folder_.path() / "grid.yaml").string());
}

TEST_F(PublishedFile, IsRefusedWithThePlaceOfItsFault) {
  EXPECT_EQ(Refusal("[29, 40]", "[41, 40]"),
            "p.yaml:6:24: rows[0].paper: expected [count, runs], whole numbers with count <= runs, "
            "found a list");
  EXPECT_EQ(Refusal("total: all", "total: sand"),
            "p.yaml:9:8: total: expected a row with a published count, found 'sand'");
  EXPECT_EQ(Refusal("judged: [inside]", "judged: [all]"),
            "p.yaml:10:10: judged[0]: expected each row once and no total, found 'all'");
  EXPECT_EQ(Refusal("judged: [inside]", "judged: [outside]"),
            "p.yaml:10:10: judged[0]: expected the name of a row, found 'outside'");
  EXPECT_EQ(Refusal("source:", "sorce:"), "p.yaml:2:1: sorce: unknown key, did you mean 'source'?");
  EXPECT_EQ(Refusal("name: grid", "name: figures"),
            "p.yaml:3:20: campaigns[0].name: expected a name of its own in small letters, digits "
            "and _, found 'figures'");
  EXPECT_EQ(Refusal("high: 1}", "high: 0.1}"),
            "p.yaml:13:80: measures[0].high: expected a number from low on, found '0.1'");
}

TEST_F(PublishedFile, NeedsBothEndsOfARange) {
  EXPECT_EQ(Refusal("low: 0.5, high: 1}", "low: 0.5}"),
            "p.yaml:13:69: measures[0].low: expected low and high, or neither, found '0.5'");
}

TEST_F(PublishedFile, HasRowsOfFurtherCampaignsWithTheRunsThatTheyNeed) {
  const std::string of_grid = "{soil: loose}, campaign: grid";
  const Published published = Load(Replaced(kGood, "{soil: loose}", of_grid + ", runs: 20"));
  ASSERT_TRUE(published.rows[1].campaign);
  EXPECT_EQ(published.rows[1].campaign->text, "grid");
  EXPECT_EQ(published.rows[1].runs, 20);
  EXPECT_THAT(Refusal("{soil: loose}", of_grid), testing::HasSubstr("runs"));
  EXPECT_THAT(Refusal("{soil: loose}", "{soil: loose}, runs: 3"),
              testing::HasSubstr("none without a campaign"));
  EXPECT_THAT(Refusal("{soil: loose}", "{soil: loose}, campaign: greed, runs: 3"),
              testing::HasSubstr("the name of a campaign of this file, found 'greed'"));
}

TEST_F(PublishedFile, SelectsFailuresByColumnsOfTheResults) {
  const std::string before = "cases: [{", by_column = before + "where: {recoveries: [1, 2.5]}, ";
  const Published published = Load(Replaced(kGood, before, by_column));
  EXPECT_NO_THROW(CheckPublished(published, {Names()}));
  const FailureCase& found = published.failures.at(0).cases.at(0);
  EXPECT_EQ(found.outcomes.size(), 1u);
  EXPECT_EQ(found.where.at(0).column.text, "recoveries");
  EXPECT_EQ(found.where.at(0).values, (std::vector<double>{1.0, 2.5}));
  EXPECT_EQ(Refusal(before, before + "where: {recovery: 1}, "),
            "p.yaml:11:43: failures[0].cases[0].where.recovery: expected a column of results.csv, "
            "found 'recovery'; nearest is 'recoveries'");
  EXPECT_EQ(Refusal(before, before + "where: {recoveries: some}, "),
            "p.yaml:11:43: failures[0].cases[0].where.recoveries: expected numbers of the column, "
            "found 'some'");
}

TEST_F(PublishedFile, HasRowsThatCountOutcomesOfTheirOwn) {
  const std::string inside = "where: {region: interior}";
  const Published published = Load(Replaced(kGood, inside, inside + ", outcomes: [docked]"));
  EXPECT_NO_THROW(CheckPublished(published, {Names()}));
  EXPECT_TRUE(published.rows[0].outcomes.empty());
  EXPECT_EQ(published.rows[2].outcomes.at(0).text, "docked");
  EXPECT_THAT(Refusal(inside, inside + ", outcomes: [docket]"),
              testing::HasSubstr("rows[2].outcomes[0]: expected an outcome of the system"));
}

TEST_F(PublishedFile, JudgesAClassOfFailuresOnlyByAPublishedCount) {
  const std::string before = "{name: blind, ";
  const Published published =
      Load(Replaced(kGood, before, before + "paper: [2, 25], judged: true, "));
  EXPECT_TRUE(published.failures.at(0).judged);
  EXPECT_FALSE(Load(kGood).failures.at(0).judged);
  EXPECT_EQ(
      Refusal(before, before + "judged: true, "),
      "p.yaml:11:34: failures[0].judged: expected the paper's count of a class that is judged, "
      "found 'true'");
}

TEST_F(PublishedFile, NamesTheOutcomesThatAreTrulySuccesses) {
  const std::string counted = "counted: [docked]";
  const Published published = Load(Replaced(kGood, counted, counted + "\nstrict: [docked]"));
  EXPECT_EQ(published.strict.at(0).text, "docked");
  EXPECT_TRUE(Load(kGood).strict.empty());
  EXPECT_THAT(Refusal(counted, counted + "\nstrict: [docket]"),
              testing::HasSubstr("strict[0]: expected an outcome of the system, found 'docket'"));
}

TEST_F(PublishedFile, MustSpeakOfWhatItsCampaignsHave) {
  EXPECT_EQ(Refusal("counted: [docked]", "counted: [docket]"),
            "p.yaml:4:11: counted[0]: expected an outcome of the system, found 'docket'; nearest "
            "is 'docked'");
  EXPECT_EQ(Refusal("{soil: loose}", "{soul: loose}"),
            "p.yaml:7:26: rows[1].where.soul: expected a label of the campaign, found 'soul'; "
            "nearest is 'soil'");
  EXPECT_EQ(Refusal("measure: current_a", "measure: length_m"),
            "p.yaml:13:53: measures[0].measure: expected a column of results.csv, found "
            "'length_m'");
  EXPECT_EQ(Refusal("campaign: grid", "campaign: reeling"),
            "p.yaml:13:38: measures[0].campaign: expected the name of a campaign of this file, "
            "found 'reeling'");
  EXPECT_EQ(Refusal("[roll_deg]", "[roll_rad]"),
            "p.yaml:14:87: figures[0].channels[0]: expected a channel of the history, found "
            "'roll_rad'; nearest is 'roll_deg'");
}

}  // namespace
}  // namespace dockyard
