#include <gmock/gmock.h>

#include <cmath>

#include "plan/toy_campaign.h"
#include "sim/base/text.h"
#include "sim/scenario/key_path.h"
#include "statistics/correlations_of_columns.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kDraw = R"(draw:
  start.r_m: {uniform: {min: 2, max: 7}}
  start.alpha_deg: {normal: {mean: 0, std: 10, min: -40, max: 40}}
  changes.flag.mass_kg: {loguniform: {min: 1, max: 100}}
  light: {discrete: {values: [even, speckled], weights: [3, 1]}}
)";

class DrawFile : public testing::Test {
 protected:
  Campaign Load(const std::string& keys) const {
    return LoadAndCheck(folder_.Write("scenarios/d.yaml", "campaign: d\nbase: toy.yaml\n" + keys));
  }
  std::string Message(const std::string& keys) const {
    return MessageOf([&] { Load(keys); }, folder_);
  }
  /// The texts of a label by run.
  static std::vector<std::string> Texts(const Campaign& campaign, const std::string& label) {
    std::vector<std::string> texts;
    for (const CampaignRun& run : AllRuns(campaign)) {
      for (std::size_t i = 0; i < campaign.labels.size(); ++i) {
        if (campaign.labels[i] == label) texts.push_back(run.labels[i]);
      }
    }
    return texts;
  }
  ToyFolder folder_;
};

TEST_F(DrawFile, LabelsTellTheDrawsBitForBit) {
  const Campaign campaign = Load(std::string(kDraw) + "design: {runs: 50}\n");
  EXPECT_THAT(campaign.labels, ElementsAre("repeat", "start.r_m", "start.alpha_deg",
                                           "changes.flag.mass_kg", "light"));
  for (const CampaignRun& run : AllRuns(campaign)) {
    EXPECT_EQ(NumberFromText(run.labels[1]), run.scenario.start.on_plane().r);
    EXPECT_EQ(Radians(NumberFromText(run.labels[2]).value()), run.scenario.start.on_plane().alpha);
    EXPECT_EQ(FindPath(run.scenario.changes, "flag.mass_kg")->scalar, run.labels[3]);
    EXPECT_EQ(LightName(run.scenario.light), run.labels[4]);
  }
}

TEST_F(DrawFile, DrawsFollowTheirDistributions) {
  const Campaign campaign = Load(std::string(kDraw) + "design: {runs: 2000}\n");
  double sum = 0.0, below_ten = 0.0, even = 0.0;
  for (const std::string& text : Texts(campaign, "start.r_m")) sum += *NumberFromText(text);
  for (const std::string& text : Texts(campaign, "changes.flag.mass_kg")) {
    below_ten += *NumberFromText(text) < 10.0 ? 1.0 : 0.0;
  }
  for (const std::string& text : Texts(campaign, "light")) even += text == "even" ? 1.0 : 0.0;
  // Four standard errors of 2000 draws.
  EXPECT_NEAR(sum / 2000.0, 4.5, 4.0 * 5.0 / std::sqrt(12.0 * 2000.0));
  EXPECT_NEAR(below_ten / 2000.0, 0.5, 4.0 * 0.5 / std::sqrt(2000.0));
  EXPECT_NEAR(even / 2000.0, 0.75, 4.0 * std::sqrt(0.75 * 0.25 / 2000.0));
}

TEST_F(DrawFile, AnotherNumberOfRunsAnotherArmOrAnotherKeyShiftsNoDraw) {
  const std::vector<std::string> few =
      Texts(Load(std::string(kDraw) + "design: {runs: 5}\n"), "start.r_m");
  const std::vector<std::string> many =
      Texts(Load(std::string(kDraw) + "design: {runs: 9}\n"), "start.r_m");
  const std::vector<std::string> more_keys =
      Texts(Load("draw:\n  yard.undulation_rms_m: {uniform: {min: 0, max: 0.03}}\n" +
                 std::string(kDraw).substr(6) + "design: {runs: 5}\n"),
            "start.r_m");
  const std::vector<std::string> arms =
      Texts(Load(std::string(kDraw) +
                 "arms: {a: {controller: wave}, b: {controller: straight}}\ndesign: {runs: 5}\n"),
            "start.r_m");
  ASSERT_EQ(few.size(), 5u);
  ASSERT_EQ(arms.size(), 10u);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(many[i], few[i]);
    EXPECT_EQ(more_keys[i], few[i]);
    EXPECT_EQ(arms[2 * i], few[i]);
    EXPECT_EQ(arms[2 * i + 1], few[i]);
  }
}

TEST_F(DrawFile, LatinHypercubeTakesEachStratumOnce) {
  const Campaign campaign =
      Load(std::string(kDraw) + "design: {kind: latin_hypercube, runs: 20}\n");
  std::vector<int> hits(20);
  for (const std::string& text : Texts(campaign, "start.r_m")) {
    ++hits.at(static_cast<std::size_t>((*NumberFromText(text) - 2.0) / 5.0 * 20.0));
  }
  for (const int count : hits) EXPECT_EQ(count, 1);
}

TEST_F(DrawFile, CorrelatedKeysHaveTheirRankCorrelation) {
  const Campaign campaign =
      Load(std::string(kDraw) +
           "correlate: [{keys: [start.r_m, start.alpha_deg], rank: 0.6}]\ndesign: {runs: 2000}\n");
  std::vector<double> r, alpha;
  for (const std::string& text : Texts(campaign, "start.r_m")) r.push_back(*NumberFromText(text));
  for (const std::string& text : Texts(campaign, "start.alpha_deg")) {
    alpha.push_back(*NumberFromText(text));
  }
  EXPECT_NEAR(Spearman(r, alpha).value, 0.6, 0.06);
}

