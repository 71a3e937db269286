#include "sim/campaign/campaign_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "sim/campaign/progress.h"
#include "sim/log/result_row.h"
#include "support/fake_campaign.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

std::string TakenOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const FolderTaken& error) {
    return error.what();
  }
  return "not taken";
}

void Open(const std::filesystem::path& dir, const Campaign& campaign,
          const std::string& identity = "") {
  const std::vector<KnownSystem> systems = FakeSystems();
  const CampaignFolder folder(dir, campaign, RunMaker(campaign, systems),
                              {FakeColumns(), ResolvedYaml(campaign, systems), identity});
}

TEST(CampaignFolder, IsRefusedToAnotherCampaign) {
  const TemporaryFolder dir;
  Open(dir.path(), FakeCampaign(3));
  EXPECT_THAT(TakenOf([&] { Open(dir.path(), FakeCampaign(4)); }),
              HasSubstr("holds another campaign (its resolved.yaml differs); choose another folder "
                        "with --out"));
}

TEST(CampaignFolder, IsRefusedToAnotherBuild) {
  const TemporaryFolder dir;
  Open(dir.path(), FakeCampaign(3), "program 1");
  EXPECT_THAT(TakenOf([&] { Open(dir.path(), FakeCampaign(3), "program 2"); }),
              HasSubstr("another build of the program, or with other files of models or "
                        "controllers"));
  EXPECT_EQ(TakenOf([&] { Open(dir.path(), FakeCampaign(3), "program 1"); }), "not taken");
}

TEST(CampaignFolder, OverwritesNothingThatIsNotItsOwn) {
  const TemporaryFolder dir;
  WriteText(dir.path() / "thesis.tex", "five years of work");
  EXPECT_THAT(TakenOf([&] { Open(dir.path(), FakeCampaign(3)); }),
              HasSubstr("is not empty and holds no campaign"));
}

TEST(CampaignFolder, BelongsToOneProgramAtATime) {
  const TemporaryFolder dir;
  const Campaign campaign = FakeCampaign(3);
  const std::vector<KnownSystem> systems = FakeSystems();
  const CampaignFolder first(dir.path(), campaign, RunMaker(campaign, systems),
                             {FakeColumns(), ResolvedYaml(campaign, systems), ""});
  EXPECT_THAT(TakenOf([&] { Open(dir.path(), FakeCampaign(3)); }),
              HasSubstr("another campaign is running in"));
}

TEST(CampaignFolder, RefusesRowsThatAreNotOfThisCampaign) {
  const TemporaryFolder dir;
  Open(dir.path(), FakeCampaign(3));
  FinishedRuns strange;
  strange[9].result = FakeRecord(FakeRuns(9)[8]).result;
  WriteText(dir.path() / "results.csv", ResultsCsv(strange, FakeColumns()));
  EXPECT_THROW(Open(dir.path(), FakeCampaign(3)), ResultsError);
}

TEST(CampaignFolder, ThatCannotBeMadeIsAnIoError) {
  EXPECT_THROW(Open("/proc/nothing/here", FakeCampaign(1)), IoError);
  const TemporaryFolder dir;
  WriteText(dir.path() / "file", "");
  EXPECT_THROW(Open(dir.path() / "file", FakeCampaign(1)), IoError);
}

TEST(CampaignFolder, RefusesResultsWithOtherColumns) {
  const TemporaryFolder dir;
  Open(dir.path(), FakeCampaign(3));
  RowColumns others = FakeColumns();
  others.measures.pop_back();
  WriteText(dir.path() / "results.csv", CsvHeader(others) + "\n");
  EXPECT_THROW(Open(dir.path(), FakeCampaign(3)), ResultsError);
}

TEST(Duration, IsToldInUnitsOneCanFeel) {
  EXPECT_EQ(DurationText(44.6), "45 s");
  EXPECT_EQ(DurationText(750.0), "12 min 30 s");
  EXPECT_EQ(DurationText(7500.0), "2 h 5 min");
}

}  // namespace
}  // namespace dockyard