TEST_F(DrawFile, FaultsAreToldByPlaceAndPath) {
  EXPECT_EQ(Message("draw: {start.r_m: {uniform: {min: 7, max: 2}}}\n"),
            "scenarios/d.yaml:3:43: draw.start.r_m.uniform.max: expected a number above min, found "
            "'2'");
  EXPECT_THAT(Message("draw: {start.r_m: {normal: {mean: 4, std: 0}}}\n"),
              HasSubstr("draw.start.r_m.normal.std: expected a number > 0"));
  EXPECT_THAT(Message("draw: {start.r_m: {gauss: {mean: 4, std: 1}}}\n"),
              HasSubstr("draw.start.r_m.gauss: unknown key"));
  EXPECT_THAT(
      Message("draw: {start.r_m: {uniform: {min: 2, max: 3}, normal: {mean: 1, std: 1}}}\n"),
      HasSubstr("draw.start.r_m: expected one distribution"));
  EXPECT_THAT(Message("draw: {light: {discrete: {values: [even, speckled], weights: [1]}}}\n"),
              HasSubstr("weights"));
  EXPECT_THAT(Message(std::string(kDraw) + "correlate: [{keys: [start.r_m, light2], rank: 0.4}]\n"),
              HasSubstr("correlate[0].keys: expected a key of draw, found 'light2'"));
  EXPECT_THAT(Message(std::string(kDraw) + "vary: {start.r_m: [2, 3]}\n"),
              HasSubstr("start.r_m: expected a key that is not set by 'start.r_m' as well"));
}

// Each system states the numbers of its start: a campaign may draw those and no others.
TEST_F(DrawFile, KeysOfAStartAreThoseOfTheSystem) {
  EXPECT_EQ(Message("draw:\n  start.range_m: {uniform: {min: 2, max: 7}}\n"),
            "scenarios/d.yaml:4:3: start.range_m: unknown key, known are: r_m, alpha_deg, "
            "heading_deg");
  EXPECT_EQ(Message("draw:\n  start.up_m: {discrete: {values: [1, 2]}}\n"),
            "scenarios/d.yaml:4:3: start.up_m: unknown key, did you mean 'r_m'?");
  EXPECT_EQ(Message("vary:\n  start.range_m: [2, 3]\n"),
            "scenarios/d.yaml:4:3: start.range_m: unknown key, known are: r_m, alpha_deg, "
            "heading_deg");
}

TEST_F(DrawFile, KeysOfAStartOnThePlaneAreNotThoseOfOneInSpace) {
  KnownSystem diver{"diver", {"sinking"}, {}};
  diver.start = Start({{"range_m", "m", Between(1.0, 50.0), "from the cage"},
                       {"up_m", "m", Between(-10.0, 10.0), "above the cage"}},
                      [](const Start&) { return RobotPose(); });
  const std::vector<KnownSystem> divers{diver};
  folder_.Write("scenarios/dive.yaml",
                "name: dive\nsystem: diver\nstart: {range_m: 5, up_m: -2}\n");
  const auto load = [&](const std::string& draw) {
    const std::string file =
        folder_.Write("scenarios/d.yaml", "campaign: d\nbase: dive.yaml\ndraw:\n  " + draw);
    const auto measures = [](const std::string&) { return std::vector<std::string>{}; };
    Campaign campaign = LoadCampaign(file, {}, {divers, measures});
    CheckRuns(campaign, divers, {});
    return campaign;
  };
  const auto message = [&](const std::string& draw) {
    return MessageOf([&] { load(draw); }, folder_);
  };
  EXPECT_EQ(message("start.alpha_deg: {uniform: {min: 2, max: 7}}\n"),
            "scenarios/d.yaml:4:3: start.alpha_deg: unknown key, known are: range_m, up_m");
  EXPECT_THAT(message("start.up_m: {uniform: {min: 2, max: 12}}\n"),
              HasSubstr("d.yaml:4:3: start.up_m: expected a number from -10 to 10, found '1"));
  const Campaign campaign = load("start.up_m: {uniform: {min: 2, max: 7}}\ndesign: {runs: 5}\n");
  for (const CampaignRun& run : AllRuns(campaign, divers)) {
    EXPECT_EQ(NumberFromText(run.labels.back()), run.scenario.start.Value("up_m"));
    EXPECT_EQ(run.scenario.start.Value("range_m"), 5.0);
  }
}

// A run in the middle of the night must not be the first to find out.
TEST_F(DrawFile, EndsOfADistributionAreWithinTheKeysRange) {
  EXPECT_THAT(Message("draw: {start.r_m: {normal: {mean: 1, std: 0.2}}}\n"),
              HasSubstr("start.r_m: expected a number from 0.1 to 100, found '-0.40"));
  EXPECT_EQ(Message("draw: {start.r_m: {normal: {mean: 1, std: 0.2, min: 0.5, max: 2}}}\n"),
            "(no error)");
  EXPECT_THAT(Message("draw: {light: {discrete: {values: [even, dark]}}}\n"),
              HasSubstr("found 'dark'"));
}

}  // namespace
}  // namespace dockyard
